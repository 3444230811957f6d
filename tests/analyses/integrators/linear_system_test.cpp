#include "analyses/integrators/linear_system.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "analyses/integrators/linear_path.hpp"
#include "message_of.hpp"
#include "moat.hpp"

namespace moat {
namespace {

using namespace units;

/// The tangents of a linear model.
struct Tangents {
  SparseMatrix stiffness, damping;  ///< df/du, df/dv

  /// Of this model.
  explicit Tangents(const Model& model) : stiffness{model.zero_matrix()}, damping{model.zero_matrix()} {
    const AnalysisState state{model};
    state.assemble_tangent(0.0, 0.0, 1.0, stiffness);
    state.assemble_tangent(0.0, 1.0, 0.0, damping);
  }
};

/// u'' = -M^-1 (K u + C u') + offset - (a_g + s t), by the exponential of the first-order system of u, u', a_g and 1.
/// Its series is summed in long double over short parts of the time: another way than that of LinearSystem, with more
/// digits.
struct ExponentialMotion {
  Eigen::MatrixXd stiffness, damping;  ///< M^-1 K, M^-1 C
  Vector offset;                       ///< m/s^2

  /// Of a model with these tangents.
  ExponentialMotion(const Model& model, const Tangents& tangents, Vector its_offset)
      : stiffness{model.mass_matrix().diagonal().cwiseInverse().asDiagonal() * Eigen::MatrixXd{tangents.stiffness}},
        damping{model.mass_matrix().diagonal().cwiseInverse().asDiagonal() * Eigen::MatrixXd{tangents.damping}},
        offset{std::move(its_offset)} {}

  /// (u, u', u'') and the absolute jerk h s after a start (u, u'), under a ground with this acceleration there and this
  /// slope.
  [[nodiscard]] Vector after(double h, const Vector& start, double ground, double slope) const {
    const Eigen::Index n = offset.size();
    using Wide = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;
    Wide rates = Wide::Zero(2 * n + 2, 2 * n + 2);
    rates.block(0, n, n, n).setIdentity();
    rates.block(n, 0, n, n) = -stiffness.cast<long double>();
    rates.block(n, n, n, n) = -damping.cast<long double>();
    rates.block(n, 2 * n, n, 1).setConstant(-1.0L);
    rates.block(n, 2 * n + 1, n, 1) = offset.cast<long double>();
    rates(2 * n, 2 * n + 1) = slope;
    Wide end(2 * n + 2, 1);
    end << start.head(2 * n).cast<long double>(), ground, 1.0L;
    constexpr int parts = 256, terms = 24;
    const Wide over_part = static_cast<long double>(h) / parts * rates;
    for (int part = 0; part < parts; ++part) {
      Wide term = end;
      for (int k = 1; k < terms; ++k) {
        term = over_part * term / static_cast<long double>(k);
        end += term;
      }
    }
    const Wide end_rates = rates * end;
    const Vector velocity = end.block(n, 0, n, 1).cast<double>(),
                 acceleration = end_rates.block(n, 0, n, 1).cast<double>();
    Vector motion(4 * n);
    motion << end.topRows(2 * n).cast<double>(), acceleration, -stiffness * velocity - damping * acceleration;
    return motion;
  }
};

// A chain of bodies between two walls.
Model chain(const std::vector<double>& masses, double stiffness = 4e4) {
  Model model;
  NodeId below = ground;
  for (std::size_t i = 0; i <= masses.size(); ++i) {
    const NodeId above =
        i == masses.size() ? ground : add(model, Node{.name = "body " + std::to_string(i), .mass = masses[i] * kg});
    const auto number = static_cast<double>(i);
    add(model, Spring<Linear>{.name = "spring " + std::to_string(i),
                              .lower = below,
                              .upper = above,
                              .law = {.stiffness = (1.0 + 0.2 * number) * stiffness * N / m,
                                      .damping = (200.0 + 50.0 * number) * N * s / m}});
    below = above;
  }
  return model;
}

std::vector<double> masses_of(std::size_t count) {
  std::vector<double> masses;
  for (std::size_t i = 0; i < count; ++i) masses.push_back(100.0 + 30.0 * static_cast<double>(i));
  return masses;
}

LinearSystem system_of(const Model& model, double longest_step) {
  const Tangents tangents{model};
  return {tangents.stiffness, tangents.damping, model.mass_matrix(), Vector::Ones(model.degrees_of_freedom()),
          longest_step};
}

// The system of a chain, its motion by the exponential, and a start of it: displacements, then velocities.
struct MovingChain {
  Model model;
  LinearSystem system;
  ExponentialMotion exact;
  Vector start;

