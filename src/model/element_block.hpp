// All elements of one type in a model, seen from the analyses.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "base/label.hpp"
#include "base/sparse_matrix.hpp"
#include "base/stiffness_stage.hpp"
#include "model/node.hpp"

namespace moat {

enum class ElementKind { storey, bearing, gap, damper, other };

/// What an element is called, joins and reports.
struct ElementInfo {
  /// Unique in its model: "storey 1", "moat left".
  std::string name;
  /// Where its peaks are listed; elements with the same place share them ("moat"). Its name if empty.
  Label place{};
  ElementKind kind = ElementKind::other;
  /// Deformation = displacement of `second` - displacement of `first` - offset.
  NodeId first, second;
  double offset = 0.0;  ///< m
  /// Names under which deformation and force are reported; not reported where empty.
  Label deformation_quantity{}, force_quantity{};

  [[nodiscard]] const std::string& listed_under() const { return place.empty() ? name : place.text(); }
};

/// A look at the regimes of all elements at the end of a trial step.
struct RegimeScan {
  /// In: the margin at which a located step is meant to end, just beyond zero.
  double aim = 0.0;
  /// Smallest margin: how far the nearest element is from its next change of regime; negative: beyond it.
  double margin = std::numeric_limits<double>::infinity();
  /// True if a change was seen inside the step, even if all margins are positive again at its end.
  bool crossed = false;
  /// True if an element was beyond its margin inside the step and is not at its end: the margins at the end are not
  /// enough to judge the step.
  bool returned = false;
  /// Number of elements that changed.
  int crossings = 0;
  /// Fraction of the step at which the first margin is expected to reach the aim; 1 if none does.
  double fraction = 1.0;

  /// Takes in what was seen of other elements.
  void merge(const RegimeScan& other) {
    margin = std::min(margin, other.margin);
    crossed = crossed || other.crossed;
    returned = returned || other.returned;
    crossings += other.crossings;
    fraction = std::min(fraction, other.fraction);
  }
};

/// One change of regime that happened.
struct RegimeChange {
  std::size_t block = 0;    ///< index into Model::blocks()
  std::size_t element = 0;  ///< index in that block
  double time = 0.0;        ///< s
  double rate = 0.0;        ///< m/s, of the deformation at that time
  bool touched = false;     ///< a gap closed
  bool inside = false;      ///< of the last step, which went on; else at its end, where values may jump
};

/// Whether quantities may jump where these changes are reported; none are reported where the ground stops.
inline bool values_jump(std::span<const RegimeChange> changes) {
  return changes.empty() || !std::ranges::all_of(changes, &RegimeChange::inside);
}

/// Where the work done on an element went, J. Work is formed from forces and deformations, what was stored from the
/// law's potential, what was dissipated from the law's own dissipation: three independent numbers, so that their
/// difference is an error of the time integration and not zero by construction.
struct ElementEnergy {
  double work = 0.0;        ///< of the force on the deformation, by the WorkRule of every step
  double stored = 0.0;      ///< recoverable energy now less that at the start
  double dissipated = 0.0;  ///< integral of dissipation_rate, and what changes of regime released
  bool hysteretic = false;  ///< dissipates by sliding, whatever the speed; else viscous

  [[nodiscard]] double error() const { return work - stored - dissipated; }
};

/// Sums of the energy accounts of many elements.
struct EnergySums {
  double work = 0.0, stored = 0.0, error = 0.0;             // J
  double viscous = 0.0, hysteretic = 0.0, by_impact = 0.0;  // dissipated, J

  void add(ElementKind kind, const ElementEnergy& energy) {
    work += energy.work;
    stored += energy.stored;
    error += energy.error();
    (kind == ElementKind::gap ? by_impact : energy.hysteretic ? hysteretic : viscous) += energy.dissipated;
  }
};

/// A contact as a gap element sees it.
struct ContactView {
  bool touching = false;        ///< from touch until the gap opens, also while the force is zero
  double approach_speed = 0.0;  ///< m/s, at first touch; <= 0 if the bodies did not approach
  double expected_force = 0.0;  ///< N, of a free impact that lasts half a sine: pi m v0 / duration
};

/// How the work of a step is formed.
enum class WorkRule {
  /// Mean force times change of deformation: with average acceleration an identity with the kinetic energy.
  mean_force,
  /// Lobatto's rule with four points on the interpolant of the deformation, of order six: for steps of higher order.
  quadrature,
};

/// All elements of one type, in contiguous arrays. Analyses know elements only through this class;
/// one virtual call serves a whole block.
///
/// A block holds two vectors of states. evaluate() computes the trial states from the committed ones
/// and the given displacements, never the other way round; commit() makes the trial states the
/// committed ones. Dropping a trial step therefore needs no call at all, unless regimes were changed inside it
/// (undo_changes_inside).
///
/// Arrays of displacements, velocities and forces have one entry per degree of freedom and one more,
/// the last, for the ground.
class ElementBlock {
 public:
  virtual ~ElementBlock() = default;

  [[nodiscard]] virtual std::unique_ptr<ElementBlock> clone() const = 0;
  [[nodiscard]] virtual std::size_t size() const = 0;
  [[nodiscard]] virtual const ElementInfo& info(std::size_t element) const = 0;

