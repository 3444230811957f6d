// Compressions of bearings under a rigid slab.
#include "model/weight/axial_distribution.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <random>
#include <vector>

namespace moat {
namespace {

using Span = AxialDistribution::Span;

std::vector<AxialSupport> four_on_a_line(std::vector<double> shares = {2.5, 2.5, 2.5, 2.5},
                                         std::vector<double> stiffnesses = {1.0, 1.0, 1.0, 1.0}) {
  std::vector<AxialSupport> supports;
  for (std::size_t i = 0; i < 4; ++i)
    supports.push_back(
        {.at = {4.0 * static_cast<double>(i) - 6.0, 0.0}, .stiffness = stiffnesses[i], .share = shares[i]});
  return supports;
}

std::vector<AxialSupport> four_in_plan(double last_stiffness = 1.0) {
  return {{.at = {-5.0, -3.0}, .share = 2.5},
          {.at = {5.0, -3.0}, .share = 2.5},
          {.at = {-5.0, 3.0}, .share = 2.5},
          {.at = {5.0, 3.0}, .stiffness = last_stiffness, .share = 2.5}};
}

std::vector<AxialSupport> forty_eight() {
  std::vector<AxialSupport> supports;
  for (int row = 0; row < 6; ++row)
    for (int column = 0; column < 8; ++column)
      supports.push_back({.at = {-21.0 + 6.0 * column, -12.5 + 5.0 * row},
                          .stiffness = (8 * row + column) % 3 == 0 ? 1.5 : 1.0,
                          .share = 1.0});
  return supports;
}

// The resultant of the shares with an overturning moment.
Resultant overturned(const std::vector<AxialSupport>& supports, PlanVector moment, double sigma = 1.0) {
  Resultant b{0.0, moment};
  for (const AxialSupport& support : supports) {
    b.load += sigma * support.share;
    b.moment += sigma * support.share * support.at;
  }
  return b;
}

struct Found {
  AxialDistribution distribution;
  bool exists;
  std::vector<double> compressions;
};

Found distributed(const std::vector<AxialSupport>& supports, Span span, Resultant b, double sigma = 1.0,
                  std::span<const PlanVector> shifts = {}) {
  Found found{AxialDistribution{supports, span}, false, std::vector<double>(supports.size(), -1.0)};
  found.exists = found.distribution.distribute(sigma, b, shifts, found.compressions);
  return found;
}

void expect_compressions(const Found& found, const std::vector<double>& expected) {
  ASSERT_TRUE(found.exists);
  for (std::size_t i = 0; i < expected.size(); ++i) {
    EXPECT_NEAR(found.compressions[i], expected[i], 6e-10) << i;
    EXPECT_EQ(found.distribution.presses(i), expected[i] > 0.0) << i;
  }
}

TEST(AxialDistribution, OfFourBearingsOnALine) {
  const auto with_moment = [](double moment, const std::vector<AxialSupport>& supports = four_on_a_line()) {
    return distributed(supports, Span::line, overturned(supports, {moment, 0.0}));
  };
  expect_compressions(with_moment(25.0), {0.625, 1.875, 3.125, 4.375});
  expect_compressions(with_moment(40.0), {0.0, 2.5 / 3.0, 10.0 / 3.0, 17.5 / 3.0});
  EXPECT_NEAR(with_moment(40.0).distribution.deficit(0), 5.0 / 3.0, 1e-13);
  EXPECT_NEAR(with_moment(40.0).distribution.margin(0), -2.0 / 3.0, 1e-13);
  EXPECT_NEAR(with_moment(40.0).distribution.margin(3), 7.0 / 3.0, 1e-13);
  EXPECT_EQ(with_moment(40.0).distribution.deficit(3), 0.0);
  expect_compressions(with_moment(55.0), {0.0, 0.0, 1.25, 8.75});
  EXPECT_NEAR(with_moment(55.0).distribution.deficit(0), 13.75, 1e-12);
  expect_compressions(with_moment(-55.0), {8.75, 1.25, 0.0, 0.0});

  const auto unequal = four_on_a_line({2.0, 3.0, 3.0, 2.0}, {1.0, 2.0, 2.0, 1.0});
  expect_compressions(with_moment(15.0, unequal), {.977272727273, 2.318181818182, 3.681818181818, 3.022727272727});
  expect_compressions(with_moment(40.0, unequal), {0.0, 1.0 / 7.0, 33.0 / 7.0, 36.0 / 7.0});
}

TEST(AxialDistribution, DoesNotExistWhereTheSlabRocksOrFlies) {
  const auto supports = four_on_a_line();
  for (const double moment : {60.0, 60.000001, -60.0, 75.0, 1e4, -1e9}) {
    const Found rocks = distributed(supports, Span::line, overturned(supports, {moment, 0.0}));
    EXPECT_FALSE(rocks.exists) << moment;
    for (std::size_t i = 0; i < 4; ++i) {
      EXPECT_EQ(rocks.compressions[i], 0.0);
      EXPECT_EQ(rocks.distribution.by_moment(i), PlanVector{});
    }
  }
  EXPECT_TRUE(distributed(supports, Span::line, overturned(supports, {59.9999999, 0.0})).exists);
  EXPECT_FALSE(distributed(supports, Span::line, {0.0, {}}, 0.0).exists);
  EXPECT_FALSE(distributed(supports, Span::line, {-1.0, {}}, -0.1).exists);
  // While it flies, N and its rates are zero.
  const Found flies = distributed(supports, Span::line, {-1.0, {}}, -0.1);
  std::vector<double> rates(4, -1.0);
  flies.distribution.rates(0.5, {5.0, {1.0, 0.0}}, {}, rates);
  EXPECT_EQ(rates, std::vector<double>(4, 0.0));
  const auto plan = four_in_plan();
  EXPECT_FALSE(distributed(plan, Span::plan, overturned(plan, {20.0, 31.0})).exists);
  EXPECT_FALSE(distributed(plan, Span::plan, overturned(plan, {0.0, 30.0})).exists);
  EXPECT_TRUE(distributed(plan, Span::plan, overturned(plan, {49.9999, 29.9999})).exists);

  // It starts from the last distribution that existed.
  Found found = distributed(supports, Span::line, overturned(supports, {59.0, 0.0}));
  EXPECT_FALSE(found.distribution.distribute(1.0, overturned(supports, {61.0, 0.0}), {}, found.compressions));
  EXPECT_TRUE(found.distribution.distribute(1.0, overturned(supports, {-59.0, 0.0}), {}, found.compressions));
  EXPECT_NEAR(found.compressions[0], 9.75, 1e-13);
}

TEST(AxialDistribution, InPlan) {
  const auto with_moment = [](PlanVector moment, double last_stiffness = 1.0) {
    const auto supports = four_in_plan(last_stiffness);
    return distributed(supports, Span::plan, overturned(supports, moment));
  };
  expect_compressions(with_moment({20.0, 9.0}), {0.75, 2.75, 2.25, 4.25});
  expect_compressions(with_moment({30.0, 15.0}), {0.0, 2.5, 2.0, 5.5});
  EXPECT_NEAR(with_moment({30.0, 15.0}).distribution.deficit(0), 1.0, 1e-13);
  expect_compressions(with_moment({10.0, 6.0}, 3.0), {1.7, 2.3, 2.3, 3.7});
}

TEST(AxialDistribution, OfFortyEightBearings) {
  struct {
    PlanVector moment;
    double largest, smallest;
    int lifted;
    double deficit;
  } const cases[] = {{{400.0, 100.0}, 2.535897909, 0.040453842, 4, 0.800366355},
                     {{900.0, 300.0}, 10.479864312, 0.303122554, 36, 36.349047578}};
  const auto supports = forty_eight();
  for (const auto& each : cases) {
    const Found found = distributed(supports, Span::plan, overturned(supports, each.moment));
    ASSERT_TRUE(found.exists);
    double largest = 0.0, smallest = 1e9, deficit = 0.0;
    int lifted = 0;
    for (std::size_t i = 0; i < supports.size(); ++i) {
      largest = std::max(largest, found.compressions[i]);
      deficit = std::max(deficit, found.distribution.deficit(i));
      if (found.distribution.presses(i))
        smallest = std::min(smallest, found.compressions[i]);
      else
        ++lifted;
    }
    EXPECT_NEAR(largest, each.largest, 6e-10);
    EXPECT_NEAR(smallest, each.smallest, 6e-10);
    EXPECT_EQ(lifted, each.lifted);
    EXPECT_NEAR(deficit, each.deficit, 6e-10);
  }
}

TEST(AxialDistribution, OfBearingsThatMayPull) {
  auto supports = four_on_a_line();
  for (AxialSupport& support : supports) support.cavitation = 0.3;
  const Found found = distributed(supports, Span::line, overturned(supports, {40.0, 0.0}));
  expect_compressions(found, {-.329850746269, 1.273134328358, 3.443283582090, 5.613432835821});
  EXPECT_EQ(found.distribution.deficit(0), 0.0);
  // A slab that is held down does not rock, and it hangs.
  EXPECT_TRUE(distributed(supports, Span::line, overturned(supports, {90.0, 0.0})).exists);
  const Found hanging = distributed(supports, Span::line, {-0.8, {}}, -0.08);
  expect_compressions(hanging, {-0.2, -0.2, -0.2, -0.2});
  // Half as stiff in tension: e = -0.1 is N = -0.05 at -6 m, and it cavitates at N = -0.3.
  for (AxialSupport& support : supports) support.tension_stiffness_ratio = 0.5;
  const double e = -0.7, slope = (2.5 - e) / 6.0;  // e at -6 m; at 2 and 6 m from the centre of the slab's motion
  std::vector<double> expected{-0.3 + 0.05 * (e + 0.6), 2.5 - slope * 2.0, 2.5 + slope * 2.0, 2.5 + slope * 6.0};
  Resultant b{};
  for (std::size_t i = 0; i < 4; ++i) {
    b.load += expected[i];
    b.moment += expected[i] * supports[i].at;
  }
  expect_compressions(distributed(supports, Span::line, b), expected);
}

TEST(AxialDistribution, ActsAtTheShiftedSupports) {
  // A block on two sliders, surface above: 13.1 of statics. N(+b) = W/2 - W a h/(2 b g) + W d/(2 b).
  const std::vector<AxialSupport> two{{.at = {-4.0, 0.0}, .share = 5e6}, {.at = {4.0, 0.0}, .share = 5e6}};
  const double weight = 10e6, g = 9.80665, moment = -weight / g * 2.0 * 6.0;
  const Found still = distributed(two, Span::line, {weight, {moment, 0.0}});
  EXPECT_NEAR(still.compressions[0], 6.5295743e6, 0.06);
  EXPECT_NEAR(still.compressions[1], 3.4704257e6, 0.06);
  const std::vector<PlanVector> shifts(2, {-0.3, 0.0});
  const Found moved = distributed(two, Span::line, {weight, {moment, 0.0}}, 1.0, shifts);
  EXPECT_NEAR(moved.compressions[1], 3.8454257e6, 0.06);
}

// The same minimum by brute force: every set of supports that press, each with its equations of equality. Empty without
// a distribution.
std::vector<double> by_all_sets(const std::vector<AxialSupport>& supports, double sigma, const Eigen::Vector3d& b,
                                int rows) {
  const std::size_t n = supports.size();
  for (unsigned set = 1; set < 1U << n; ++set) {
    std::vector<std::size_t> pressed;
    for (std::size_t i = 0; i < n; ++i)
      if (set >> i & 1U) pressed.push_back(i);
    const auto m = static_cast<Eigen::Index>(pressed.size());
    // Stationary values of sum (N - sigma W)^2/(2k) - c.(A N - b): unknowns N and c.
    Eigen::MatrixXd system = Eigen::MatrixXd::Zero(m + rows, m + rows);
    Eigen::VectorXd right(m + rows);
    const auto arm = [&](std::size_t i) { return Eigen::Vector3d{1.0, supports[i].at.x, supports[i].at.y}; };
    for (Eigen::Index j = 0; j < m; ++j) {
      const std::size_t i = pressed[static_cast<std::size_t>(j)];
      system(j, j) = 1.0 / supports[i].stiffness;
      right(j) = sigma * supports[i].share / supports[i].stiffness;
      system.block(j, m, 1, rows) = -arm(i).head(rows).transpose();
      system.block(m, j, rows, 1) = arm(i).head(rows);
    }
    right.tail(rows) = b.head(rows);
    const Eigen::FullPivLU<Eigen::MatrixXd> factors{system};
    if (!factors.isInvertible()) continue;
    const Eigen::VectorXd solution = factors.solve(right);
    bool optimal = solution.head(m).minCoeff() >= 0.0;
    for (std::size_t i = 0; i < n; ++i)
      optimal = optimal &&
                ((set >> i & 1U) ||
                 sigma * supports[i].share + supports[i].stiffness * arm(i).head(rows).dot(solution.tail(rows)) <= 0.0);
    if (!optimal) continue;
    std::vector<double> result(n, 0.0);
    for (Eigen::Index j = 0; j < m; ++j) result[pressed[static_cast<std::size_t>(j)]] = solution(j);
    return result;
  }
  return {};
}

TEST(AxialDistribution, IsTheMinimumOfTheQuadraticProgram) {
  std::mt19937 random{7};
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>{low, high}(random);
  };
  int with = 0, without = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const bool line = trial % 2 == 0;
    const std::size_t count = trial % 4 == 0 ? 2 : line ? 4 : 4 + static_cast<std::size_t>(trial) % 3;
    std::vector<AxialSupport> supports(count);
    for (AxialSupport& support : supports)
      support = {.at = {between(80.0, 120.0), line ? 0.0 : between(-30.0, -10.0)},
                 .stiffness = between(0.5, 3.0) * 1e9,
                 .share = between(0.5, 2.0) * 1e6};
    AxialDistribution distribution{supports, line ? Span::line : Span::plan};
    std::vector<double> compressions(count);
    // Several resultants, so that each starts from the slab's position under another one.
    for (int each = 0; each < 12; ++each) {
      const double sigma = between(0.3, 1.8), arm = between(0.0, 20.0);
      Resultant b = overturned(supports, {}, sigma);
      b.moment += arm * b.load * PlanVector{between(-1.0, 1.0), line ? 0.0 : between(-1.0, 1.0)};
      const std::vector<double> expected = by_all_sets(supports, sigma, {b.load, b.moment.x, b.moment.y}, line ? 2 : 3);
      ASSERT_EQ(distribution.distribute(sigma, b, {}, compressions), !expected.empty()) << trial << " " << each;
      ++(expected.empty() ? without : with);
      for (std::size_t i = 0; i < expected.size(); ++i) ASSERT_NEAR(compressions[i], expected[i], 1e-8 * b.load);
      // A resultant without a distribution goes to the edge of the hull, the others stay.
      const Resultant moved = distribution.moved_into_hull(b, {});
      ASSERT_EQ(moved.moment == b.moment, !expected.empty());
      ASSERT_TRUE(distribution.distribute(sigma, moved, {}, compressions));
    }
  }
  EXPECT_GT(with, 1000);
  EXPECT_GT(without, 500);
}

