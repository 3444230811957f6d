// Another view of one building has the results of the other view.

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>

#include "drawn_buildings.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

std::string as_it_is(std::string place) { return place; }

// Two views of one model differ by roundings where the runs take the same steps. Otherwise each has its own error of
// integration, for which it has error bars.
void expect_same(const Problem& one_view, const Problem& other_view, const PeakRule& rule = same_magnitude,
                 const std::function<std::string(std::string)>& moved = as_it_is) {
  Outcome one = outcome_of(one_view), other = outcome_of(other_view);
  Difference difference = difference_of_peaks(one, other, rule, moved);
  RC_LOG() << one.solver.accepted_steps << " and " << other.solver.accepted_steps << " steps, " << one.solver.events
           << " and " << other.solver.events << " events, difference " << difference << "\n";
  if (!same_steps(one, other)) {
    RC_ASSERT(difference <= accurate);
    add_error_bars(one, one_view);
    add_error_bars(other, other_view);
    difference = difference_of_peaks(one, other, rule, moved);
    RC_LOG() << "beyond the error bars " << difference << "\n";
  }
  RC_ASSERT(difference <= equal_but_for_rounding);
}

// Other units scale a peak by its own factor.
PeakRule in_units_of(double mass, double time) {
  return [=](const Peak& peak) -> std::optional<double> {
    if (peak.unit == "N" || peak.unit == "N m" || peak.unit == "J") return mass / (time * time);
    if (peak.unit == "m/s" || peak.unit == "rad/s") return 1.0 / time;
    if (peak.unit == "m/s^2" || peak.unit == "rad/s^2") return 1.0 / (time * time);
    if (peak.unit == "m" || peak.unit == "rad" || peak.unit == "1" || peak.unit == "%") return 1.0;
    return std::nullopt;
  };
}

// The components of a vector turn.
std::optional<double> without_components(const Peak& peak) {
  const bool is_component = peak.quantity.ends_with("_x") || peak.quantity.ends_with("_y");
  return is_component ? std::nullopt : same_magnitude(peak);
}

// The left wall is the right one of the mirror.
std::string in_the_mirror(std::string place) {
  if (const std::size_t left = place.find("left"); left != std::string::npos) return place.replace(left, 4, "right");
  if (const std::size_t right = place.find("right"); right != std::string::npos) return place.replace(right, 5, "left");
  return place;
}

TEST(Symmetry, PlainProblemsMirror) {
  for_random_cases(10, [] {
    const PlainModel plain = (*plain_problems()).model;
    expect_same(problem_of(plain), problem_of(mirrored(plain)));
  });
}

// They keep the digits of every number, so that no choice of a step is another one.
rc::Gen<double> powers_of_two() { return rc::gen::noShrink(rc::gen::element(0.125, 0.25, 0.5, 2.0, 4.0, 8.0)); }

// Contacts count slower touches as so slow ones: that speed has no other unit.
bool touches_slowly(const Problem& problem) {
  return std::ranges::any_of(outcome_of(problem).impacts,
                             [](const Impact& impact) { return impact.approach_speed <= least_approach_speed; });
}

TEST(Symmetry, PlainProblemsScaleWithTheirUnits) {
  for_random_cases(10, [] {
    const PlainModel plain = (*plain_problems()).model;
    const double mass = *powers_of_two().as("mass"), time = *powers_of_two().as("time");
    const Problem one = problem_of(plain), other = problem_of(in_other_units(plain, mass, time));
    RC_PRE(!touches_slowly(one) && !touches_slowly(other));
    expect_same(one, other, in_units_of(mass, time));
  });
}

TEST(Symmetry, PlainProblemsHaveNoOrder) {
  for_random_cases(10, [] {
    const DrawnPlain plain = *plain_problems();
    expect_same(problem_of(plain.model), problem_of(in_another_order(plain.model, plain.seed)));
  });
}

class SymmetryOf : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, SymmetryOf, ::testing::ValuesIn(families), name_of_family);

TEST_P(SymmetryOf, BuildingsMirrorOrTurn) {
  const bool in_plan = GetParam().building == tower_in_plan;
  for_random_cases(10, [=] {
    const Draw draw = *draws();
    View view{.mirrored = !in_plan};
    if (in_plan) view.turn = *any_number(0.1, 6.2).as("turn") * units::rad;
    expect_same(GetParam().building(draw, {}), GetParam().building(draw, view),
                in_plan ? without_components : same_magnitude, in_plan ? as_it_is : in_the_mirror);
  });
}

TEST_P(SymmetryOf, BuildingsScaleWithTheirUnits) {
  const DrawnBuilding building =
      GetParam().building == building_on_any_law ? building_on_a_scalable_law : GetParam().building;
  for_random_cases(10, [=] {
    const Draw draw = *draws();
    const double mass = *powers_of_two().as("mass");
    expect_same(building(draw, {}), building(draw, {.mass = mass}), in_units_of(mass, 1.0));
  });
}

// Bearings are called by their numbers.
TEST_P(SymmetryOf, BuildingsHaveNoOrder) {
  for_random_cases(10, [] {
    const Draw draw = *draws();
    expect_same(GetParam().building(draw, {}), GetParam().building(draw, {.reversed = true}), [](const Peak& peak) {
      return peak.where.find("bearing ") == std::string::npos && peak.where.find(" column ") == std::string::npos
                 ? same_magnitude(peak)
                 : std::nullopt;
    });
  });
}

}  // namespace
}  // namespace moat::testing
