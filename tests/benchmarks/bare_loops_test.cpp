// The loops without a library compute the same building as moat.

#include <gtest/gtest.h>

#include <moat.hpp>

#include "performance/bare_loops.hpp"
#include "performance/moat_five_storeys.hpp"

namespace moat::performance {
namespace {

const GroundMotion& motion() {
  static const GroundMotion pulse = near_fault_pulse().scaled_to_pga(0.4 * units::g);
  return pulse;
}

const Peaks& reference() {
  static const Peaks peaks = moat_peaks(five_storey_model(), motion(), {.tolerance = 1e-7, .steps_per_contact = 1024});
  return peaks;
}

TEST(BareLoops, RungeKuttaAgreesWithMoatToSixDigits) {
  EXPECT_LT(largest_error(bare_runge_kutta(motion(), {16, 128}).peaks, reference()), 1e-6);
}

/// Of second order: the error falls by four where the step is halved.
TEST(BareLoops, NewmarkConvergesToMoat) {
  const double coarse = largest_error(bare_newmark(motion(), 64).peaks, reference());
  const double fine = largest_error(bare_newmark(motion(), 128).peaks, reference());
  EXPECT_LT(fine, 2e-6);
  EXPECT_LT(fine, coarse / 3.0);
}

/// The same method, events and iterations, by the general path and by the bare loop.
TEST(BareLoops, NewmarkTakesTheStepsOfMoat) {
  Model model = five_storey_model();
  Transient analysis{
      model, motion(), {.integrator = Newmark::average_acceleration(), .step = motion().time_step() / 2 * units::s}};
  analysis.run();
  const BareHistory bare = bare_newmark(motion(), 2);
  EXPECT_NEAR(static_cast<double>(analysis.statistics().accepted_steps), static_cast<double>(bare.steps), 2.0);
}

/// Classical Runge-Kutta on a grid that meets every sample, with events located: fourth order but for the square root
/// at touch.
TEST(BareLoops, RungeKuttaConvergesQuickly) {
  const double coarse = largest_error(bare_runge_kutta(motion(), {1, 64}).peaks, reference());
  const double fine = largest_error(bare_runge_kutta(motion(), {4, 256}).peaks, reference());
  EXPECT_LT(coarse, 1e-4);
  EXPECT_LT(fine, coarse / 16.0);
}

}  // namespace
}  // namespace moat::performance
