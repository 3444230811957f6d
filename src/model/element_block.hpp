// All elements of one type in a model.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/parameter.hpp"
#include "base/stiffness_stage.hpp"
#include "model/couplings.hpp"
#include "model/element_details.hpp"
#include "model/element_states.hpp"
#include "model/node.hpp"

namespace moat {

/// How an element is drawn.
enum class DrawnAs : std::uint8_t { nothing, storey, bearing, gap, other };

/// The name of an element, the nodes it joins and the quantities it reports.
struct ElementInfo {
  /// Unique in its model: "storey 1", "moat left".
  std::string name;
  /// Where its peaks are listed; elements with the same place share them ("moat"). Its name if empty.
  std::string place{};
  /// Deformation = displacement of `second` - displacement of `first` - offset, for elements between two nodes.
  NodeId first, second;
  /// Names under which deformation and force are reported; not reported where empty.
  std::string deformation_quantity{}, force_quantity{};
  /// Whether it carries a building on the ground and lets it move: characteristic periods hold the floor above it.
  bool isolates = false;
  DrawnAs drawn_as = DrawnAs::other;  ///< in pictures and in ParaView
  double offset = 0.0;                ///< m, of the deformation
  /// Null where it has none.
  std::shared_ptr<const ElementDetails> details{};

  /// The nodes at its first end and at its second: one each, or two at a point between nodes.
  [[nodiscard]] std::array<std::vector<NodeId>, 2> ends() const {
    std::array<std::vector<NodeId>, 2> nodes{std::vector{first}, std::vector{second}};
    if (const MemberEnds* between = member_ends()) {
      if (!between->first.is_node()) nodes[0].push_back(between->first.other);
      if (!between->second.is_node()) nodes[1].push_back(between->second.other);
    }
    return nodes;
  }
  /// Name under which its peaks are listed.
  [[nodiscard]] const std::string& listed_under() const { return place.empty() ? name : place; }
  /// Null where it has none of these details.
  [[nodiscard]] const LawAsGiven* law_as_given() const { return detail(&ElementDetails::law_as_given); }
  /// Null where the element has none.
  [[nodiscard]] const MemberEnds* member_ends() const { return detail(&ElementDetails::member_ends); }
  /// Null where the element has none.
  [[nodiscard]] const PlanPlaces* plan_places() const { return detail(&ElementDetails::plan_places); }
  /// Null where the element has none.
  [[nodiscard]] const CornerPair* corner_pair() const { return detail(&ElementDetails::corner_pair); }

  /// Null where the element has none.
  [[nodiscard]] const std::vector<NodeId>* joined() const { return detail(&ElementDetails::joined); }

  /// Whether its deformation and force have two components: a bearing in plan.
  [[nodiscard]] bool acts_in_two_directions() const {
    return plan_places() != nullptr && plan_places()->direction == PlanVector{};
  }

  /// One of the details; null where it has none.
  template <class Detail>
  [[nodiscard]] const Detail* detail(std::optional<Detail> ElementDetails::*which) const {
    return details && (*details).*which ? &*((*details).*which) : nullptr;
  }
};

/// Facts that all elements of a block have in common.
struct BlockKind {
  /// Whether df/du and df/dv never change, and are symmetric. An analysis then assembles them once.
  bool constant_tangent = false;
  /// Whether all forces are linear in displacement and velocity from one located change of regime to the next, not
  /// counting closed gaps: add_tangent() then adds constants, and an open gap adds nothing.
  bool linear_between_events = false;
  bool has_regimes = false;  ///< whether elements change their regime at located instants
  bool contacts = false;     ///< whether elements touch and separate
};

/// All elements of one type in a model, as they were added. Analyses know elements only through this class and
/// ElementStates; one virtual call serves a whole block. `LinkBlock` (elements/block/link_block.hpp) makes a block of
/// any law.
class ElementBlock {
 public:
  virtual ~ElementBlock() = default;

  /// A copy of all elements.
  [[nodiscard]] virtual std::unique_ptr<ElementBlock> clone() const = 0;
  /// Returns the elements as they were added; they do not move when elements are added.
  [[nodiscard]] virtual const std::deque<ElementInfo>& infos() const = 0;
  /// The facts that its elements have in common.
  [[nodiscard]] virtual BlockKind kind() const = 0;
  /// Name and parameters of the law of an element.
  [[nodiscard]] virtual LawAsGiven law_of_block(std::size_t element) const = 0;
  /// Quantities that its law reports besides deformation and force.
  [[nodiscard]] virtual std::span<const ReportedQuantity> quantities(std::size_t element) const = 0;
  /// Returns the stiffness for a linear analysis, N/m; a bearing in plan has it in all directions alike.
  [[nodiscard]] virtual double linear_stiffness(std::size_t element, StiffnessStage stage) const = 0;
  /// Restitution that the law of a contact delivers in a free impact at this approach speed, m/s. NaN if the speed is
  /// not positive, for a law whose contact never ends, and for elements that are no contacts.
  [[nodiscard]] virtual double delivered_restitution(std::size_t element, double approach_speed) const = 0;

  /// Adds the pairs of degrees of freedom that its elements couple.
  virtual void add_couplings(Couplings& couplings) const = 0;
  /// Adds a stiffness, N/m, between the ends of an element.
  virtual void add_stiffness(std::size_t element, double stiffness, SparseMatrix& matrix) const = 0;
  /// The states of its elements at rest, for matrices with the entries of this one. The block must outlive them, and
  /// nothing be added to it meanwhile.
  [[nodiscard]] virtual std::unique_ptr<ElementStates> make_states(const SparseMatrix& matrix) const = 0;

  /// Number of elements.
  [[nodiscard]] std::size_t size() const { return infos().size(); }
  /// Returns the element as it was added.
  [[nodiscard]] const ElementInfo& info(std::size_t element) const { return infos()[element]; }
  /// The law of an element as a report names it: as the script gave it, else as its block names it.
  [[nodiscard]] LawAsGiven law(std::size_t element) const {
    const LawAsGiven* given = info(element).law_as_given();
    return given != nullptr ? *given : law_of_block(element);
  }
};

}  // namespace moat
