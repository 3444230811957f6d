// Linear models have the motion of modal superposition.

#include "superposition.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>

#include "moat_model.hpp"
#include "plain_changes.hpp"
#include "random_draws.hpp"
#include "random_motion.hpp"

namespace moat::testing {
namespace {

using namespace units;
using std::numbers::pi;

// Exact steps have round-off alone, also of the eigenvectors; Newmark's method its tolerance, 3e-5 of accelerations.
constexpr double exact = 1e-8;

// Watches the motion at the samples.
class Samples final : public StepObserver {
 public:
  Samples(const GroundMotion& motion, const Eigen::MatrixXd& expected) : motion_{motion}, expected_{expected} {}

  void start(const StepView& view) override { step(view); }
  void step(const StepView& view) override {
    const double position = view.state.time() / motion_.time_step();
    const auto sample = static_cast<Eigen::Index>(std::lround(position));
    if (std::abs(position - static_cast<double>(sample)) > 1e-9 || sample >= expected_.cols()) return;
    const Eigen::Index n = expected_.rows() / 2;
    const MotionState& motion = view.state.motion();
    largest_ = std::max(largest_, expected_.col(sample).head(n).cwiseAbs().maxCoeff());
    error_ = std::max(error_, (motion.displacement.head(n) - expected_.col(sample).head(n)).cwiseAbs().maxCoeff());
    ++seen_;
  }
  [[nodiscard]] double error() const { return error_ / largest_; }
  [[nodiscard]] long seen() const { return seen_; }

