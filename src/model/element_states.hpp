// The states of all elements of one type in an analysis.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "base/parameter.hpp"
#include "base/plan_vector.hpp"
#include "base/sparse_matrix.hpp"
#include "base/state_archive.hpp"

namespace moat {

/// Results of elements with deformations and forces of one component, or of two.
template <class Value>
struct ResultsOf {
  std::span<const Value> deformations;  ///< of the last evaluate(), m
  std::span<const Value> rates;         ///< of deformations, m/s
  std::span<const Value> forces;        ///< of the last evaluate(), N
  std::span<const Value> force_rates;   ///< of the last evaluate_rates(), N/s
};

/// Results of one element; of one that deforms in two directions the resultants.
struct ElementResult {
  double deformation = 0.0, rate = 0.0;  ///< m, m/s
  double force = 0.0, force_rate = 0.0;  ///< N, N/s
};

/// Results of the elements of a block, with one entry per element in one of the two.
struct ElementResults {
  ResultsOf<double> line{};      ///< of elements with one component
  ResultsOf<PlanVector> plan{};  ///< of elements that deform in two directions at once: bearings in plan

  /// Returns the results of one element.
  [[nodiscard]] ElementResult operator[](std::size_t element) const {
    if (plan.forces.empty())
      return {line.deformations[element], line.rates[element], line.forces[element], line.force_rates[element]};
    const auto size = [](PlanVector vector) { return std::sqrt(dot(vector, vector)); };
    const auto rate = [](PlanVector vector, PlanVector its_rate, double its_size) {
      return its_size > 0.0 ? dot(vector, its_rate) / its_size : 0.0;
    };
    const double deformation = size(plan.deformations[element]), force = size(plan.forces[element]);
    return {deformation, rate(plan.deformations[element], plan.rates[element], deformation), force,
            rate(plan.forces[element], plan.force_rates[element], force)};
  }
};

/// Work, stored and dissipated energy of an element, J. Work is formed from forces and deformations, the stored energy
/// from the law's potential, the dissipated from the law's own dissipation: three independent numbers, so that their
/// difference is an error of the time integration and not zero by construction.
struct ElementEnergy {
  double work = 0.0;        ///< of the force on the deformation, by the WorkRule of every step
  double stored = 0.0;      ///< recoverable energy now less that at the start
  double dissipated = 0.0;  ///< integral of dissipation_rate, and the energy that changes of regime released
  bool hysteretic = false;  ///< dissipates by sliding, at any speed; else viscous
  double friction = 0.0;    ///< dissipated by friction in a contact, in addition
  /// A changing axial force stores this without work: the integral of (deformation^2)/(2 R) dN, or of
  /// (deformation^2)/2 dk where it changes a stiffness k.
  double weight_work = 0.0;

  /// Work that is neither stored nor dissipated.
  [[nodiscard]] double error() const { return work + weight_work - stored - dissipated - friction; }
};

/// Sums over many elements, J.
struct EnergySums {
  double work = 0.0, stored = 0.0, error = 0.0, weight_work = 0.0;             ///< sums of those of the elements
  double viscous = 0.0, hysteretic = 0.0, by_impact = 0.0, by_friction = 0.0;  ///< dissipated

  /// Adds those of one element.
  void add(bool is_contact, const ElementEnergy& energy) {
    work += energy.work;
    stored += energy.stored;
    error += energy.error();
    weight_work += energy.weight_work;
    by_friction += energy.friction;
    (is_contact ? by_impact : energy.hysteretic ? hysteretic : viscous) += energy.dissipated;
  }
};

/// The axial forces on the elements of a block, with one entry per element.
struct AxialActions {
  std::span<double> compressions, rates;  ///< N, N/s
};

/// How the work of a step is formed.
enum class WorkRule {
  /// Mean force times change of deformation: with average acceleration an identity with the kinetic energy.
  mean_force,
  /// Lobatto's rule with four points on the interpolant of the deformation, of order six: for steps of higher order.
  quadrature,
};

/// The state of one contact.
struct ContactView {
  bool touching = false;        ///< from touch until the gap opens, also while the force is zero
  double approach_speed = 0.0;  ///< m/s, at the last touch; <= 0 if the bodies did not approach
  double expected_force = 0.0;  ///< N, of a free impact that lasts half a sine: pi m v0 / duration
  /// Between the two sides at the last evaluate(), m, and its rate, m/s; of a corner beside its edge from the nearer
  /// end. Negative while they are indented.
  double distance = 0.0, distance_rate = 0.0;

