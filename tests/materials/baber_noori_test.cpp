#include "materials/storeys/baber_noori.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "base/units.hpp"
#include "spring_battery.hpp"

namespace moat::testing {
namespace {

using namespace units;

const BaberNoori plain{.stiffness = 100 * MN / m, .hardening_ratio = 0.05, .yield_drift = 2 * cm};

std::vector<double> forces_along(const BaberNoori& law, std::initializer_list<double> path, double* energy = nullptr) {
  LawPath<BaberNoori> lead{law, 0};
  std::vector<double> forces;
  for (const double target : path) {
    lead.move(target, 1.0);
    forces.push_back(lead.force() / 1e3);
  }
  if (energy != nullptr) *energy = lead.state().energy;
  return forces;
}

TEST(BaberNoori, PassesTheBattery) {
  // The energy of an unloading is given back, so that its account may fall: that of the whole path may not.
  const SpringTrial trial{.deformation = 0.05, .moves = 60};
  BaberNoori pinched = BaberNoori::typical();
  pinched.pinching = 0.9;
  pinched.pinching_rate = 5e-6 / J;
  for (const BaberNoori& law : {plain, BaberNoori::typical(), pinched}) {
    expect_tangents(law, trial);
    expect_purity(law, trial);
    expect_independence_of_pieces(law, trial);
    expect_symmetry(law, trial);
  }
}

TEST(BaberNoori, HasTheForcesOfAnIndependentIntegration) {
  const auto bare = forces_along(plain, {0.06, -0.06, 0.06});
  EXPECT_NEAR(bare[0], 2190.604, 2e-3);
  EXPECT_NEAR(bare[1], -2199.829, 2e-3);
  EXPECT_NEAR(bare[2], 2199.8275, 2e-3);

  double energy = 0.0;
  const auto degrading = forces_along(BaberNoori::typical(), {0.06, -0.06, 0.06, -0.06, 0.06}, &energy);
  const std::vector<double> expected{2074.651, -1909.174, 1788.630, -1698.511, 1627.597};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(degrading[i], expected[i], 2e-3) << i;
  EXPECT_NEAR(energy, 538.075e3, 2.0);

  BaberNoori both = plain;
  both.loss_of_both = 1e-6 / J;
  const auto weaker = forces_along(both, {0.06, -0.06, 0.06, -0.06, 0.06});
  const std::vector<double> of_both{2124.238, -2000.267, 1872.607, -1751.914, 1638.644};
  for (std::size_t i = 0; i < of_both.size(); ++i) EXPECT_NEAR(weaker[i], of_both[i], 2e-3) << i;
}

TEST(BaberNoori, PinchesAboutTheOrigin) {
  BaberNoori pinched = plain;
  pinched.pinching = 0.9;
  pinched.pinching_rate = 1e-3 / J;
  pinched.pinching_width = 1 * cm;
  const auto force = [&](const BaberNoori& law) { return forces_along(law, {0.06, -0.06, 0.06, -0.06, 0.0}).back(); };
  EXPECT_LT(force(pinched), 0.7 * force(plain));
}

}  // namespace
}  // namespace moat::testing