// Alternating projections of Dykstra, in the metric of 1/k, onto the resultants b and onto N >= 0, from sigma W.
Eigen::VectorXd by_projections(const std::vector<AxialSupport>& supports, double sigma, const Eigen::Vector3d& b) {
  const auto n = static_cast<Eigen::Index>(supports.size());
  Eigen::MatrixXd arms(3, n);
  Eigen::VectorXd stiffness(n), compression(n), correction = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const AxialSupport& support = supports[static_cast<std::size_t>(i)];
    arms.col(i) << 1.0, support.at.x, support.at.y;
    stiffness(i) = support.stiffness;
    compression(i) = sigma * support.share;
  }
  const Eigen::MatrixXd weighted = stiffness.asDiagonal() * arms.transpose();
  const Eigen::Matrix3d inverse = (arms * weighted).inverse();
  for (int iteration = 0; iteration < 20000; ++iteration) {
    compression += weighted * (inverse * (b - arms * compression));
    const Eigen::VectorXd uncorrected = compression + correction;
    compression = uncorrected.cwiseMax(0.0);
    correction = uncorrected - compression;
  }
  return compression;
}

TEST(AxialDistribution, OfFortyEightIsTheProjection) {
  const auto supports = forty_eight();
  AxialDistribution distribution{supports, Span::plan};
  std::vector<double> compressions(supports.size());
  for (const PlanVector moment : {PlanVector{400.0, 100.0}, {-300.0, 350.0}, {100.0, -500.0}, {0.0, 0.0}}) {
    const double sigma = 1.2;
    const Resultant b = overturned(supports, moment, sigma);
    const Eigen::VectorXd expected = by_projections(supports, sigma, {b.load, b.moment.x, b.moment.y});
    ASSERT_TRUE(distribution.distribute(sigma, b, {}, compressions));
    for (std::size_t i = 0; i < supports.size(); ++i)
      EXPECT_NEAR(compressions[i], expected(static_cast<Eigen::Index>(i)), 1e-9) << moment.x << " " << i;
  }
}