 private:
  const GroundMotion& motion_;
  const Eigen::MatrixXd& expected_;
  double error_ = 0.0, largest_ = 0.0;
  long seen_ = 0;
};

void expect_superposition(const Model& model, const GroundMotion& motion, const LinearSystem& system) {
  Eigen::MatrixXd samples{system.influence.cols(), static_cast<Eigen::Index>(motion.samples().size())};
  const auto row = [](std::span<const double> values) {
    return Eigen::Map<const Eigen::RowVectorXd>{values.data(), static_cast<Eigen::Index>(values.size())};
  };
  samples.row(0) = row(motion.samples());
  if (samples.rows() > 1) samples.row(1) = row(motion.samples_y());
  const Eigen::MatrixXd expected = superposed(system, motion.time_step(), samples);
  const auto error_of = [&](const TransientOptions& options) {
    Transient analysis{model, motion, options};
    Samples watch{motion, expected};
    analysis.attach(watch);
    analysis.run();
    RC_ASSERT(watch.seen() == samples.cols());
    return watch.error();
  };
  // Exact steps take models on a line.
  if (samples.rows() == 1) RC_ASSERT(error_of({.integrator = ExactBetweenEvents{}}) <= exact);
  RC_ASSERT(error_of({}) <= accurate);
  RC_ASSERT(error_of({.tolerance = 1e-8}) <= 1e-2 * accurate);
}

LinearSystem zero_system(Eigen::Index size, Eigen::Index components) {
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(size, size);
  return {zero, zero, zero, Eigen::MatrixXd::Zero(size, components)};
}

TEST(Superposition, OfPlainProblems) {
  for_random_cases(10, [] {
    const PlainModel plain = linear((*plain_problems()).model);
    LinearSystem system = zero_system(static_cast<Eigen::Index>(plain.nodes.size()), 1);
    for (Eigen::Index i = 0; i < system.mass.rows(); ++i)
      system.influence(i, 0) = system.mass(i, i) = plain.nodes[static_cast<std::size_t>(i)].mass;
    const auto add_link = [](Eigen::MatrixXd& matrix, int lower, int upper, double value) {
      for (const int end : {lower, upper})
        if (end >= 0) matrix(end, end) += value;
      if (lower < 0 || upper < 0) return;
      matrix(lower, upper) -= value;
      matrix(upper, lower) -= value;
    };
    for (const PlainSpring& spring : plain.springs) {
      add_link(system.stiffness, spring.lower, spring.upper, spring.stiffness);
      add_link(system.damping, spring.lower, spring.upper, spring.damping);
    }
    for (const PlainDashpot& dashpot : plain.dashpots)
      add_link(system.damping, dashpot.lower, dashpot.upper, dashpot.damping);
    expect_superposition(moat_model(plain), moat_motion(plain.motion), system);
  });
}

// A stiffness of any form, modal damping, and linear bearings.
TEST(Superposition, OfMatrices) {
  for_random_cases(10, [] {
    RandomDraws draws{*seeds()};
    const int n = draws.integer(1, 8);
    const double mass = draws.decades(1e4, 1e6), fast = draws.uniform(10.0, 60.0), ratio = draws.decades(0.005, 0.2);
    Eigen::MatrixXd root{n, n};
    for (Eigen::Index i = 0; i < n; ++i)
      for (Eigen::Index j = 0; j < n; ++j) root(i, j) = draws.uniform(-0.3, 0.3) + (i == j ? 1.0 : 0.0);
    const Eigen::MatrixXd stiffness = mass * fast * fast * (root * root.transpose());
    const double base = draws.uniform(0.5, 2.0) * mass, slow = draws.uniform(1.0, 4.0),
                 bearing = (n * mass + base) * slow * slow, damper = draws.uniform(0.0, 0.2) * (n * mass + base) * slow;
    Superstructure building{
        .stiffness = in_units(stiffness, {.force = N, .length = m}),
        .freedoms = per_floor(Freedoms::x),
        .damping = ModalDamping{ratio},
        .base = SuperstructureBase{.mass = base * kg},
        .isolation = Isolator<Linear>{.law = {.stiffness = bearing * N / m, .damping = damper * N * s / m}}};
    for (int i = 1; i <= n; ++i) building.floors.push_back({.height = i * m, .mass = mass * kg});
    Model model;
    add(model, building);
    // The base is the first degree of freedom: floors move with it.
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes{stiffness / mass};
    const Eigen::MatrixXd damping = mass * modes.eigenvectors() *
                                    (2.0 * ratio * modes.eigenvalues().cwiseSqrt()).asDiagonal() *
                                    modes.eigenvectors().transpose();
    Eigen::MatrixXd relative = Eigen::MatrixXd::Zero(n, n + 1);
    relative.col(0).setConstant(-1.0);
    relative.rightCols(n).setIdentity();
    LinearSystem system = zero_system(n + 1, 1);
    system.mass.diagonal().setConstant(mass);
    system.mass(0, 0) = base;
    system.influence = system.mass.diagonal();
    system.stiffness = relative.transpose() * stiffness * relative;
    system.stiffness(0, 0) += bearing;
    system.damping = relative.transpose() * damping * relative;
    system.damping(0, 0) += damper;
    expect_superposition(model, moat_motion(random_motion(draws)), system);
  });
}

// Slabs one above the other on springs at any places and in any directions.
TEST(Superposition, InPlan) {
  for_random_cases(10, [] {
    RandomDraws draws{*seeds()};
    const int slabs = draws.integer(1, 3);
    Model model;
    LinearSystem system = zero_system(3 * slabs, 2);
    std::vector<DiaphragmId> ids;
    for (int i = 0; i < slabs; ++i) {
      const double mass = draws.decades(1e5, 1e6);
      const PlanVector centre{draws.uniform(-2.0, 2.0), draws.uniform(-2.0, 2.0)};
      const double gyration = draws.uniform(3.0, 8.0), frequency = draws.uniform(5.0, 40.0);
      ids.push_back(add(model, Diaphragm{.name = "slab " + std::to_string(i),
                                         .mass = mass * kg,
                                         .rotary_inertia = mass * gyration * gyration * kg * m * m,
                                         .centre_of_mass = {centre.x * m, centre.y * m}}));
      const Eigen::Index row = 3 * i;
      system.mass.diagonal().segment(row, 3).setConstant(mass);
      system.influence(row, 0) = system.influence(row + 1, 1) = mass;
      for (int spring = 0; spring < 5; ++spring) {
        const PlanVector at{draws.uniform(-10.0, 10.0), draws.uniform(-10.0, 10.0)};
        const double angle = draws.uniform(0.0, 2.0 * pi), stiffness = mass * frequency * frequency * draws.unit(),
                     damping = 0.1 * draws.unit() * mass * frequency;
        const PlanVector direction{std::cos(angle), std::sin(angle)};
        const PlanPosition place{at.x * m, at.y * m};
        add(model, PlanSpring<Linear>{.name = std::to_string(i) + " " + std::to_string(spring),
                                      .lower = i == 0 ? PlanPoint{ground, place} : PlanPoint{ids.end()[-2], place},
                                      .upper = PlanPoint{ids.back(), place},
                                      .direction = direction,
                                      .law = {.stiffness = stiffness * N / m, .damping = damping * N * s / m}});
        Eigen::RowVectorXd stretch = Eigen::RowVectorXd::Zero(3 * slabs);
        for (const auto& [slab, sign] : {std::pair{i, 1.0}, std::pair{i - 1, -1.0}}) {
          if (slab < 0) continue;
          const PlacedDiaphragm& placed = model.diaphragm(ids[static_cast<std::size_t>(slab)]);
          const double x = at.x - placed.centre_of_mass.x, y = at.y - placed.centre_of_mass.y;
          stretch.segment(3 * slab, 3) << sign * direction.x, sign * direction.y,
              sign * (x * direction.y - y * direction.x) / placed.gyration;
        }
        system.stiffness += stiffness * stretch.transpose() * stretch;
        system.damping += damping * stretch.transpose() * stretch;
      }
    }
    PlainMotion x = random_motion(draws), y = x;
    std::rotate(y.samples.begin(), y.samples.begin() + static_cast<std::ptrdiff_t>(y.samples.size() / 3),
                y.samples.end());
    const GroundMotion along_x = moat_motion(x);
    expect_superposition(model, along_x.with_component_y(y.samples, along_x, moat_motion(y)), system);
  });
}

}  // namespace
}  // namespace moat::testing
