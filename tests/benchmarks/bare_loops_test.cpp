// The loops without a library, which moat is compared with, compute the same building.

#include <gtest/gtest.h>

#include <moat.hpp>

#include "performance/bare_newmark.hpp"
#include "performance/bare_runge_kutta.hpp"
#include "performance/moat_five_storeys.hpp"

namespace moat::performance {
namespace {

const GroundMotion& motion() {
  static const GroundMotion pulse = near_fault_pulse().scaled_to_pga(0.4 * units::g);
  return pulse;
}

const Peaks& reference() {
  static const Peaks peaks =
      moat_peaks(five_storey_model(true), motion(), {.tolerance = 1e-7, .steps_per_contact = 1024});
  return peaks;
}

TEST(BareLoops, RungeKuttaAgreesWithMoatToSixDigits) {
  EXPECT_LT(largest_error(bare_runge_kutta(motion(), {16, 128}), reference()), 1e-6);
}

TEST(BareLoops, NewmarkAgreesWithMoatToSixDigits) {
  EXPECT_LT(largest_error(bare_newmark(motion(), {1e-7, 1024}), reference()), 1e-6);
}

/// Two ways to solve the same equations of a step.
TEST(BareLoops, BothWaysOfWritingNewmarkAreTheSame) {
  EXPECT_LT(largest_error(plain_newmark(motion(), {1e-4, 32}), bare_newmark(motion(), {1e-4, 32})), 1e-8);
}

/// Classical Runge-Kutta on a grid that meets every sample, with events located: fourth order but for the square root
/// at touch.
TEST(BareLoops, RungeKuttaConvergesQuickly) {
  const double coarse = largest_error(bare_runge_kutta(motion(), {1, 64}), reference());
  const double fine = largest_error(bare_runge_kutta(motion(), {4, 256}), reference());
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 16.0);
}

}  // namespace
}  // namespace moat::performance