TEST(AxialDistribution, BalancesAnyResultantInTheHull) {
  // 92 bearings at random; the resultant is that of random pressures, so that a distribution exists. The conditions of
  // the minimum are checked: balance, and N = max(e, 0) with one linear function e - sigma W = k A.c of the plan.
  std::mt19937 random{11};
  std::uniform_real_distribution<double> unit{0.0, 1.0};
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<AxialSupport> supports(92);
    Resultant b{};
    const double few = std::pow(unit(random), 3.0);
    for (AxialSupport& support : supports) {
      support = {.at = {60.0 * unit(random), 25.0 * unit(random)},
                 .stiffness = 0.5 + unit(random),
                 .share = 0.5 + unit(random)};
      const double pressure = unit(random) < few ? unit(random) : 0.0;
      b.load += pressure;
      b.moment += pressure * support.at;
    }
    // A lone corner may be on the edge itself.
    b.load += 0.5;
    b.moment += 0.5 * PlanVector{30.0, 12.0};
    const Found found = distributed(supports, Span::plan, b, 0.7);
    ASSERT_TRUE(found.exists) << trial;
    Resultant sum{};
    for (std::size_t i = 0; i < supports.size(); ++i) {
      ASSERT_GE(found.compressions[i], 0.0);
      sum.load += found.compressions[i];
      sum.moment += found.compressions[i] * supports[i].at;
    }
    EXPECT_NEAR(sum.load, b.load, 1e-10);
    EXPECT_NEAR(sum.moment.x, b.moment.x, 1e-9);
    EXPECT_NEAR(sum.moment.y, b.moment.y, 1e-9);
    Eigen::MatrixXd arms(92, 3);
    Eigen::VectorXd motion(92);
    for (std::size_t i = 0; i < 92; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      const double e = supports[i].share * found.distribution.margin(i);
      arms.row(row) << 1.0, supports[i].at.x, supports[i].at.y;
      motion(row) = (e - 0.7 * supports[i].share) / supports[i].stiffness;
      ASSERT_NEAR(found.compressions[i], std::max(e, 0.0), 1e-12);
    }
    const Eigen::VectorXd fit = arms * arms.colPivHouseholderQr().solve(motion);
    EXPECT_LT((fit - motion).lpNorm<Eigen::Infinity>(), 1e-10 * (1.0 + motion.lpNorm<Eigen::Infinity>()));
  }
}