  /// Adds the pairs of degrees of freedom that its elements couple.
  virtual void add_couplings(PatternBuilder& pattern) const = 0;
  /// Remembers where in the matrix its elements scatter to.
  virtual void find_slots(const SparseMatrix& matrix) = 0;
  /// Evaluation, assembly and commit run on up to `threads` >= 1 threads from now on, if there are enough elements to
  /// make it worth while. The numbers are the same to the last bit for any number of threads.
  virtual void use_threads(int threads, const SparseMatrix& matrix) = 0;

  /// Forces, tangents and trial states at trial displacements and velocities. Adds the internal forces to `force`
  /// unless that is null.
  virtual void evaluate(const double* displacement, const double* velocity, double* force) = 0;
  /// After evaluate(): the rates of its forces, from both tangents and the given accelerations. Adds them to
  /// `force_rate` unless that is null.
  virtual void evaluate_rates(const double* acceleration, double* force_rate) = 0;
  /// Adds displacement_weight * df/du + velocity_weight * df/dv of the last evaluate().
  virtual void add_tangent(double displacement_weight, double velocity_weight, double* values) const = 0;
  /// Whether df/du and df/dv never change: the block adds its tangent to a sum that is kept, not to every new one.
  [[nodiscard]] virtual bool constant_tangent() const { return false; }
  /// Whether df/du or df/dv of any element has changed since this was last asked.
  virtual bool take_tangent_change() = 0;
  /// Whether the stiffness of an element without located regimes jumped between the last commit and the last
  /// evaluate(), by more than a fifth: its force has a corner inside the step.
  [[nodiscard]] virtual bool has_corner() const { return false; }
  /// Adds the constant stiffness of a linear analysis.
  virtual void add_linear_stiffness(StiffnessStage stage, double* values) const = 0;

  /// The trial states of the last evaluate() become the committed ones, `step` seconds after the last commit.
  /// Adds the step to the energy account of every element, if they are kept; a step of 0 is the same instant again.
  virtual void commit(double step, WorkRule rule) = 0;

  /// Starts the energy account of every element at the committed state, which must be the last one evaluated. They are
  /// kept from then on; without them steps cost less.
  virtual void start_energy_account() = 0;
  /// Energy account of an element since then. Throws std::logic_error where none was started.
  [[nodiscard]] virtual ElementEnergy energy(std::size_t element) const = 0;
  /// The same for all elements together.
  virtual void add_energies(EnergySums& sums) const = 0;

  /// Results of the last evaluate(), one entry per element: m, m/s, N.
  [[nodiscard]] virtual std::span<const double> deformations() const = 0;
  [[nodiscard]] virtual std::span<const double> rates() const = 0;
  [[nodiscard]] virtual std::span<const double> forces() const = 0;
  /// Results of the last evaluate_rates(): rates of the rates above, m/s^2, and of the forces, N/s.
  [[nodiscard]] virtual std::span<const double> second_rates() const = 0;
  [[nodiscard]] virtual std::span<const double> force_rates() const = 0;
  /// Force at a fraction of the last committed step: the law itself, on the deformation and rate interpolated there.
  [[nodiscard]] virtual double force_inside(std::size_t element, double fraction) const = 0;

  /// Whether all forces are linear in displacement and velocity from one located change of regime to the next, not
  /// counting closed gaps: what add_tangent() adds is then constant, and an open gap adds nothing.
  [[nodiscard]] virtual bool linear_between_events() const { return false; }
  /// Whether elements of this type change regime at located instants (contacts do).
  [[nodiscard]] virtual bool has_regimes() const { return false; }
  /// Looks for changes between the committed state and the last evaluate(), `step` seconds later.
  virtual void scan_regimes(double step, RegimeScan& scan) const;
  /// Puts every element that is beyond its margin at the committed state into its next regime and lists it.
  virtual void change_regimes(std::size_t block_index, std::vector<RegimeChange>& changes);
  /// Puts elements that are beyond their margin at the last evaluate(), `step` seconds after the committed state, into
  /// their next regime from the interpolated instant on, and lists them, with times from the committed state: the step
  /// is solved again with the new regimes instead of ending there. Openings are left to open_gaps(): an opened gap has
  /// no force. False if a force would jump, which no step can cross; elements before that one stay changed until
  /// undo_changes_inside().
  virtual bool change_regimes_inside(double step, double aim, std::size_t block_index,
                                     std::vector<RegimeChange>& changes);
  /// Takes the changes inside the step being tried back.
  virtual void undo_changes_inside() {}
  /// After commit(): opens the gaps that opened inside the last step and lists them. Their forces are zero already.
  virtual void open_gaps(std::size_t block_index, std::vector<RegimeChange>& changes);
  /// How long one cycle of the fastest element that is in contact now lasts, s; infinite if none is.
  [[nodiscard]] virtual double shortest_contact() const { return std::numeric_limits<double>::infinity(); }
  [[nodiscard]] virtual ContactView contact(std::size_t element) const;
  /// Restitution that the element's law delivers in a free impact at this approach speed, m/s. NaN if the speed is not
  /// positive, and if the element is no contact.
  [[nodiscard]] virtual double delivered_restitution(std::size_t element, double approach_speed) const;
};

}  // namespace moat
