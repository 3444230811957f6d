#include "analyses/modes/periods.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <numbers>
#include <string>

#include "elements/line/shear_spring.hpp"
#include "paper_building.hpp"

namespace moat {
namespace {

using namespace units;
using namespace testing;
using std::numbers::pi;

std::map<std::string, double> by_name(const std::vector<NamedPeriod>& periods) {
  std::map<std::string, double> map;
  for (const NamedPeriod& period : periods) map[period.name] = period.value;
  EXPECT_EQ(map.size(), periods.size()) << "two periods of the same name";
  return map;
}

// The first period of base and five floors by Eigen's dense generalised solver, from matrices written out here.
double first_period_with_bearings(double bearing_stiffness) {
  Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(6, 6), mass = Eigen::MatrixXd::Zero(6, 6);
  stiffness(0, 0) = bearing_stiffness;
  for (int storey = 1; storey <= 5; ++storey) {
    stiffness(storey - 1, storey - 1) += storey_stiffness;
    stiffness(storey, storey) += storey_stiffness;
    stiffness(storey - 1, storey) = stiffness(storey, storey - 1) = -storey_stiffness;
    mass(storey, storey) = floor_mass;
  }
  mass(0, 0) = base_mass;
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver{stiffness, mass};
  return 2.0 * pi / std::sqrt(solver.eigenvalues()[0]);
}

TEST(Periods, OfThePapersBuildingByName) {
  Model model = pounding_building();
  const auto periods = by_name(characteristic_periods(model));
  ASSERT_EQ(periods.size(), 4u);

  EXPECT_NEAR(periods.at("fixed base"),
              2.0 * pi / (2.0 * std::sqrt(storey_stiffness / floor_mass) * std::sin(pi / 22.0)), 1e-9);
  EXPECT_NEAR(periods.at("isolation, rigid building"),
              2.0 * pi * std::sqrt((base_mass + 5.0 * floor_mass) / post_yield_stiffness), 1e-9);
  EXPECT_NEAR(periods.at("first mode, post-yield bearings"), first_period_with_bearings(post_yield_stiffness), 1e-8);
  EXPECT_NEAR(periods.at("first mode, initial bearings"), first_period_with_bearings(yield_force / yield_displacement),
              1e-9);

  EXPECT_NEAR(fixed_base_period(model, model.buildings().front()), periods.at("fixed base"), 1e-12);
  EXPECT_NEAR(periods.at("fixed base"), 0.494, 0.0005);
  EXPECT_NEAR(periods.at("isolation, rigid building"), 2.498, 0.0005);
  EXPECT_NEAR(periods.at("first mode, post-yield bearings"), 2.533, 0.0005);
  EXPECT_NEAR(periods.at("first mode, initial bearings"), 0.904, 0.0005);
}

TEST(Periods, OfABuildingOnAFixedBase) {
  Model model;
  add(model, paper_building_on_fixed_base());
  const auto periods = by_name(characteristic_periods(model));
  ASSERT_EQ(periods.size(), 1u);
  EXPECT_NEAR(periods.at("first mode"), 0.494, 0.0005);
}

TEST(Periods, SeveralBuildingsDifferByTheirFirstNode) {
  Model model;
  const Building north = add(model, paper_building("north"));
  ShearBuilding stiffer = paper_building("south");
  stiffer.storey_stiffness = 4.0 * storey_stiffness * N / m;
  const Building south = add(model, stiffer);
  // A gap joins them in an impact, but not in their periods.
  add(model,
      Gap<HertzDamp>{
          .name = "between", .left = north.base, .right = south.base, .clearance = 10 * cm, .law = paper_hertz_damp()});
  const auto periods = by_name(characteristic_periods(model));
  EXPECT_EQ(periods.size(), 8u);
  EXPECT_NEAR(periods.at("north: fixed base"), 0.494, 0.0005);
  EXPECT_NEAR(periods.at("south: fixed base"), periods.at("north: fixed base") / 2.0, 1e-9);
  EXPECT_NEAR(periods.at("north: first mode, initial bearings"), 0.904, 0.0005);
  EXPECT_EQ(by_name(characteristic_periods(model, 1)).size(), 4u);
}

TEST(Periods, FreeBodiesHaveNone) {
  Model model;
  const Building nodes = add(model, paper_building());
  const NodeId truck = add(model, Node{.name = "truck", .mass = 20 * tonne});
  const NodeId trailer = add(model, Node{.name = "trailer", .mass = 13 * tonne});
  const NodeId cart = add(model, Node{.name = "cart", .mass = 7 * tonne});
  add(model, ShearSpring{.name = "hitch", .lower = truck, .upper = trailer, .stiffness = 3 * MN / m});
  add(model, ShearSpring{.name = "rope", .lower = trailer, .upper = cart, .stiffness = 2 * MN / m});
  add(model,
      Gap<HertzDamp>{
          .name = "bumper", .left = truck, .right = nodes.base, .clearance = 10 * cm, .law = paper_hertz_damp()});
  const auto periods = by_name(characteristic_periods(model));
  EXPECT_EQ(periods.size(), 4u);
  EXPECT_EQ(periods.count("fixed base"), 1u);
  for (const auto& [name, period] : periods) EXPECT_FALSE(name.starts_with("truck")) << name << " " << period;
}

TEST(Periods, ABodyOnBearingsAloneHasNoFixedBasePeriod) {
  Model model;
  const NodeId base = add(model, Node{.name = "base", .mass = base_mass * kg});
  add(model, LeadRubberBearing{.upper = base,
                               .yield_force = yield_force * N,
                               .yield_displacement = yield_displacement * m,
                               .post_yield_stiffness = post_yield_stiffness * N / m});
  const auto periods = by_name(characteristic_periods(model));
  EXPECT_EQ(periods.size(), 3u);
  EXPECT_EQ(periods.count("fixed base"), 0u);
  EXPECT_NEAR(periods.at("first mode, post-yield bearings"), periods.at("isolation, rigid building"), 1e-9);
}

}  // namespace
}  // namespace moat