TEST(AxialDistribution, HasItsDerivatives) {
  struct {
    std::vector<AxialSupport> supports;
    Span span;
    PlanVector moment;
  } cases[] = {{four_on_a_line({2.0, 3.0, 3.0, 2.0}, {1.0, 2.0, 2.0, 1.0}), Span::line, {40.0, 0.0}},
               {forty_eight(), Span::plan, {700.0, -200.0}},
               {forty_eight(), Span::plan, {500.0, 200.0}}};
  for (std::size_t i = 0; i < cases[2].supports.size(); i += 2) {
    cases[2].supports[i].cavitation = 0.1;
    cases[2].supports[i].tension_stiffness_ratio = 0.6;
  }
  for (const auto& each : cases) {
    const bool plan = each.span == Span::plan;
    const std::size_t n = each.supports.size();
    std::vector<PlanVector> shifts(n), shift_rates(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double x = static_cast<double>(i);
      shifts[i] = {0.2 * std::sin(x), plan ? 0.1 * std::cos(3.0 * x) : 0.0};
      shift_rates[i] = {0.7 * std::cos(x), plan ? 0.5 * std::sin(2.0 * x) : 0.0};
    }
    const double sigma = 0.9, sigma_rate = 0.4;
    const Resultant b = overturned(each.supports, each.moment, sigma);
    const Resultant b_rate{sigma_rate * b.load / sigma, {7.0, plan ? -9.0 : 0.0}};
    const Found found = distributed(each.supports, each.span, b, sigma, shifts);
    ASSERT_TRUE(found.exists);
    const double step = 1e-5, tolerance = 1e-8;
    const auto moved = [&](double time, double load, PlanVector moment, bool all) {
      std::vector<PlanVector> there = shifts;
      for (std::size_t i = 0; i < n && all; ++i) there[i] += time * shift_rates[i];
      const double at = all ? time : 0.0;
      return distributed(each.supports, each.span,
                         {b.load + load + at * b_rate.load, b.moment + moment + at * b_rate.moment},
                         sigma + at * sigma_rate, there)
          .compressions;
    };
    const auto difference = [&](double load, PlanVector moment, bool all) {
      std::vector<double> after = moved(step, step * load, step * moment, all);
      const std::vector<double> before = moved(-step, -step * load, -step * moment, all);
      for (std::size_t i = 0; i < n; ++i) after[i] = (after[i] - before[i]) / (2.0 * step);
      return after;
    };
    const auto by_x = difference(0.0, {1.0, 0.0}, false), by_load = difference(1.0, {}, false),
               by_y = plan ? difference(0.0, {0.0, 1.0}, false) : std::vector<double>(n, 0.0),
               rates = difference(0.0, {}, true);
    std::vector<double> compression_rates(n);
    found.distribution.rates(sigma_rate, b_rate, shift_rates, compression_rates);
    double sum = 0.0;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR(found.distribution.by_moment(i).x, by_x[i], tolerance);
      EXPECT_NEAR(found.distribution.by_moment(i).y, by_y[i], tolerance);
      EXPECT_NEAR(found.distribution.by_load(i), by_load[i], tolerance);
      // A lifted support has the rate of its opening.
      if (found.distribution.deficit(i) > 0.0) continue;
      EXPECT_NEAR(compression_rates[i], rates[i], tolerance);
      sum += compression_rates[i];
    }
    EXPECT_NEAR(sum, b_rate.load, 1e-12);
    // Without rates of shifts.
    std::vector<double> with_rest(n), without(n);
    found.distribution.rates(sigma_rate, b_rate, std::vector<PlanVector>(n), with_rest);
    found.distribution.rates(sigma_rate, b_rate, {}, without);
    EXPECT_EQ(with_rest, without);
  }
}

