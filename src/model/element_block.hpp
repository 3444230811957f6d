// All elements of one type in a model, seen from the analyses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/copyable_pointer.hpp"
#include "base/plan_vector.hpp"
#include "base/stiffness_stage.hpp"
#include "model/contacts.hpp"
#include "model/couplings.hpp"
#include "model/element_laws.hpp"
#include "model/energy_accounts.hpp"
#include "model/member_point.hpp"
#include "model/node.hpp"
#include "model/plan_contacts.hpp"
#include "model/plan_places.hpp"
#include "model/planar_elements.hpp"
#include "model/regimes.hpp"

namespace moat {

/// How an element is drawn.
enum class DrawnAs : std::uint8_t { nothing, storey, bearing, gap, other };

/// Facts that few elements have, and that many may have in common.
struct ElementDetails {
  /// The law as the script gave it; none where it is the block's law.
  std::optional<LawAsGiven> law_as_given{};
  /// None for an element between two nodes; else its nodes are those where the shares of its ends are 0.
  std::optional<MemberEnds> member_ends{};
  /// None on a line, and for an element that has no such ends.
  std::optional<PlanPlaces> plan_places{};

  friend bool operator==(const ElementDetails&, const ElementDetails&) = default;
};

/// Corners of forces inside a step that are not located.
struct UnlocatedCorners {
  bool jump = false;  ///< the stiffness of an element jumped by more than a fifth
  bool turn = false;  ///< the path of an element turns
};

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
  /// Null where it has none. Elements added one after the other share equal ones.
  std::shared_ptr<const ElementDetails> details{};

  /// Name under which its peaks are listed.
  [[nodiscard]] const std::string& listed_under() const { return place.empty() ? name : place; }
  /// Null where it has none of these details.
  [[nodiscard]] const LawAsGiven* law_as_given() const { return detail(&ElementDetails::law_as_given); }
  [[nodiscard]] const MemberEnds* member_ends() const { return detail(&ElementDetails::member_ends); }  ///< As the law.
  [[nodiscard]] const PlanPlaces* plan_places() const { return detail(&ElementDetails::plan_places); }  ///< As the law.

  /// One of the details; null where it has none.
  template <class Detail>
  [[nodiscard]] const Detail* detail(std::optional<Detail> ElementDetails::*which) const {
    return details && (*details).*which ? &*((*details).*which) : nullptr;
  }
};

/// Results of the elements of a block, one entry per element.
struct ElementResults {
  std::span<const double> deformations;  ///< of the last evaluate(), m
  std::span<const double> rates;         ///< of deformations, m/s
  std::span<const double> forces;        ///< of the last evaluate(), N
  std::span<const double> force_rates;   ///< of the last evaluate_rates(), N/s
};

/// All elements of one type, in contiguous arrays. Analyses know elements only through this class; one virtual call
/// serves a whole block.
///
/// A block holds two vectors of states. evaluate() computes the trial states from the committed ones and the given
/// displacements, and never changes the committed ones; commit() makes the trial states the committed ones. Dropping a
/// trial step therefore needs no call at all, unless regimes were changed inside it (Regimes::undo_changes_inside).
///
/// Arrays of displacements, velocities and forces have one entry per degree of freedom and one more, the last, for the
/// ground.
///
/// Functions with a body here are optional. The sides that only some blocks have are interfaces of their own: laws(),
/// regimes(), contacts(), planar(), plan_contacts(). `LinkBlock` (elements/line/link_block.hpp) makes a block of any
/// law.
class ElementBlock {
 public:
  virtual ~ElementBlock() = default;

  /// A copy of all elements with their states.
  [[nodiscard]] virtual std::unique_ptr<ElementBlock> clone() const = 0;
  /// Number of elements.
  [[nodiscard]] virtual std::size_t size() const = 0;
  /// As it was added.
  [[nodiscard]] virtual const ElementInfo& info(std::size_t element) const = 0;

  /// Adds the pairs of degrees of freedom that its elements couple.
  virtual void add_couplings(Couplings& couplings) const = 0;
  /// Keeps the positions among the values of this matrix, and of others with the same entries, to which its elements
  /// add.
  virtual void find_slots(const SparseMatrix& matrix) = 0;

