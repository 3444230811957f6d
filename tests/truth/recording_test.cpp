// Results do not depend on recorders, on threads, and on stopping and going on.

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "drawn_buildings.hpp"
#include "ended_case.hpp"
#include "plain_changes.hpp"

namespace moat::testing {
namespace {

bool same_bits(const Vector& one, const Vector& other) {
  return one.size() == other.size() && std::equal(one.begin(), one.end(), other.begin(), [](double a, double b) {
           return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
         });
}

// Without observers, with all of a case and histories at any interval, and with energies alone.
void expect_bits_without_observers(const Problem& problem, double interval) {
  const TransientOptions options{.end = problem.end};
  Transient bare{problem.model, problem.motion, options}, with_energies{problem.model, problem.motion, options};
  EnergyLedger energies;
  with_energies.attach(energies);
  std::vector<MotionState> ends;
  try {
    bare.run();
    with_energies.run();
    const EndedCase all =
        run_to_end(problem.model, problem.motion,
                   {.transient = options, .history_interval = interval * units::s, .error_bars = ErrorBarMode::never});
    ends = {bare.state().motion(), with_energies.state().motion(), all.state.motion()};
  } catch (const RockingError&) {
    RC_DISCARD("The building rocks.");
  }
  for (const MotionState& end : ends) {
    RC_ASSERT(same_bits(end.displacement, ends[0].displacement));
    RC_ASSERT(same_bits(end.velocity, ends[0].velocity));
    RC_ASSERT(same_bits(end.acceleration, ends[0].acceleration));
  }
}

// In two parts, the second from the state at the end of the first.
void expect_going_on(const Problem& problem, double share) {
  const TransientOptions options{.tolerance = 1e-7, .steps_per_contact = 256};
  const Outcome whole = outcome_of(problem, options);
  const double end = problem.end.si() > 0.0 ? problem.end.si() : problem.motion.duration();
  TransientOptions first = options, second = options;
  first.end = share * end * units::s;
  second.end = end * units::s;
  Transient before{problem.model, problem.motion, first};
  before.run();
  Transient after{problem.model, problem.motion, before.state(), second};
  after.run();
  const MotionState& motion = after.state().motion();
  const auto error = [&](const Vector& found, const Vector& expected, const char* quantity) {
    double largest = expected.cwiseAbs().maxCoeff();
    for (const Peak& peak : whole.peaks)
      if (peak.quantity.starts_with(quantity)) largest = std::max(largest, peak.magnitude());
    return (found - expected).cwiseAbs().maxCoeff() / largest;
  };
  RC_ASSERT(error(motion.displacement, whole.end.displacement, "displacement") <= 0.1 * accurate);
  RC_ASSERT(error(motion.velocity, whole.end.velocity, "velocity") <= accurate);
}

TEST(Recording, OfPlainProblemsChangesNoBit) {
  for_random_cases(
      5, [] { expect_bits_without_observers(problem_of((*plain_problems()).model), *any_number(0.003, 0.1)); });
}

TEST(GoingOn, WithPlainProblemsChangesNothing) {
  for_random_cases(5, [] { expect_going_on(problem_of((*plain_problems()).model), *any_number(0.05, 0.95)); });
}

TEST(Threads, OfAStudyChangeNoBit) {
  for_random_cases(2, [] {
    const Draw first = *draws();
    const auto study = [&](int threads) {
      return run_study({{.name = "number", .unit = "1", .values = linearly_spaced(0.0, 5.0, 6)}},
                       [&](const StudyCase& each) {
                         Draw draw = first;
                         draw.seed += static_cast<std::uint64_t>(each.value("number"));
                         Problem problem = building_on_any_law(draw);
                         return StudyModel{std::move(problem.model), std::move(problem.motion)};
                       },
                       {.threads = threads, .energies = true});
    };
    const StudyResult one = study(1), three = study(3);
    const Table table_of_one = one.table(), table_of_three = three.table();
    RC_ASSERT(table_of_one.columns.size() == table_of_three.columns.size());
    for (std::size_t i = 0; i < table_of_one.columns.size(); ++i) {
      const auto vector = [](const std::vector<double>& values) {
        return Eigen::Map<const Vector>{values.data(), static_cast<Eigen::Index>(values.size())};
      };
      RC_ASSERT(same_bits(vector(table_of_one.columns[i].values), vector(table_of_three.columns[i].values)));
    }
  });
}

class RecordingOf : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, RecordingOf, ::testing::ValuesIn(families), name_of_family);

TEST_P(RecordingOf, BuildingsChangesNoBit) {
  for_random_cases(5,
                   [] { expect_bits_without_observers(GetParam().building(*draws(), {}), *any_number(0.003, 0.1)); });
}

class GoingOnWith : public ::testing::TestWithParam<Family> {};
INSTANTIATE_TEST_SUITE_P(Families, GoingOnWith, ::testing::ValuesIn(families), name_of_family);

TEST_P(GoingOnWith, BuildingsChangesNothing) {
  for_random_cases(5, [] { expect_going_on(GetParam().building(*draws(), {}), *any_number(0.05, 0.95)); });
}

}  // namespace
}  // namespace moat::testing
