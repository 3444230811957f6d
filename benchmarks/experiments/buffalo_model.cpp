#include "experiments/buffalo_model.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <unsupported/Eigen/NonLinearOptimization>
#include <unsupported/Eigen/NumericalDiff>
#include <utility>

#include "solvers/modes.hpp"

namespace moat::experiments {
namespace {

using namespace units;
using Eigen::VectorXd;

// Computed less measured values of one test over the norm of the measured ones.
VectorXd residuals_of(const BuffaloTest& test, const Deformations& computed) {
  std::vector<std::pair<const History*, const History*>> pairs;
  if (test.isolated) pairs.emplace_back(&computed.isolators, &test.measured.isolators);
  for (std::size_t i = 0; i < 3 && !test.isolated; ++i)
    pairs.emplace_back(&computed.drifts[i], &test.measured.drifts[i]);
  const auto count = static_cast<Eigen::Index>(pairs.front().second->size());
  VectorXd residuals{count * static_cast<Eigen::Index>(pairs.size())}, measured{residuals.size()};
  for (Eigen::Index begin = 0; const auto& [of_model, of_test] : pairs) {
    residuals.segment(begin, count) = VectorXd::Map(of_model->data(), count) - VectorXd::Map(of_test->data(), count);
    measured.segment(begin, count) = VectorXd::Map(of_test->data(), count);
    begin += count;
  }
  return residuals / measured.norm();
}

// The residuals of several tests as a function of the logarithms of parameters > 0.
struct Problem {
  using Scalar = double;
  using InputType = VectorXd;
  using ValueType = VectorXd;
  using JacobianType = Eigen::MatrixXd;
  enum { InputsAtCompileTime = Eigen::Dynamic, ValuesAtCompileTime = Eigen::Dynamic };

  std::vector<const BuffaloTest*> tests{};
  std::function<Deformations(const BuffaloTest&, const VectorXd&)> compute{};
  int values_count = 0;

  [[nodiscard]] int values() const { return values_count; }
  int operator()(const VectorXd& logarithms, VectorXd& residuals) const {
    for (Eigen::Index begin = 0; const BuffaloTest* test : tests) {
      const VectorXd part = residuals_of(*test, compute(*test, logarithms.array().exp()));
      residuals.segment(begin, part.size()) = part;
      begin += part.size();
    }
    return 0;
  }
};

VectorXd fitted(const std::vector<BuffaloTest>& tests, bool isolated, const VectorXd& start,
                std::function<Deformations(const BuffaloTest&, const VectorXd&)> compute) {
  Problem problem{.compute = std::move(compute)};
  for (const BuffaloTest& test : tests) {
    if (test.isolated != isolated || !test.identifies()) continue;
    problem.tests.push_back(&test);
    problem.values_count += static_cast<int>((isolated ? 1 : 3) * test.measured.isolators.size());
  }
  if (problem.tests.empty()) return start;
  // Differences of a few tenths of a percent, above the noise that located events leave in a history.
  Eigen::NumericalDiff<Problem> with_slopes{problem, 1e-6};
  Eigen::LevenbergMarquardt<Eigen::NumericalDiff<Problem>> method{with_slopes};
  method.parameters.xtol = method.parameters.ftol = 1e-5;
  VectorXd logarithms = start.array().log();
  method.minimize(logarithms);
  return logarithms.array().exp();
}

// A share s from 0 to 1 is fitted as s/(1 - s), which is > 0.
VectorXd values_of(const SteelFrame& frame) {
  const auto& [k, damping, drift, hardening] = frame;
  return VectorXd{{k[0], k[1], k[2], damping, drift, hardening / (1.0 - hardening)}};
}
SteelFrame frame_of(const VectorXd& values) {
  return {{values[0], values[1], values[2]}, values[3], values[4], values[5] / (1.0 + values[5])};
}

// The friction at rest is below that at high speed.
VectorXd values_of(const PendulumFriction& friction) {
  return Eigen::Vector2d{friction.slow, friction.fast - friction.slow};
}
PendulumFriction friction_of(const VectorXd& values) { return {values[0], values[0] + values[1]}; }

}  // namespace

std::array<double, 3> SteelFrame::periods() const {
  Model model;
  add(model, building_of(*this, {}));
  std::array<double, 3> list{};
  const std::vector<Mode> modes =
      slowest_modes(model.linear_stiffness(StiffnessStage::initial), model.mass_matrix().diagonal(), 3);
  std::ranges::transform(modes, list.begin(), &Mode::period);
  return list;
}

ShearBuilding building_of(const SteelFrame& frame, const std::optional<PendulumFriction>& friction, Mass floor_mass) {
  std::vector<StoreyLaw> storeys;
  for (const double each : frame.stiffness_over_mass) {
    const Stiffness stiffness = each / (s * s) * floor_mass;
    storeys.emplace_back(YieldingStorey{.stiffness = stiffness,
                                        .yield_force = frame.yield_drift * m * stiffness,
                                        .hardening_ratio = frame.hardening_ratio});
  }
  ShearBuilding building{
      .storeys = 3, .floor_mass = floor_mass, .storey = storeys, .damping = {.ratio = frame.damping_ratio}};
  if (friction) {
    building.base_mass = 2.0 * floor_mass;
    building.isolation = FrictionPendulum{
        .radius = 775 * mm,
        .friction = VelocityDependent{.slow = friction->slow, .fast = friction->fast, .rate = 98 * s / m},
        .yield_displacement = 0.5 * mm};
  }
  return building;
}

Deformations computed(const BuffaloTest& test, const SteelFrame& frame, const PendulumFriction& friction) {
  Model model;
  add(model, building_of(frame, test.isolated ? std::optional{friction} : std::nullopt));
  CaseRun run{model, test.table, {.error_bars = ErrorBarMode::never}};
  run.run();
  const CaseResult result = run.result();
  const auto history = [&](const char* quantity, const std::string& where) {
    return high_passed_both_ways(result.histories.values(quantity, where));
  };
  Deformations found;
  if (test.isolated) found.isolators = history("isolator_deformation", "bearings");
  for (std::size_t i = 0; i < 3; ++i) found.drifts[i] = history("drift", "storey " + std::to_string(i + 1));
  return found;
}

double unexplained(const BuffaloTest& test, const Deformations& computed) {
  return residuals_of(test, computed).norm();
}

SteelFrame identified_frame(const std::vector<BuffaloTest>& tests, const SteelFrame& start) {
  return frame_of(fitted(tests, false, values_of(start), [](const BuffaloTest& test, const VectorXd& values) {
    return computed(test, frame_of(values), {});
  }));
}

PendulumFriction identified_friction(const std::vector<BuffaloTest>& tests, const SteelFrame& frame,
                                     const PendulumFriction& start) {
  return friction_of(fitted(tests, true, values_of(start), [&](const BuffaloTest& test, const VectorXd& values) {
    return computed(test, frame, friction_of(values));
  }));
}

}  // namespace moat::experiments