  /// Where a corner slides along an edge: friction force along the tangent on the body of the edge, N, and its rate.
  double friction_force = 0.0, friction_force_rate = 0.0;
  /// Where in the last committed step the corner began to slide, so that rates jumped there: a fraction of the step,
  /// NaN where it did not.
  double slide_begin = std::numeric_limits<double>::quiet_NaN();
  /// Speed of the corner along the tangent at the last touch, relative to the edge, m/s.
  double tangential_speed_at_touch = 0.0;
  /// How often the corner left its edge in contact: it slid past an end, so that the contact was released.
  int departures = 0;
};

/// Corners of forces inside a step that are not located.
struct UnlocatedCorners {
  bool jump = false;  ///< the stiffness of an element jumped by more than a fifth
  bool turn = false;  ///< the path of an element turns
};

/// The regimes of all elements at the end of a trial step. A margin is a length in m that is positive while the
/// committed regime lasts and falls below zero beyond it.
struct RegimeScan {
  /// Smallest margin, m: how far the nearest element is from its next change of regime; negative: beyond it.
  double margin = std::numeric_limits<double>::infinity();
  /// True if an element crossed its margin inside the step, also if all margins are positive again at its end.
  bool crossed = false;
  /// True if an element crossed its margin inside the step and came back before the end; the margins at the end alone
  /// would miss it.
  bool crossed_back = false;
  /// Fraction of the step at which the first margin is expected to reach the aim; 1 if none does. Given as 0 it is not
  /// looked for.
  double fraction = 1.0;
};

/// One change of regime that happened.
struct RegimeChange {
  std::size_t block = 0;    ///< index into Model::blocks()
  std::size_t element = 0;  ///< index in that block
  double time = 0.0;        ///< s
  double rate = 0.0;        ///< m/s, of the deformation at that time
  bool touched = false;     ///< a gap closed
  bool opened = false;      ///< a gap opened
};

/// The states of all elements of an ElementBlock in one analysis, made by ElementBlock::make_states(). One virtual call
/// serves a whole block.
///
/// There are two vectors of states. evaluate() computes the trial states from the committed ones and the given
/// displacements, and never changes the committed ones; commit() makes the trial states the committed ones. Dropping a
/// trial step therefore needs no call at all.
///
/// Arrays of displacements, velocities and forces have one entry per degree of freedom and one more, the last, for the
/// ground.
class ElementStates {
 public:
  virtual ~ElementStates() = default;

  /// A copy of all states, of the same block.
  [[nodiscard]] virtual std::unique_ptr<ElementStates> clone() const = 0;

  /// Forces, tangents and trial states at trial displacements and velocities, `step` seconds after the committed state;
  /// 0 is the committed instant again. Adds the internal forces to `force` unless that is null. Returns whether df/du
  /// or df/dv of any element has changed since the last call.
  virtual bool evaluate(double step, const double* displacement, const double* velocity, double* force) = 0;
  /// After evaluate(): the rates of its forces, from both tangents and the given accelerations. Adds them to
  /// `force_rate` unless that is null.
  virtual void evaluate_rates(const double* acceleration, double* force_rate) = 0;
  /// Adds displacement_weight * df/du + velocity_weight * df/dv of the last evaluate().
  virtual void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const = 0;
  /// Notes the corners that forces of elements without located regimes have between the last commit and the last
  /// evaluate(). Such laws see the ends of a step alone. The forces that they lose where their path turns inside it are
  /// added to `lost`, N.
  virtual void find_corners(UnlocatedCorners& corners, double* lost) const = 0;
  /// The axial forces on elements whose law takes one, for evaluate() and evaluate_rates() to use; empty for other
  /// laws.
  virtual AxialActions axial_actions() = 0;
  /// After evaluate(): adds the change of the force of an element for a small change of its compression, N.
  virtual void add_force_by_compression(std::size_t element, double change, double* force) const = 0;

  /// The trial states of the last evaluate() become the committed ones, `step` seconds after the last commit.
  /// Adds the step to the energy account of every element, if they are kept; a step of 0 is the same instant again.
  virtual void commit(double step, WorkRule rule) = 0;
  /// Starts the energy account of every element at the committed state, which must be the last one evaluated. They are
  /// kept from then on; without them steps cost less.
  virtual void start_energy_accounts() = 0;
  /// Energy account of an element since then. Throws std::logic_error where none was started.
  [[nodiscard]] virtual ElementEnergy energy(std::size_t element) const = 0;

  /// Views that stay valid as long as this object.
  [[nodiscard]] virtual ElementResults results() const = 0;
  /// One of the quantities that the law reports (ElementBlock::quantities) at the committed state, in SI units.
  [[nodiscard]] virtual ReportedValue law_quantity(std::size_t element, std::size_t quantity) const = 0;
  /// Force at a fraction of the last committed step, N: the law itself, on the deformation and rate interpolated there.
  [[nodiscard]] virtual double force_inside(std::size_t element, double fraction) const = 0;

  /// Looks for changes of regime between the committed state and the last evaluate(), `step` seconds later. `aim` <= 0
  /// m is the margin at which a located step is meant to end, just beyond zero.
  virtual void scan(double step, double aim, RegimeScan& scan) const = 0;
  /// The time, s, from the last evaluate_rates() on at which the first margin falls to `aim`, on the parabola through
  /// the deformation with both rates there; negative: it has fallen to it before. Infinite where none falls.
  [[nodiscard]] virtual double next_fall(double aim) const = 0;
  /// Puts every element that is beyond its margin at the committed state into its next regime and lists it.
  virtual void change(std::size_t block_index, std::vector<RegimeChange>& changes) = 0;

  /// The contact of one element at the committed state; that of a contact that does not touch for other elements.
  [[nodiscard]] virtual ContactView contact(std::size_t element) const = 0;
  /// Duration of the shortest contact in progress, as a free impact, s; infinite if there is none.
  [[nodiscard]] virtual double shortest_contact() const = 0;

  /// Writes all that changes in an analysis, or reads it back into states of the same block. States that do not say how
  /// throw InputError.
  virtual void archive(StateArchive&) {
    throw InputError{"The states of an element of this script cannot be saved: they have no archive()."};
  }
};

}  // namespace moat
