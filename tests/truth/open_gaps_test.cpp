// A gap that is never reached is no gap.

#include <gtest/gtest.h>

#include <algorithm>

#include "drawn_buildings.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

// The problem with all clearances in one proportion, which leaves the narrowest gap open by the error that a peak
// may have.
Problem just_open(const Problem& problem) {
  constexpr double wide = 1e3;
  Problem open = problem;
  open.model = with_contacts(problem.model, {.clearance_factor = wide});
  Transient analysis{open.model, open.motion, {.end = problem.end}};
  ClearanceRecorder recorder{open.model};
  analysis.attach(recorder);
  run_or_draw_again(analysis);
  double needed = 0.0;
  for (const GapClearance& gap : recorder.clearances())
    needed = std::max(needed, wide * (gap.clearance - gap.left) / gap.clearance);
  RC_LOG() << "clearances " << needed << " times as wide\n";
  // A body that moves away from its wall from rest leaves it open without any clearance, and touches one of 0 m.
  RC_PRE(needed > accurate);
  // A building that falls reaches any wall.
  RC_PRE(needed < wide);
  open.model = with_contacts(problem.model, {.clearance_factor = needed * (1.0 + accurate)});
  return open;
}

// Bodies of flexible walls move too, and have a part in the choice of steps.
void expect_no_difference(const Problem& with_gaps, const Problem& without) {
  const Outcome open = outcome_of(just_open(with_gaps)), none = outcome_of(without);
  RC_ASSERT(open.impacts.empty());
  const bool same_bodies = with_gaps.model.degrees_of_freedom() == without.model.degrees_of_freedom();
  RC_ASSERT(difference_of_peaks(none, open) <= (same_bodies ? equal_but_for_rounding : accurate));
}

TEST(OpenGaps, OfPlainProblemsDoNothing) {
  for_random_cases(10, [] {
    const PlainModel plain = (*plain_problems()).model;
    RC_PRE(!plain.gaps.empty());
    expect_no_difference(problem_of(plain), problem_of(without_gaps(plain)));
  });
}

class OpenGapsOf : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, OpenGapsOf, ::testing::ValuesIn(families), name_of_family);

TEST_P(OpenGapsOf, BuildingsDoNothing) {
  for_random_cases(10, [] {
    Draw draw = *draws();
    RC_PRE(draw.walls);
    const Problem with_gaps = GetParam().building(draw, {});
    draw.walls = false;
    expect_no_difference(with_gaps, GetParam().building(draw, {}));
  });
}

}  // namespace
}  // namespace moat::testing
