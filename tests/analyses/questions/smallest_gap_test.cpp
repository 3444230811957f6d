// The smallest gap without contact.

#include "moat.hpp"
#include "small_models.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "message_of.hpp"

namespace moat {
namespace {

using namespace units;

TEST(SmallestGap, TakesTwoTriesWhereTheMotionDoesNotDependOnTheGap) {
  int tries = 0;
  const Length gap = smallest_gap([&](Length tried) {
                       ++tries;
                       return tried - 23.4567 * cm;
                     }).gap;
  EXPECT_EQ(tries, 2);
  EXPECT_GT(gap / cm, 23.4567);
  EXPECT_LT(gap / cm, 23.4567 + 1e-3);
}

TEST(SmallestGap, IsFoundWhereTheMotionDependsOnTheGap) {
  for (const double power : {0.5, 2.0, 3.0})
    for (const double root : {0.01, 0.2, 0.7, 4.0}) {
      const Length gap =
          smallest_gap([&](Length tried) { return Length{std::pow(tried.si(), power) - std::pow(root, power)}; }).gap;
      EXPECT_GT(gap.si(), root) << power << " " << root;
      EXPECT_LE(gap.si(), root + 1.01e-5) << power << " " << root;
    }
}

TEST(SmallestGap, TriesNoGapOfWhichTheAnswerIsKnown) {
  std::vector<double> tried;
  const auto tries = [&](const auto& left, const GapSearch& search) {
    tried.clear();
    return smallest_gap(
               [&](Length gap) {
                 tried.push_back(gap.si());
                 return Length{left(gap.si())};
               },
               search)
        .gap.si();
  };
  // 10 cm are closed. 20 cm have 15 cm left, so that the first guess of 5 cm is too small.
  const double root = tries([](double gap) { return gap > 0.15 ? gap - 0.05 : -0.01; }, {.first = 10 * cm});
  EXPECT_GT(root, 0.15);
  EXPECT_LE(root, 0.15 + 1e-5);
  EXPECT_EQ((std::vector{tried[0], tried[1]}), (std::vector{0.1, 0.2}));
  EXPECT_TRUE(std::all_of(tried.begin() + 2, tried.end(), [](double gap) { return gap >= 0.1 && gap <= 0.2; }));
  // 10 cm have less left than the margin of the first guess, which is then larger than 10 cm.
  EXPECT_NEAR(tries([](double gap) { return gap - 0.1 + 1e-6; }, {.first = 10 * cm}), 0.1, 1e-5);
  EXPECT_EQ(*std::ranges::max_element(tried), 0.1);
}

TEST(SmallestGap, SaysThatEvenTheLargestIsClosed) {
  double largest_tried = 0.0;
  const SmallestGap found = smallest_gap(
      [&](Length tried) {
        largest_tried = std::max(largest_tried, tried.si());
        return tried - 3.3 * m;
      },
      {.first = 50 * cm, .largest = 3 * m});
  EXPECT_TRUE(found.beyond);
  EXPECT_EQ(found.gap.si(), 3.0);
  EXPECT_EQ(largest_tried, 3.0);
  EXPECT_FALSE(smallest_gap([](Length tried) { return tried - 3.3 * m; }, {.largest = 3.4 * m}).beyond);
}

TEST(SmallestGap, RefusesASearchThatCannotBe) {
  EXPECT_THROW(smallest_gap([](Length) { return 1 * m; }, {.first = 0 * m}), InputError);
  EXPECT_THROW(smallest_gap([](Length) { return 1 * m; }, {.first = 2 * m, .largest = 1 * m}), InputError);
}

StudyModel mass_in_a_moat(Length gap, double scale, bool moat = true) {
  StudyModel study{Model{}, near_fault_pulse({.quiet_after = 1 * s}).scaled_by(scale)};
  const NodeId mass = add(study.model, testing::Oscillator{.name = "mass", .mass = 1e6, .frequency = std::sqrt(10.0)});
  if (moat)
    add(study.model,
        Moat{.around = mass, .clearance = gap, .law = HertzDamp{.stiffness = 1e9 * N / m_3_2, .restitution = 0.6}});
  return study;
}

TEST(SmallestGap, OfAModelIsItsLargestDisplacement) {
  for (const double scale : {0.2, 1.0}) {
    StudyModel free = mass_in_a_moat({}, scale, false);
    const double displacement = value_of(peaks_of(free.model, free.motion), "displacement", "mass");
    const double gap =
        value_of(smallest_gap_of([&](Length tried) { return mass_in_a_moat(tried, scale); }), "smallest_gap", "");
    EXPECT_GT(gap, displacement);
    EXPECT_LT(gap, displacement + 1e-5);
    StudyModel narrow = mass_in_a_moat(Length{displacement * (1.0 - 1e-4)}, scale);
    EXPECT_GT(value_of(peaks_of(narrow.model, narrow.motion), "impacts", ""), 0.0);
  }
  EXPECT_THROW(smallest_gap_of([](Length tried) { return mass_in_a_moat(tried, 1.0, false); }), InputError);
}

TEST(SmallestGap, OfARecordThatNeedsMoreThanTheLargestIsACensoredResult) {
  const StudyRecord record =
      smallest_gap_of([](Length tried) { return mass_in_a_moat(tried, 1.0); }, {.first = 1 * cm, .largest = 2 * cm});
  EXPECT_TRUE(std::isinf(value_of(record, "smallest_gap", "")));
  EXPECT_EQ(value_of(record, "smallest_gap_above", ""), 0.02);
}

StudyResult demands() {
  return run_study({StudyAxis::of_names("record", {"a", "b", "c", "d", "e", "stuck"})},
                   [](const StudyCase& each) {
                     if (each.position("record") == 5) throw ConvergenceError{"stuck", 0.0, 0.0, 0.0, ""};
                     return StudyRecord{{"smallest_gap", "", "m", 0.1 * std::pow(2.0, 4.0 - each.value("record"))}};
                   },
                   {.keep_failures = true});
}

TEST(GapDemand, IsTheDistributionOfTheGaps) {
  const GapDemand demand{demands()};
  EXPECT_EQ(demand.gaps(), (std::vector{0.1, 0.2, 0.4, 0.8, 1.6}));
  EXPECT_EQ(demand.without_solution(), 1u);
  // ln gaps are equally spaced by ln 2: mean of square 2 ln^2 2.
  EXPECT_NEAR(demand.fit().median(), 0.4, 1e-9);
  EXPECT_NEAR(demand.fit().dispersion(), std::sqrt(2.0) * std::log(2.0), 1e-8);
  for (const double p : {0.05, 0.1, 0.5, 0.9}) {
    EXPECT_NEAR(demand.probability(demand.gap(p)), p, 1e-9);
    EXPECT_LT(demand.gap_bounds(p).low, demand.gap(p).si());
    EXPECT_GT(demand.gap_bounds(p).high, demand.gap(p).si());
    // The band of the gap and the band of the probability are one.
    EXPECT_NEAR(demand.probability_bounds(Length{demand.gap_bounds(p).high}).high, p, 1e-6);
    EXPECT_NEAR(demand.probability_bounds(Length{demand.gap_bounds(p).low}).low, p, 1e-6);
  }
}

TEST(GapDemand, CountsRecordsWithoutADistribution) {
  const GapDemand demand{demands()};
  EXPECT_EQ(demand.empirical_gap(0.0).si(), 1.6);
  EXPECT_EQ(demand.empirical_gap(0.2).si(), 0.8);
  EXPECT_EQ(demand.empirical_gap(0.39).si(), 0.8);
  EXPECT_EQ(demand.empirical_gap(0.99).si(), 0.1);
  EXPECT_THROW((void)demand.empirical_gap(1.0), InputError);
}

/// Smallest gaps of 200 records of which those above a largest gap are not known.
StudyResult censored_at(double largest) {
  std::vector<double> gaps;
  for (int i = 0; i < 200; ++i)  // quantiles of a lognormal distribution, by bisection
    gaps.push_back(0.3 * std::exp(0.4 * [&] {
                     double low = -9.0, high = 9.0;
                     for (int k = 0; k < 60; ++k) {
                       const double middle = 0.5 * (low + high);
                       (0.5 * std::erfc(-middle / std::sqrt(2.0)) < (i + 0.5) / 200.0 ? low : high) = middle;
                     }
                     return low;
                   }()));
  std::vector<std::string> names;
  for (int i = 0; i < 200; ++i) names.push_back("record " + std::to_string(i));
  return run_study({StudyAxis::of_names("record", names)}, [&](const StudyCase& each) {
    const double gap = gaps[each.position("record")];
    if (gap > largest)
      return StudyRecord{{"smallest_gap", "", "m", INFINITY}, {"smallest_gap_above", "", "m", largest}};
    return StudyRecord{{"smallest_gap", "", "m", gap}};
  });
}

TEST(GapDemand, KeepsRecordsThatNeedMoreThanTheLargestGap) {
  const GapDemand all{censored_at(10.0)}, some{censored_at(0.4)};
  EXPECT_EQ(all.beyond().size(), 0u);
  // Phi(ln(0.4 / 0.3) / 0.4) = 0.764: 47 of 200 records are above it.
  EXPECT_EQ(some.gaps().size(), 153u);
  EXPECT_EQ(some.beyond(), std::vector<double>(47, 0.4));
  EXPECT_EQ(some.records(), 200u);
  EXPECT_EQ(some.without_solution(), 0u);
  // The truth, which a fit to the known gaps alone would miss by far.
  EXPECT_NEAR(some.gap(0.1).si(), 0.3 * std::exp(0.4 * 1.2815515655446004), 0.01);
  EXPECT_NEAR(some.probability(Length{0.4}), 1.0 - 0.764, 0.01);
  EXPECT_GT(some.gap_bounds(0.1).high - some.gap_bounds(0.1).low, all.gap_bounds(0.1).high - all.gap_bounds(0.1).low);
  EXPECT_EQ(some.empirical_gap(0.5).si(), all.empirical_gap(0.5).si());
  EXPECT_TRUE(std::isinf(some.empirical_gap(0.1).si()));
  EXPECT_NE(some.description().find(", 47 that need more than 40 cm, 0 without solution."), std::string::npos)
      << some.description();
  EXPECT_NE(
      testing::message_of<InputError>([] { GapDemand{censored_at(0.001)}; }).find("give a larger GapSearch::largest"),
      std::string::npos);
}

}  // namespace
}  // namespace moat
