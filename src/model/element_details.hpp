// Facts that few elements have.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "base/parameter.hpp"
#include "base/plan_vector.hpp"
#include "model/node.hpp"
#include "model/weight/axial_forces.hpp"

namespace moat {

class ElementBlock;
struct ContactChange;

/// Name and parameters of a law, for reports.
struct LawAsGiven {
  std::string name;                   ///< as the script calls it
  std::vector<Parameter> parameters;  ///< in SI units
};

/// Where a spring in plan is attached to its bodies at rest.
struct PlanPlaces {
  PlanVector first{}, second{};  ///< as ElementInfo::first and second, m
  PlanVector direction{};        ///< of length 1, along its force; zero for one that acts in both directions

  friend bool operator==(const PlanPlaces&, const PlanPlaces&) = default;
};

/// A corner of one body and an edge of another.
///
///        edge  |
///              |     normal: from the body of the corner to the other body
///     corner > |-->  tangent: the normal turned by +90 degrees
///              |
struct CornerPair {
  std::string corner, edge;             ///< names, for tables: "base corner 2", "moat wall 3"
  PlanVector position{};                ///< of the corner at rest, m
  PlanVector edge_begin{}, edge_end{};  ///< at rest, m; the corner is on the left of the way between them
  PlanVector normal{};                  ///< of length 1
  double distance_at_rest = 0.0;        ///< of the corner from the edge, m; from the nearer end where it is beside it
  /// Whether a corner that slides could be pressed into its edge without an end: 1/m_n <= mu |m_nt|, with the mobility
  /// m_nt of normal motion under a force along the tangent. No law can separate them then.
  bool may_jam = false;
};

/// The ends of an element that is attached between nodes, and where it is drawn.
struct MemberEnds {
  MemberPoint first, second;  ///< as ElementInfo::first and second
  double height = 0.0;        ///< m, of drawings

  friend bool operator==(const MemberEnds&, const MemberEnds&) = default;
};

/// The parameters of a contact that can be changed, or of soil behind a wall (model/with_contacts.hpp).
struct ChangeableContact {
  std::string law{};                    ///< Name of its law; empty of soil.
  bool has_stiffness = false;           ///< Whether its law has one.
  std::optional<double> restitution{};  ///< As its law states it; an elastic law has none.
  /// Changes the element in its block. The contact made of a law does not show its restitution, so that the law itself
  /// is kept in this function. Throws InputError where the law refuses a changed parameter.
  std::function<void(ElementBlock&, std::size_t element, const ContactChange&)> change{};
};

/// Facts that few elements have, and that many may have in common.
struct ElementDetails {
  /// The law as the script gave it; none where it is the block's law.
  std::optional<LawAsGiven> law_as_given{};
  /// None for an element between two nodes; else its nodes are those where the shares of its ends are 0.
  std::optional<MemberEnds> member_ends{};
  /// None on a line, and for an element that has no such ends.
  std::optional<PlanPlaces> plan_places{};
  /// None but for contacts of corners with edges.
  std::optional<CornerPair> corner_pair{};
  /// All degrees of freedom of an element that joins more than two; without the ground.
  std::optional<std::vector<NodeId>> joined{};
  /// None but for isolators whose weight is known.
  std::optional<BearingOnSlab> bearing_on_slab{};
  /// None but for gaps and soil behind walls.
  std::optional<ChangeableContact> changeable_contact{};
};

}  // namespace moat
