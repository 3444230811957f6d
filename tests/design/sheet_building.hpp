// The building of the tests of design sheets, and numbers as they are printed.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <vector>

#include "design/design_sheet.hpp"
#include "design/sheet_inputs.hpp"

namespace moat::testing {

/// 30 MN on 15 isolators, Q = 6 % of the weight and 3 s after yield; five floors of 5 MN.
inline SheetBuilding sheet_building() {
  using namespace units;
  std::vector<PlanPosition> bearings;
  for (const double x : {-16.0, -8.0, 0.0, 8.0, 16.0})
    for (const double y : {-10.0, 0.0, 10.0}) bearings.push_back({x * m, y * m});
  return {.name = "Hospital",
          .weight = 30 * MN,
          .floors = {{5 * MN, 3.5 * m}, {5 * MN, 7 * m}, {5 * MN, 10.5 * m}, {5 * MN, 14 * m}, {5 * MN, 17.5 * m}},
          .isolation = BearingDesign{.strength_ratio = 0.06, .isolation_period = 3 * s, .yield_displacement = 10 * mm},
          .bounds = {.lower = {0.85, 0.90}, .upper = {1.5, 1.3}},
          .shorter_side = 20 * m,
          .longer_side = 32 * m,
          .bearings = bearings,
          .eccentricity = 0.4 * m,
          .fixed_base_period = 0.6 * s,
          .clearance = 0.45 * m};
}

/// Expects a value to agree with all digits of a printed one.
inline void expect_printed(double value, const std::string& printed, const std::string& what) {
  const std::size_t point = printed.find('.');
  const double decimals = point == std::string::npos ? 0.0 : static_cast<double>(printed.size() - point - 1);
  EXPECT_NEAR(value, std::strtod(printed.c_str(), nullptr), 0.5000001 * std::pow(10.0, -decimals)) << what;
}

/// Expects three printed values, in a unit that is so many SI units.
inline void expect_printed(const SheetLine& line, const std::array<const char*, 3>& printed, double unit = 1.0) {
  for (std::size_t i = 0; i < printed.size(); ++i)
    expect_printed(line.value(static_cast<Bound>(i)) / unit, printed[i],
                   line.symbol + ", " + std::string{name_of(static_cast<Bound>(i))});
}

}  // namespace moat::testing