  /// Called before evaluate() with the time from the committed state to the trial state, s; 0 is the committed instant
  /// again. For laws that evolve in time.
  virtual void begin_step(double) {}
  /// Forces, tangents and trial states at trial displacements and velocities. Adds the internal forces to `force`
  /// unless that is null.
  virtual void evaluate(const double* displacement, const double* velocity, double* force) = 0;
  /// After evaluate(): the rates of its forces, from both tangents and the given accelerations. Adds them to
  /// `force_rate` unless that is null.
  virtual void evaluate_rates(const double* acceleration, double* force_rate) = 0;
  /// Adds displacement_weight * df/du + velocity_weight * df/dv of the last evaluate().
  virtual void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const = 0;
  /// Adds the constant stiffness of a linear analysis.
  virtual void add_linear_stiffness(StiffnessStage stage, SparseMatrix& matrix) const = 0;
  /// Whether df/du and df/dv never change, and are symmetric. The model then assembles them once.
  [[nodiscard]] virtual bool constant_tangent() const { return false; }
  /// Whether df/du or df/dv of any element has changed since the last call.
  virtual bool take_tangent_change() { return !constant_tangent(); }
  /// Notes the corners that forces of elements without located regimes have between the last commit and the last
  /// evaluate(). Such laws see the ends of a step alone. The forces that they lose where their path turns inside it are
  /// added to `lost`, N.
  virtual void find_corners(UnlocatedCorners& /*corners*/, double* /*lost*/) const {}
  /// Whether all forces are linear in displacement and velocity from one located change of regime to the next, not
  /// counting closed gaps: add_tangent() then adds constants, and an open gap adds nothing.
  [[nodiscard]] virtual bool linear_between_events() const { return false; }

  /// The trial states of the last evaluate() become the committed ones, `step` seconds after the last commit.
  /// Adds the step to the energy account of every element, if they are kept; a step of 0 is the same instant again.
  virtual void commit(double step, WorkRule rule) = 0;

  /// Starts the energy account of every element at the committed state, which must be the last one evaluated. They are
  /// kept from then on; without them steps cost less.
  virtual void start_energy_accounts() = 0;
  /// Energy account of an element since then. Throws std::logic_error where none was started.
  [[nodiscard]] virtual ElementEnergy energy(std::size_t element) const = 0;
  /// Adds those of all elements.
  virtual void add_energies(EnergySums& sums) const {
    for (std::size_t e = 0; e < size(); ++e) sums.add(contacts() != nullptr, energy(e));
  }

  /// Views that stay valid until elements are added.
  [[nodiscard]] virtual ElementResults results() const = 0;

  /// The side of a block that names its laws and their own quantities; null without.
  [[nodiscard]] virtual const ElementLaws* laws() const { return nullptr; }
  /// The side of a block whose elements change their regime at located instants; null without.
  [[nodiscard]] virtual Regimes* regimes() { return nullptr; }
  /// The side of a block whose elements change their regime at located instants; null without.
  [[nodiscard]] virtual const Regimes* regimes() const { return nullptr; }
  /// The side of a block whose elements are contacts; null without.
  [[nodiscard]] virtual Contacts* contacts() { return nullptr; }
  /// The side of a block whose elements are contacts; null without.
  [[nodiscard]] virtual const Contacts* contacts() const { return nullptr; }
  /// The side of a block whose elements deform in two directions at once; null without.
  [[nodiscard]] virtual const PlanarElements* planar() const { return nullptr; }
  /// The side of a block whose contacts slide along walls; null without.
  [[nodiscard]] virtual const PlanContacts* plan_contacts() const { return nullptr; }
};

/// The law of an element as a report names it: as the script gave it, else as its block names it.
[[nodiscard]] inline LawAsGiven law_of(const ElementBlock& block, std::size_t element) {
  if (const LawAsGiven* given = block.info(element).law_as_given()) return *given;
  if (const ElementLaws* laws = block.laws()) return {laws->law_name(element), laws->parameters(element)};
  return {"law of the script", {}};
}

}  // namespace moat
