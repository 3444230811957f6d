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

void expect_same(const Outcome& one, const Outcome& other, const PeakRule& rule = same_magnitude,
                 const std::function<std::string(std::string)>& moved = as_it_is,
                 double bound = equal_but_for_rounding) {
  const Difference difference = difference_of_peaks(one, other, rule, moved);
  RC_LOG() << one.solver.accepted_steps << " and " << other.solver.accepted_steps << " steps, " << one.solver.events
           << " and " << other.solver.events << " events, difference " << difference << "\n";
  RC_ASSERT(difference <= bound);
}

// Other units scale a peak by its own.
PeakRule in_units_of(double mass, double time) {
  return [=](const Peak& peak) -> std::optional<double> {
    const double force = mass / (time * time), value = peak.magnitude();
    if (peak.unit == "N" || peak.unit == "N m" || peak.unit == "J") return force * value;
    if (peak.unit == "m/s") return value / time;
    if (peak.unit == "m/s^2") return value / (time * time);
    if (peak.unit == "m" || peak.unit == "rad" || peak.unit == "1" || peak.unit == "%") return value;
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
    expect_same(outcome_of(problem_of(plain)), outcome_of(problem_of(mirrored(plain))));
  });
}

// They keep the digits of every number, so that no choice of a step is another one.
rc::Gen<double> powers_of_two() { return rc::gen::noShrink(rc::gen::element(0.125, 0.25, 0.5, 2.0, 4.0, 8.0)); }

// Contacts count slower touches as so slow ones: that speed has no other unit.
bool touches_slowly(const Outcome& outcome) {
  return std::ranges::any_of(outcome.impacts,
                             [](const Impact& impact) { return impact.approach_speed <= least_approach_speed; });
}

TEST(Symmetry, PlainProblemsScaleWithTheirUnits) {
  for_random_cases(10, [] {
    const PlainModel plain = (*plain_problems()).model;
    const double mass = *powers_of_two().as("mass"), time = *powers_of_two().as("time");
    const Outcome one = outcome_of(problem_of(plain)),
                  other = outcome_of(problem_of(in_other_units(plain, mass, time)));
    RC_PRE(!touches_slowly(one) && !touches_slowly(other));
    // Another unit of time takes other steps: peaks differ by their error.
    expect_same(one, other, in_units_of(mass, time), as_it_is, accurate);
  });
}

TEST(Symmetry, PlainProblemsHaveNoOrder) {
  for_random_cases(10, [] {
    const DrawnPlain plain = *plain_problems();
    expect_same(outcome_of(problem_of(plain.model)), outcome_of(problem_of(in_another_order(plain.model, plain.seed))));
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
    expect_same(outcome_of(GetParam().building(draw, {})), outcome_of(GetParam().building(draw, view)),
                in_plan ? without_components : same_magnitude, in_plan ? as_it_is : in_the_mirror);
  });
}

TEST_P(SymmetryOf, BuildingsScaleWithTheirUnits) {
  const DrawnBuilding building =
      GetParam().building == building_on_any_law ? building_on_a_scalable_law : GetParam().building;
  for_random_cases(10, [=] {
    const Draw draw = *draws();
    const double mass = *powers_of_two().as("mass");
    expect_same(outcome_of(building(draw, {})), outcome_of(building(draw, {.mass = mass})), in_units_of(mass, 1.0));
  });
}

// Bearings are called by their numbers.
TEST_P(SymmetryOf, BuildingsHaveNoOrder) {
  for_random_cases(10, [] {
    const Draw draw = *draws();
    expect_same(outcome_of(GetParam().building(draw, {})), outcome_of(GetParam().building(draw, {.reversed = true})),
                [](const Peak& peak) {
                  return peak.where.find("bearing ") == std::string::npos &&
                                 peak.where.find(" column ") == std::string::npos
                             ? same_magnitude(peak)
                             : std::nullopt;
                });
  });
}

}  // namespace
}  // namespace moat::testing
