// Everything one run of one model under one motion produced, in SI units.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "base/check.hpp"
#include "base/parameter.hpp"
#include "materials/bearings/bearing_checks.hpp"
#include "model/building.hpp"
#include "motions/ground_motion.hpp"
#include "motions/response_spectrum.hpp"
#include "output/files/contact_sensitivity.hpp"
#include "output/files/model_facts.hpp"
#include "output/files/provenance.hpp"
#include "output/files/table.hpp"
#include "output/vtk/scene.hpp"

namespace moat {

/// The options of an analysis, as they were given in code and on the command line.
struct AnalysisFacts {
  std::string integrator{};           ///< its name, or its description where it has parameters
  std::string events{};               ///< "located" or "at_end_of_step"
  std::string error_bars{};           ///< "automatic", "always" or "never"
  std::string contact_sensitivity{};  ///< the same of the runs with changed contacts
  std::vector<Parameter> options{};   ///< all numbers of TransientOptions, CaseOptions and the scheme, by their names
};

/// The value of largest magnitude that a quantity reached over continuous time.
struct Peak {
  std::string quantity;  ///< "displacement", "absolute_acceleration", "drift", "drift_ratio", "impact_force", ...
  std::string where;     ///< "base", "floor 1", "storey 1", "bearings", "moat", ...
  double value = 0.0;    ///< with its sign: positive to the right, compression of gaps positive
  std::string unit;      ///< SI: "m", "m/s^2", "N"; "%" of ratios of drift
  double time = 0.0;     ///< s; when it was reached
  /// >= 0, in `unit`. Estimated numerical error of the value: value +- error. NaN: not known (see ErrorBars).
  double error = std::numeric_limits<double>::quiet_NaN();
  /// "left" or "right" by the sign; where several elements share the place, the one that reached it: "moat right".
  /// Empty for sums and for a gap by itself.
  std::string side{};

  [[nodiscard]] double magnitude() const { return std::abs(value); }  ///< >= 0, in `unit`.

  void archive(auto& archive) { archive(quantity, where, value, unit, time, error, side); }  ///< StateArchive.
};

/// How near the two sides of a gap came.
struct GapClearance {
  std::string where;       ///< the gap: "moat left"
  double clearance = 0.0;  ///< m, at rest
  /// m, the smallest opening over continuous time; negative: indented by so much.
  double left = 0.0;
  double time = 0.0;  ///< s; when it was reached
  /// m, >= 0. Estimated numerical error of `left`; NaN: not known.
  double error = std::numeric_limits<double>::quiet_NaN();

  void archive(auto& archive) { archive(where, clearance, left, time, error); }  ///< StateArchive.
};

/// Force over indentation of one contact: a value at every end of a step and on both sides of events.
struct ContactLoop {
  std::vector<double> indentation;  ///< m
  std::vector<double> force;        ///< N

  void archive(auto& archive) { archive(indentation, force); }  ///< StateArchive.
};

/// One contact from touch until the gap opens again. ImpactRecorder documents where the two ratios are NaN.
struct Impact {
  std::string where;                 ///< the gap, for example "moat left"
  double start = 0.0;                ///< s
  double duration = 0.0;             ///< s
  double approach_speed = 0.0;       ///< m/s, at first touch; <= 0 if the bodies did not approach
  double largest_indentation = 0.0;  ///< m
  double largest_force = 0.0;        ///< N
  double rebound_ratio = 0.0;        ///< separation speed over approach speed, as it happened in the building
  double restitution = 0.0;          ///< of the law alone, replayed in free flight at the same approach speed
  double energy_lost = 0.0;          ///< J; in plan without the loss by friction
  // In plan:
  /// The corner and the edge that met; empty on a line.
  std::string corner{}, edge{};
  double tangential_speed = 0.0;        ///< m/s, of the corner along the edge at first touch
  double largest_friction_force = 0.0;  ///< N
  double friction_loss = 0.0;           ///< J
  ContactLoop loop{};                   ///< Loop of its force over its indentation.

  void archive(auto& archive) {  ///< StateArchive.
    archive(where, start, duration, approach_speed, largest_indentation, largest_force, rebound_ratio, restitution,
            energy_lost, corner, edge, tangential_speed, largest_friction_force, friction_loss, loop);
  }
};

/// Energy dissipated by the elements reported at one place.
struct DissipatedEnergy {
  std::string where;   ///< Place of the elements.
  double value = 0.0;  ///< J
};

/// Where the energy that the ground put into the structure went, in the frame of the ground, J.
///
///     kinetic + strain + viscous + hysteretic + impact + friction = input + weight_work + errors
struct EnergyBalance {
  double input = 0.0;  ///< work of the inertia forces of the ground motion: - sum of m a_g du
  /// Sum over pendulums of the integral of d^2/(2 R) dN, where weights change: the slab is higher by d^2/(2 R) when its
  /// load rises. The vertical component of the ground enters through it. Of rubber that softens, that of d^2/2 dk_2.
  double weight_work = 0.0;
  double kinetic = 0.0;         ///< of motion relative to the ground, now less that at the start
  double strain = 0.0;          ///< recoverable, now less that at the start
  double viscous = 0.0;         ///< dissipated by dampers and the viscous part of springs
  double hysteretic = 0.0;      ///< dissipated by bearings and other elements that yield
  double impact = 0.0;          ///< lost in impacts
  double friction = 0.0;        ///< lost in impacts by friction along walls; in plan
  bool in_plan = false;         ///< of a model in plan
  bool weights_change = false;  ///< of a model with AxialForces, or where weight_work is not 0