  MovingChain(Model its_model, double longest_step)
      : model{std::move(its_model)},
        system{system_of(model, longest_step)},
        exact{model, Tangents{model}, Vector::Zero(model.degrees_of_freedom())} {
    const int count = model.degrees_of_freedom();
    start.resize(2 * count);
    for (int i = 0; i < count; ++i) {
      exact.offset[i] = 0.7 - 0.2 * i;
      start[i] = 0.01 * std::sin(1.0 + i);
      start[count + i] = 0.4 * std::cos(2.0 + 3.0 * i);
    }
  }
};

// Each part of the motion to a share of its largest entry.
void expect_equal(const Vector& found, const Vector& exact) {
  const Eigen::Index count = exact.size() / 4;
  for (Eigen::Index part = 0; part < found.size() / count; ++part) {
    const Vector of_part = exact.segment(part * count, count);
    const double allowed = 1e-12 * of_part.cwiseAbs().maxCoeff();
    for (Eigen::Index i = 0; i < count; ++i) EXPECT_NEAR(found[part * count + i], of_part[i], allowed) << part << i;
  }
}

// The path gives the motion at every time in a step: at the end of a whole one by the exponential, elsewhere by a
// series.
void expect_path_of_the_exponential(const MovingChain& chain) {
  constexpr double ground = 2.3, slope = -17.0;
  const Eigen::Index n = chain.exact.offset.size();
  MotionState state = chain.model.initial_motion();
  state.displacement.head(n) = chain.start.head(n);
  state.velocity.head(n) = chain.start.tail(n);
  for (const double part : {1.0, 0.99, 0.37}) {
    SCOPED_TRACE(part);
    const double length = part * chain.system.step();
    LinearPath path;
    path.begin(chain.system, chain.exact.offset, state,
               {.length = length,
                .end_time = length,
                .ground_acceleration = {ground + length * slope, 0.0},
                .ground_jerk = {slope, 0.0},
                .ground_acceleration_at_start = {ground, 0.0}});
    for (const double share : {1e-6, 0.1, 0.6, 1.0, 0.3, 0.0}) {
      SCOPED_TRACE(share);
      const double h = share * length;
      path.move(h, state);
      Vector found(4 * n);
      found << state.displacement.head(n), state.velocity.head(n), state.acceleration.head(n), state.jerk.head(n);
      expect_equal(found, chain.exact.after(h, chain.start, ground, slope));
    }
  }
  for (Eigen::Index i = 0; i < n; ++i) {
    EXPECT_DOUBLE_EQ(state.displacement[i], chain.start[i]) << i;
    EXPECT_DOUBLE_EQ(state.velocity[i], chain.start[n + i]) << i;
  }
}

TEST(LinearSystem, ThePathIsTheExponential) {
  for (const std::size_t count : {1u, 3u, 8u, 11u}) {
    SCOPED_TRACE(count);
    expect_path_of_the_exponential({chain(masses_of(count)), 0.02});
  }
}

// Coefficients of a light body are larger than its motion where it hangs on heavy ones.
TEST(LinearSystem, KeepsItsDigitsBetweenLightAndHeavyBodies) {
  expect_path_of_the_exponential({chain({1e6, 1.0, 1e6, 1.0}), 0.01});
}

// About 1e4 1/s.
TEST(LinearSystem, KeepsItsDigitsInFastVibrations) {
  expect_path_of_the_exponential({chain({100.0, 130.0, 160.0}, 4e9), 0.005});
}

// Bodies that nothing holds, and with them a system whose rates have no full set of eigenvectors.
TEST(LinearSystem, MovesFreeBodies) {
  Model model;
  for (const char* name : {"one", "other"}) add(model, Node{.name = name, .mass = 100 * kg});
  expect_path_of_the_exponential({std::move(model), 0.01});
}

TEST(LinearSystem, HalvesItsStepForTheFastestVibration) {
  const Model model = chain({100.0});
  // sqrt(4e4 (1 + 1.2) / 100 kg) is 29.7 1/s: 0.02 s is just too long for a half.
  EXPECT_DOUBLE_EQ(system_of(model, 0.016).step(), 0.016);
  EXPECT_DOUBLE_EQ(system_of(model, 0.02).step(), 0.01);
  EXPECT_DOUBLE_EQ(system_of(model, 1.0).step(), 1.0 / 64.0);
  const auto too_stiff = [] { [[maybe_unused]] const LinearSystem system = system_of(chain({100.0}, 4e17), 1.0); };
  EXPECT_NE(testing::message_of(too_stiff).find("fastest eigenvalue"), std::string::npos);
}

TEST(LinearSystem, KnowsItsTangents) {
  const Model model = chain(masses_of(3));
  const Tangents tangents{model}, stiffer{chain(masses_of(3), 5e4)};
  const LinearSystem system = system_of(model, 0.01);
  EXPECT_TRUE(system.is_of(tangents.stiffness, tangents.damping));
  EXPECT_FALSE(system.is_of(stiffer.stiffness, tangents.damping));
  EXPECT_FALSE(system.is_of(tangents.stiffness, tangents.stiffness));
}

}  // namespace
}  // namespace moat
