// moat's model of the building on friction pendulums, and its identification from tests.
#pragma once

#include <array>
#include <moat.hpp>
#include <optional>
#include <vector>

#include "experiments/buffalo_tests.hpp"

namespace moat::experiments {

/// Three storeys with equal floors and a base of two floor masses. Without walls the mass cancels. The defaults are
/// those that identified_frame() finds in all tests on a fixed base, from 530, 345, 270 1/s^2, 3 %, 0.6 in and 0.3.
struct SteelFrame {
  /// Initial stiffness of the storeys over floor mass, 1/s^2, from below.
  std::array<double, 3> stiffness_over_mass{454.0, 345.0, 277.0};
  double damping_ratio = 0.0405;      ///< Rayleigh damping, of modes 1 and 2 of the frame on a fixed base
  double yield_drift = 0.579 * inch;  ///< m, of every storey
  double hardening_ratio = 0.525;     ///< stiffness after yield over that before, of every storey

  /// The initial periods of the frame on a fixed base, s, longest first.
  [[nodiscard]] std::array<double, 3> periods() const;
};

/// Friction of the pendulums at rest and at high speed. Radius 775 mm (30.5 in), rate 98 s/m and an elastic move of
/// 0.5 mm are given. The defaults are those that identified_friction() finds, from 0.035 and 0.07.
struct PendulumFriction {
  double slow = 0.0150, fast = 0.0703;
};

/// Returns the building, on pendulums if their friction is given, else on a fixed base.
ShearBuilding building_of(const SteelFrame& frame, const std::optional<PendulumFriction>& friction,
                          Mass floor_mass = units::tonne);

/// Deformations under the motion of the table of a test, filtered as the measured ones.
Deformations computed(const BuffaloTest& test, const SteelFrame& frame, const PendulumFriction& friction);

/// Root of the sum of squares of computed less measured values, over that of the measured ones: of the drifts on a
/// fixed base, of the isolators on pendulums.
double unexplained(const BuffaloTest& test, const Deformations& computed);

/// Least squares of the drifts in all tests on a fixed base that identify; each test counts alike, with any strength.
/// Without such tests the start.
SteelFrame identified_frame(const std::vector<BuffaloTest>& tests, const SteelFrame& start = {});
/// Least squares of the isolators' deformations in all isolated tests that identify, likewise.
PendulumFriction identified_friction(const std::vector<BuffaloTest>& tests, const SteelFrame& frame,
                                     const PendulumFriction& start = {});

}  // namespace moat::experiments