  /// kinetic + work of all elements - input. Average acceleration: zero but for round-off and the force tolerance.
  /// Fourth-order steps: of fourth order. Exact steps: of sixth order. Newmark's method with another beta: of second.
  double equation_residual = 0.0;
  /// Work of all elements less the energy they stored and dissipated: the error of the time integration.
  double integration_error = 0.0;
  double largest_input = 0.0;    ///< over time
  double largest_kinetic = 0.0;  ///< over time
  /// J. Errors up to it are round-off of the work on the elements, which have forces and deformations at rest too.
  double round_off = 0.0;
  std::string worst_element{};       ///< with the largest error
  double worst_element_error = 0.0;  ///< J

  std::vector<DissipatedEnergy> bearings{};  ///< hysteretic, by place: bearings and other elements that yield
  std::vector<DissipatedEnergy> gaps{};      ///< impact, by gap

  /// >= 0: a residual or an error as a share of the largest input or kinetic energy; 0 for round-off.
  [[nodiscard]] double share(double error) const {
    const double scale = std::max(largest_input, largest_kinetic);
    return scale > 0.0 && !(std::abs(error) <= round_off) ? std::abs(error) / scale : 0.0;
  }
  /// The larger share of both errors.
  [[nodiscard]] double error_share() const { return std::max(share(integration_error), share(equation_residual)); }
};

/// The cost of the solution.
struct SolverStatistics {
  long accepted_steps = 0;     ///< Steps that were kept.
  long rejected_steps = 0;     ///< cut because Newton did not converge
  long repeated_steps = 0;     ///< repeated shorter because the error estimate was too large
  long event_solves = 0;       ///< solved again to end at a change of regime
  long events = 0;             ///< touches, separations and other changes of regime
  long passed_changes = 0;     ///< changes that several cuts did not reach, passed by a whole step
  long newton_iterations = 0;  ///< In all steps.
  long factorisations = 0;     ///< Factorisations of the tangent.
  double cpu_seconds = 0.0;    ///< Time of the processor, s.
  double longest_step = 0.0;   ///< s, of the accepted steps
};

/// The second run of the same case with finer steps, the companion, and its verdict. It has no part in any number of
/// the main run but Peak::error.
struct ErrorBars {
  bool checked = false;                 ///< the companion ran to its end: every peak has an error
  std::string companion{};              ///< how it was computed, one sentence; why there is none if it was not
  std::size_t companion_impacts = 0;    ///< the main run's are CaseResult::impacts
  SolverStatistics companion_solver{};  ///< Cost of the companion run.
  /// The two runs differ in their number of impacts, or there are unsettled peaks.
  bool unsettled = false;
  std::string reason{};                 ///< of `unsettled`, one sentence
  std::vector<Peak> unsettled_peaks{};  ///< copies of the peaks whose error exceeds 1 % of their value