TEST(AxialDistribution, MovesAResultantToTheEdgeOfTheHull) {
  const AxialDistribution plan{four_in_plan(), Span::plan};
  // The ray from the origin through (10, 4) leaves the rectangle of 10 x 6 m at (5, 2), that through (10, 8) at (3.75,
  // 3).
  Resultant moved = plan.moved_into_hull({2.0, {20.0, 8.0}}, {});
  EXPECT_EQ(moved.load, 2.0);
  EXPECT_NEAR(moved.moment.x, 10.0, 2e-8);
  EXPECT_NEAR(moved.moment.y, 4.0, 2e-8);
  EXPECT_LT(moved.moment.x, 10.0);
  moved = plan.moved_into_hull({2.0, {20.0, 16.0}}, {});
  EXPECT_NEAR(moved.moment.x, 7.5, 2e-8);
  EXPECT_NEAR(moved.moment.y, 6.0, 2e-8);
  // Moved supports move the hull.
  const std::vector<PlanVector> shifts(4, {1.0, 0.0});
  moved = plan.moved_into_hull({2.0, {22.0, 8.0}}, shifts);
  EXPECT_NEAR(moved.moment.x, 12.0, 2e-8);
  EXPECT_EQ(plan.moved_into_hull({2.0, {9.9, -5.9}}, {}).moment, (PlanVector{9.9, -5.9}));
  EXPECT_EQ(plan.moved_into_hull({2.0, {0.0, 0.0}}, {}).moment, PlanVector{});
  EXPECT_EQ(plan.moved_into_hull({-2.0, {9.9, -5.9}}, {}).load, 0.0);
  const AxialDistribution line{four_on_a_line(), Span::line};
  EXPECT_NEAR(line.moved_into_hull({10.0, {75.0, 0.0}}, {}).moment.x, 60.0, 1e-7);
  EXPECT_NEAR(line.moved_into_hull({10.0, {-75.0, 0.0}}, {}).moment.x, -60.0, 1e-7);
}

