#include "materials/bearings/bearing_checks.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/units.hpp"
#include "message_of.hpp"

namespace moat::testing {
namespace {

using namespace units;

// G A is 0.19242255 MN.
const RubberBearing rubber{
    .diameter = 0.7 * m, .layer_thickness = 6 * mm, .rubber_thickness = 0.18 * m, .shear_modulus = 0.5 * MPa};
const double shear_force = 0.5e6 * std::numbers::pi * 0.49 / 4;

BearingDemand found(const std::vector<BearingDemand>& list, std::string_view check) {
  const auto row = std::ranges::find(list, check, &BearingDemand::check);
  EXPECT_NE(row, list.end()) << check;
  return row == list.end() ? BearingDemand{} : *row;
}

std::vector<std::string_view> names(const std::vector<BearingDemand>& list) {
  std::vector<std::string_view> names;
  for (const BearingDemand& each : list) names.push_back(each.check);
  return names;
}

// A row of the table, with the digits of the specification.
void expect_row(const std::vector<BearingDemand>& list, std::string_view check, double demand, double capacity,
                std::string_view source) {
  const BearingDemand row = found(list, check);
  EXPECT_NEAR(row.demand, demand, 1e-7 * std::abs(demand)) << check;
  EXPECT_EQ(row.source, source) << check;
  if (std::isnan(capacity)) {
    EXPECT_TRUE(std::isnan(row.capacity) && std::isnan(row.ratio())) << check;
  } else {
    EXPECT_NEAR(row.capacity, capacity, 1e-12 * capacity) << check;
    EXPECT_NEAR(row.ratio(), demand / capacity, 1e-7 * std::abs(demand / capacity)) << check;
  }
}

const double not_judged = std::numeric_limits<double>::quiet_NaN();
const DemandAt pressed{
    .displacement = {0.21, 0.28}, .speed = 0.5, .compression = 4e6, .static_compression = 4e6, .time = 3.0};

TEST(DemandsOfRubber, ByAashto) {
  const BearingCapacities bearing{.rubber = rubber,
                                  .displacement_capacity = 0.5 * m,
                                  .stop = 0.6 * m,
                                  .static_displacement = 18 * mm,
                                  .static_rotation_x = 0.005};
  const std::vector<BearingDemand> list = demands(bearing, CheckRules::aashto, pressed);
  const std::string_view guide = "AASHTO Guide Specifications for Seismic Isolation Design";
  expect_row(list, "displacement", 0.35, 0.5, "given");
  expect_row(list, "displacement to the stop", 0.35, 0.6, "given");
  expect_row(list, "shear strain", 0.35 / 0.18, not_judged, "not judged: no shear_capacity");
  expect_row(list, "strain by compression", 1.8227958, 2.5, guide);
  expect_row(list, "strain by rotation", 0.8506944, not_judged, "not judged: no limit in these rules");
  expect_row(list, "sum of strains", 1.8227958 + 1.9444444 + 0.1 + 0.5 * 0.8506944, 5.5, guide);
  expect_row(list, "sum of strains at rest", 0.7127172 + 0.1 + 0.8506944, 5.0, guide);
  expect_row(list, "sum of strains, MCE", 1.8227958 + 1.9444444 + 0.25 * 0.1, 9.0, "MCEER-11-0004");
  expect_row(list, "stability", 4 / 9.4787791, 1 / 1.1, "MCEER-11-0004");
  expect_row(list, "tension", 0.0, 3 * shear_force, "cavitation at 3 G A");
  EXPECT_EQ(list.size(), 10U);
}

TEST(DemandsOfRubber, ByEn) {
  const BearingCapacities bearing{
      .rubber = rubber, .strain_capacity = 7.0 / 1.15, .static_displacement = 18 * mm, .static_rotation_x = 0.005};
  std::vector<BearingDemand> list = demands(bearing, CheckRules::en, pressed);
  expect_row(list, "displacement", 0.35, not_judged, "not judged: no displacement_capacity");
  expect_row(list, "shear strain", 0.35 / 0.18, 2.5, "EN 15129");
  expect_row(list, "shear strain at rest", 0.1, 1.0, "EN 1337-3");
  expect_row(list, "strain by compression", 1.8217250, not_judged, "not judged: no limit in these rules");
  expect_row(list, "sum of strains", 1.8217250 + 1.9444444 + 0.1 + 1.1342593, 7.0 / 1.15, "given");
  expect_row(list, "stability", 4 / 24.0082765, 0.5, "EN 15129");
  expect_row(list, "stability, displaced", 0.5 / 0.7, 1.0, "EN 15129");
  // Above a quarter of the buckling load: 1 - 2 N/P_cr >= 0.7 d/a'.
  DemandAt heavier = pressed;
  heavier.compression = 0.3 * 24.0082765e6;
  list = demands(bearing, CheckRules::en, heavier);
  expect_row(list, "stability, displaced", 0.7 * 0.5 + 0.6, 1.0, "EN 15129");
  DemandAt pulled = pressed;
  pulled.compression = -0.2e6;
  list = demands(bearing, CheckRules::en, pulled);
  expect_row(list, "tension", 0.2e6, 2 * shear_force, "EN 15129");
  expect_row(list, "strain by compression", 0.0, not_judged, "not judged: no limit in these rules");
}

TEST(DemandsOfRubber, ByAsceAndWithoutRules) {
  const BearingCapacities bearing{.rubber = rubber, .shear_capacity = 2.5, .tension_capacity = 0.3 * MN};
  std::vector<BearingDemand> list = demands(bearing, CheckRules::asce, pressed);
  expect_row(list, "stability", 4 / 9.4787791, 1.0, "ASCE 7-16");
  list = demands(bearing, CheckRules::none, pressed);
  expect_row(list, "stability", 4 / 9.4787791, not_judged, "not judged: no limit in these rules");
  expect_row(list, "shear strain", 0.35 / 0.18, 2.5, "given");
  expect_row(list, "sum of strains", 1.8227958 + 1.9444444, not_judged, "not judged: no strain_capacity");
  expect_row(list, "tension", 0.0, 0.3e6, "given");
  const BearingCapacities without{.rubber = rubber};
  expect_row(demands(without, CheckRules::none, pressed), "tension", 0.0, not_judged,
             "not judged: no tension_capacity");
}

TEST(DemandsOfRubber, NeedAnAxialForce) {
  DemandAt unknown = pressed;
  unknown.compression = not_judged;
  const std::vector<BearingDemand> list =
      demands({.rubber = rubber, .shear_capacity = 2.5}, CheckRules::aashto, unknown);
  for (const char* check : {"strain by compression", "sum of strains", "stability", "tension"}) {
    EXPECT_TRUE(std::isnan(found(list, check).demand)) << check;
    EXPECT_EQ(found(list, check).source, "not judged: the axial force is not known");
  }
  expect_row(list, "shear strain", 0.35 / 0.18, 2.5, "given");
}

TEST(DemandsOfSlidersAndDampers, AreTheirOwn) {
  const BearingCapacities slider{.slider_area = 0.1 * m_2,
                                 .pressure_capacity = 60 * MPa,
                                 .speed_capacity = 1 * m / s,
                                 .pressure_speed_capacity = 40 * MPa * (m / s)};
  std::vector<BearingDemand> list = demands(slider, CheckRules::en, pressed);
  expect_row(list, "pressure at rest", 40e6, 60e6, "given");
  expect_row(list, "pressure", 40e6, 60e6, "given");
  expect_row(list, "pressure times speed", 20e6, 40e6, "given");
  expect_row(list, "speed", 0.5, 1.0, "given");
  EXPECT_EQ(names(list), (std::vector<std::string_view>{"displacement", "pressure at rest", "pressure",
                                                        "pressure times speed", "speed"}));
  list = demands({.slider_area = 0.1 * m_2}, CheckRules::en, pressed);
  expect_row(list, "pressure", 40e6, not_judged, "not judged: no pressure_capacity");
  expect_row(list, "speed", 0.5, not_judged, "not judged: no speed_capacity");
  expect_row(list, "pressure times speed", 20e6, not_judged, "not judged: no pressure_speed_capacity");

  DemandAt moved = pressed;
  moved.force = 0.4e6;
  list = demands({.stroke = 0.5 * m, .force_capacity = 1 * MN}, CheckRules::none, moved);
  expect_row(list, "stroke", 0.35, 0.5, "given");
  expect_row(list, "speed", 0.5, not_judged, "not judged: no speed_capacity");
  expect_row(list, "force", 0.4e6, 1e6, "given");
  EXPECT_EQ(names(list), (std::vector<std::string_view>{"stroke", "speed", "force"}));
  expect_row(demands({.stroke = 0.5 * m}, CheckRules::none, moved), "force", 0.4e6, not_judged,
             "not judged: no force_capacity");
}

TEST(BearingChecks, KeepTheLargestRatioOfSimultaneousLoadAndDisplacement) {
  BearingChecks checks{{.rubber = rubber, .slider_area = 0.1 * m_2}, CheckRules::aashto};
  EXPECT_TRUE(checks.largest().empty());
  // The largest load and the largest displacement are at other instants than the largest ratio.
  checks.take({.compression = 2e6, .time = 0.0});
  checks.take({.compression = 6e6, .time = 1.0});
  checks.take({.displacement = {0.35, 0.0}, .compression = 4e6, .time = 2.0});
  checks.take({.displacement = {-0.4, 0.0}, .compression = 1e6, .time = 3.0});
  checks.take({.compression = -1e5, .time = 4.0});
  const BearingDemand stability = found(checks.largest(), "stability");
  EXPECT_NEAR(stability.demand, 4 / 9.4787791, 1e-7);
  EXPECT_EQ(stability.time, 2.0);
  EXPECT_EQ(found(checks.largest(), "displacement").demand, 0.4) << "not judged: the largest demand";
  EXPECT_EQ(found(checks.largest(), "displacement").time, 3.0);
  EXPECT_EQ(found(checks.largest(), "tension").demand, 1e5);
  EXPECT_EQ(found(checks.largest(), "pressure").demand, 6e7);
  EXPECT_EQ(found(checks.largest(), "pressure").time, 1.0);
  EXPECT_EQ(found(checks.largest(), "pressure at rest").demand, 2e7) << "of the first instant";
}

TEST(BearingCapacities, MustBePositive) {
  const auto refusal = [](const BearingCapacities& capacities) {
    return message_of([&] { capacities.check(Check{"BearingCapacities", "LRB700"}); });
  };
  const auto not_allowed = [](const std::string& value, const std::string& range, const std::string& unit) {
    return "BearingCapacities \"LRB700\": " + value + unit + " is not allowed; it must be " + range + unit +
           " and finite.";
  };
  const auto not_positive = [&](const std::string& field, const std::string& unit) {
    return not_allowed(field + " = 0", "> 0", unit.empty() ? "" : " " + unit) + " Leave it out where it is not known.";
  };
  EXPECT_EQ(refusal({}), "nothing was thrown");
  EXPECT_EQ(refusal({.slider_area = 0 * m_2}), not_positive("slider_area", "m^2"));
  EXPECT_EQ(refusal({.displacement_capacity = 0 * m}), not_positive("displacement_capacity", "m"));
  EXPECT_EQ(refusal({.stop = 0 * m}), not_positive("stop", "m"));
  EXPECT_EQ(refusal({.shear_capacity = 0.0}), not_positive("shear_capacity", ""));
  EXPECT_EQ(refusal({.strain_capacity = 0.0}), not_positive("strain_capacity", ""));
  EXPECT_EQ(refusal({.tension_capacity = 0 * N}), not_positive("tension_capacity", "N"));
  EXPECT_EQ(refusal({.pressure_capacity = 0 * Pa}), not_positive("pressure_capacity", "Pa"));
  EXPECT_EQ(refusal({.speed_capacity = 0 * m / s}), not_positive("speed_capacity", "m/s"));
  EXPECT_EQ(refusal({.pressure_speed_capacity = 0 * Pa * (m / s)}),
            not_positive("pressure_speed_capacity", unit_symbol<Quantity<1, 0, -3>>()));
  EXPECT_EQ(refusal({.stroke = 0 * m}), not_positive("stroke", "m"));
  EXPECT_EQ(refusal({.force_capacity = 0 * N}), not_positive("force_capacity", "N"));
  EXPECT_EQ(refusal({.static_displacement = -1 * m}),
            not_allowed("static_displacement = -1", ">= 0", " m") + " Check its sign and its unit.");
  EXPECT_EQ(refusal({.static_rotation_x = -0.5}),
            not_allowed("static_rotation_x = -0.5", ">= 0", "") + " Give a number in this range.");
  EXPECT_EQ(refusal({.static_rotation_y = -0.5}),
            not_allowed("static_rotation_y = -0.5", ">= 0", "") + " Give a number in this range.");
  RubberBearing bad = rubber;
  bad.shear_modulus = 0 * Pa;
  EXPECT_EQ(refusal({.rubber = bad}),
            "BearingCapacities \"LRB700\": shear_modulus = 0 Pa is not allowed; it must be > 0 Pa and finite. Check "
            "its sign and its unit.");
}

}  // namespace
}  // namespace moat::testing