  void archive(auto& archive) {  ///< StateArchive.
    archive(checked, companion, companion_impacts, companion_solver, unsettled, reason, unsettled_peaks);
  }
};

/// The motion as it was applied.
struct MotionFacts {
  std::string name;                  ///< Name of the motion.
  double peak_acceleration = 0.0;    ///< m/s^2
  double peak_velocity = 0.0;        ///< m/s
  double time_step = 0.0;            ///< s
  double duration = 0.0;             ///< s
  std::vector<std::string> notes{};  ///< header of the file, how it was scaled and filtered
  /// One, or two in plan, with absolute paths of their records.
  std::vector<MotionComponent> components{};
};

/// A gap of a building.
struct GapOfBuilding {
  std::string name;  ///< of the element
  /// Where the building touches: "left" or "right"; in plan the edge that a corner of it meets, or its edge.
  std::string side;
  std::string wall{};  ///< the body on the other side, where it is one beside buildings
};

/// A building and the names of its parts.
struct BuildingParts {
  std::string name{};                      ///< may be empty
  std::string base{};                      ///< a node; empty for a fixed building
  std::vector<std::string> floors{};       ///< nodes, from the lowest up
  std::vector<std::string> isolators{};    ///< elements
  std::vector<GapOfBuilding> gaps{};       ///< between the building and others, walls or the ground
  std::set<std::string> places{};          ///< where peaks of its nodes and elements are listed
  std::vector<ParticipatingMass> modes{};  ///< of a building given by matrices or modes, held at its base
  bool is_body_beside_buildings = false;   ///< one body on the ground, a wall for example, in a model with buildings
};

/// A period with the name of the part that vibrates.
struct NamedPeriod {
  std::string name;    ///< Name of the part.
  double value = 0.0;  ///< s
};

/// A quantity that a recorder of the script offers. Quantity and place together are unique in a run.
struct OfferedQuantity {
  std::string quantity;  ///< "roof_tilt"; files write it as it is, the report with blanks
  std::string where;     ///< "tower"
  std::string unit;      ///< SI symbol; "1" without dimension
};

/// The method behind Peak::error, for reports.
inline constexpr const char* error_bar_method =
    "Every peak is computed again by a second run with finer steps; the error is estimated from the difference of the "
    "two by Richardson's rule, with caution. It is that of the numerical solution, not of the model.";

/// Nodes of the largest model whose report has a drawing.
inline constexpr int most_drawn_nodes = 300;

/// How an isolated building in plan turned, beside ASCE 7-16 Eq. 17.5-3 (analyses/modes/torsion.hpp).
struct BuildingTorsion {
  std::string where;          ///< its base
  double corner = 0.0;        ///< m, largest displacement of a corner of the base
  double centre = 0.0;        ///< m, largest displacement of its centre of mass; not at the same time
  double eccentricity = 0.0;  ///< m, of the whole building's mass from the centre of rigidity of its bearings
  double period_ratio = 1.0;  ///< P_T
  double of_formula = 1.0;    ///< D_TM/D_M, without the lower bound
  double of_code = 1.15;      ///< with it

  /// corner/centre; NaN where nothing moved.
  [[nodiscard]] double amplification() const {
    return centre > 0.0 ? corner / centre : std::numeric_limits<double>::quiet_NaN();
  }
};

/// One check of a bearing or damper over the whole run.
struct BearingCheckRow {
  std::string bearing, type;  ///< its name, and the place that it shares with others, or its law
  BearingDemand demand;       ///< with the largest ratio
};

/// The response spectrum of the absolute acceleration at one place of a floor (FloorSpectra).
struct FloorSpectrum {
  std::string floor;            ///< "base", "floor 5"
  std::string corner{};         ///< "corner 2"; empty at the centre of mass and on a line
  std::string direction{};      ///< "x" or "y" in plan; empty on a line
  ResponseSpectrum spectrum{};  ///< Without absolute accelerations unless they were wanted.

  /// "floor 5, corner 2, x, 5 %"
  [[nodiscard]] std::string where() const {
    std::string text = floor;
    for (const std::string& part : {corner, direction, to_text(100.0 * spectrum.damping_ratio) + " %"})
      if (!part.empty()) text += ", " + part;
    return text;
  }
};

/// Everything that one run produced.
struct CaseResult {
  std::string title;         ///< Title of the script.
  Provenance provenance{};   ///< Command, script, version, date.
  AnalysisFacts analysis{};  ///< Integrator and options.
  MotionFacts motion;        ///< The motion as it was applied.
  ModelFacts model{};        ///< The whole model.
  /// For drawings; its indices of nodes are those of `model.nodes`. Empty for models of more than `most_drawn_nodes`.
  Scene scene{};
  std::vector<BuildingParts> buildings;    ///< In the order of the model.
  std::vector<NamedPeriod> periods;        ///< Periods of every building.
  std::vector<Peak> peaks;                 ///< One for every quantity and place.
  std::vector<GapClearance> clearances{};  ///< one for every gap
  std::vector<Impact> impacts;             ///< In the order of their starts.
  std::vector<BuildingTorsion> torsion{};  ///< in plan, of every building on bearings
  /// One for every check of every bearing with capacities (BearingCheckRecorder).
  std::vector<BearingCheckRow> bearing_checks{};
  Table histories;                             ///< Every quantity at every sample of the motion.
  std::vector<FloorSpectrum> floor_spectra{};  ///< FloorSpectra of the script; where it has none, of base and top.
  /// Quantities in `histories` that recorders of the script offered (output/recorders/quantity_recorder.hpp).
  std::vector<OfferedQuantity> offered{};
  EnergyBalance energy;                      ///< The balance at the end.
  SolverStatistics solver;                   ///< Steps and iterations of the run.
  ErrorBars error_bars{};                    ///< How the errors of peaks were estimated.
  ContactSensitivity contact_sensitivity{};  ///< How peaks move when contacts change.
  std::vector<std::string> warnings;         ///< problems of accuracy or input, with the remedy
  std::vector<std::string> assumptions;      ///< one sentence each: scheme, step, damping, sign conventions ...
};

}  // namespace moat