TEST(AxialDistribution, BalancedSharesHaveTheirCentreWhereTheMassIs) {
  std::vector<PlanVector> positions;
  std::vector<double> stiffnesses;
  for (const AxialSupport& support : forty_eight()) {
    positions.push_back(support.at + PlanVector{100.0, 0.0});
    stiffnesses.push_back(support.stiffness);
  }
  const PlanVector centre{101.5, -2.0};
  const std::vector<double> shares = balanced_shares(positions, stiffnesses, 48.0, centre, Span::plan);
  double sum = 0.0;
  PlanVector moment{};
  for (std::size_t i = 0; i < shares.size(); ++i) {
    sum += shares[i];
    moment += shares[i] * positions[i];
  }
  EXPECT_NEAR(sum, 48.0, 1e-12);
  EXPECT_NEAR(moment.x / sum, centre.x, 1e-12);
  EXPECT_NEAR(moment.y / sum, centre.y, 1e-12);
  // Two on a line: the lever rule. Equal springs around the centre: equal shares.
  const std::vector<double> two = balanced_shares(std::vector<PlanVector>{{-4.0, 0.0}, {4.0, 0.0}},
                                                  std::vector<double>{1.0, 5.0}, 8.0, {1.0, 0.0}, Span::line);
  EXPECT_NEAR(two[0], 3.0, 1e-14);
  EXPECT_NEAR(two[1], 5.0, 1e-14);
}

TEST(AxialDistribution, NeedsPositionsThatCarryMoments) {
  EXPECT_TRUE(carries_moments(std::vector<PlanVector>{{1.0, 0.0}, {2.0, 0.0}}, Span::line));
  EXPECT_FALSE(carries_moments(std::vector<PlanVector>{{1.0, 0.0}, {1.0, 0.0}}, Span::line));
  EXPECT_FALSE(carries_moments({}, Span::line));
  EXPECT_TRUE(carries_moments(std::vector<PlanVector>{{1.0, 0.0}, {2.0, 1.0}, {3.0, 2.1}}, Span::plan));
  EXPECT_FALSE(carries_moments(std::vector<PlanVector>{{1.0, 0.0}, {2.0, 1.0}, {3.0, 2.0}}, Span::plan));
}

}  // namespace
}  // namespace moat
