// The laws of isolators, storeys and contacts in OpenSees' words.

#include <gtest/gtest.h>

#include <cmath>
#include <moat.hpp>
#include <sstream>
#include <string>

#include "peers/bouc_wen.hpp"
#include "peers/opensees.hpp"
#include "peers/pendulum.hpp"
#include "peers/rebound.hpp"
#include "written_tcl.hpp"

namespace moat::peers {
namespace {

Tcl tcl_of(const Case& of, const OpenSeesSetting& setting = {}) {
  std::ostringstream text;
  std::vector<int> tags = write_opensees_model(AnalysisState{of.model}, setting, text);
  Tcl tcl{text.str()};
  tcl.measured = std::move(tags);
  return tcl;
}

double number(const std::vector<std::string>& line, std::size_t word) { return std::stod(line.at(word)); }

// The stiffness of the elastic material with this tag.
double elastic(const Tcl& tcl, const std::string& tag) {
  for (const auto& line : tcl.starting_with("uniaxialMaterial", "Elastic"))
    if (line[2] == tag) return number(line, 3);
  return std::nan("");
}

constexpr double weight = 3050e3 * 9.80665;  // N

/// A slider of 5 % with 1 mm of elastic move under the weight, and a spring W/R beside it.
TEST(OpenSeesLaws, APendulumIsASliderBesideASpring) {
  const Tcl tcl = tcl_of(on_pendulums("", near_fault_pulse()));
  const auto sliders = tcl.starting_with("element", "flatSliderBearing");
  ASSERT_EQ(sliders.size(), 1u);
  EXPECT_NEAR(number(sliders[0], 6), 0.05 * weight / 1e-3, 1e-6 * weight / 1e-3);
  const auto friction = tcl.starting_with("frictionModel", "Coulomb");
  ASSERT_EQ(friction.size(), 1u);
  EXPECT_EQ(friction[0][2], sliders[0][5]);
  EXPECT_DOUBLE_EQ(number(friction[0], 3), 0.05);
  // The axial spring, 7: -P, is shortened by the weight, so that the normal force is the weight.
  double settlement = 0.0;
  for (const auto& line : tcl.starting_with("setNodeDisp", sliders[0][4]))
    if (line[2] == "2") settlement = number(line, 3);
  EXPECT_NEAR(-settlement * elastic(tcl, sliders[0][8]), weight, 1e-6 * weight);
  double restoring = 0.0;
  for (const auto& line : tcl.starting_with("element", "zeroLength"))
    if (line[3] == "0" && line[4] == sliders[0][4]) restoring += elastic(tcl, line[6]);
  EXPECT_NEAR(restoring, weight / 2.235, 1e-6 * weight);
  ASSERT_EQ(tcl.measured.size(), 1u) << "the first storey";
  EXPECT_NEAR(elastic(tcl, std::to_string(tcl.measured[0])), 1e9, 1e-3);
}

TEST(OpenSeesLaws, APendulumMayBeASingleBearing) {
  const Tcl tcl = tcl_of(on_pendulums("", near_fault_pulse()), {"textbook", "", true});
  EXPECT_TRUE(tcl.starting_with("element", "flatSliderBearing").empty());
  const auto bearings = tcl.starting_with("element", "singleFPBearing");
  ASSERT_EQ(bearings.size(), 1u);
  EXPECT_DOUBLE_EQ(number(bearings[0], 6), 2.235);
  EXPECT_NEAR(number(bearings[0], 7), 0.05 * weight / 1e-3 + weight / 2.235, 1e-6 * weight / 1e-3)
      << "of slider and spring together";
}

/// OpenSees' z is a displacement whose limit (1/(beta + gamma))^(1/n) is d_y.
TEST(OpenSeesLaws, BoucWenHasTheSameLimit) {
  const auto laws = tcl_of(bouc_wen_storeys("", near_fault_pulse())).starting_with("uniaxialMaterial", "BoucWen");
  ASSERT_EQ(laws.size(), 5u);
  EXPECT_NEAR(number(laws[0], 3), 0.05, 1e-12) << "alpha";
  EXPECT_NEAR(number(laws[0], 4), 1e9, 1e-3) << "k_0";
  EXPECT_EQ(number(laws[0], 5), 2.0) << "n";
  EXPECT_NEAR(std::sqrt(1.0 / (number(laws[0], 6) + number(laws[0], 7))), 6e-3, 1e-12);
  EXPECT_EQ(number(laws[0], 6), number(laws[0], 7)) << "elastic unloading";
  EXPECT_EQ(number(laws[0], 8), 1.0) << "A";
}

TEST(OpenSeesLaws, BilinearImpactHasItsStiffnesses) {
  const Case of = rebounds("", BilinearImpact::from_stiffnesses(1 * GN / m, 0.25 * GN / m, 5 * mm));
  const Tcl tcl = tcl_of(of);
  const auto laws = tcl.starting_with("uniaxialMaterial", "ImpactMaterial");
  ASSERT_EQ(laws.size(), 5u);
  EXPECT_NEAR(number(laws[0], 3), 1e9, 1.0);
  EXPECT_NEAR(number(laws[0], 4), 0.25e9, 1.0);
  EXPECT_NEAR(number(laws[0], 5), -5e-3, 1e-12);
  EXPECT_NEAR(number(laws[0], 6), -10e-3, 1e-12);
}

/// Bilinear, by hand: d_m from the energy K2 d^2/2 + Q d - Q d_y/2, the loss Q (d_m - d_y), Q = (K1 - K2) d_y.
TEST(Rebounds, AreComparedWithTheLawsOwn) {
  const double q = 0.75e9 * 5e-3, k = 0.25e9, energy = 0.5 * 550e3 * 0.09;
  const double largest = (-q + std::sqrt(q * q + 2.0 * k * (energy + 0.5 * q * 5e-3))) / k;
  const Case bilinear = rebounds("", BilinearImpact::from_stiffnesses(1 * GN / m, 0.25 * GN / m, 5 * mm));
  EXPECT_NEAR(bilinear.exact->at(0), 0.3 * std::sqrt(1.0 - q * (largest - 5e-3) / energy), 1e-6);
  // ln((1 + z)/(1 - z e)) = z (1 + e)
  const Case damped = rebounds("", hertz_damp());
  const double e = damped.exact->at(0) / 0.3, z = 0.75 * (1.0 - 0.65 * 0.65);
  EXPECT_NEAR(std::log((1.0 + z) / (1.0 - z * e)), z * (1.0 + e), 1e-6);
}

}  // namespace
}  // namespace moat::peers
