// The smart base-isolated benchmark building and a frame of twelve storeys, against independent programs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "benchmark_building.hpp"
#include "peak_in.hpp"
#include "solvers/modes.hpp"
#include "structures/superstructure/superstructure.hpp"

namespace moat {
namespace {

using namespace units;
using testing::BenchmarkBuilding;
using testing::BenchmarkRun;
using testing::ExpectedPeak;
using testing::peak;
using testing::run_benchmark;

class BenchmarkBuildingTest : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = testing::why_experiment_is_missing("smart_base_isolated"); !why.empty())
      GTEST_SKIP() << why;
  }

  // The largest resultant of a drift at the centre of mass.
  [[nodiscard]] static double drift(const CaseResult& result, const std::string& floor) {
    const std::vector<double>&x = result.histories.values("drift_x", floor),
          &y = result.histories.values("drift_y", floor);
    double largest = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) largest = std::max(largest, std::hypot(x[i], y[i]));
    return largest;
  }
};

void expect_peaks(const CaseResult& result, const std::vector<ExpectedPeak>& list, double tolerance) {
  for (const ExpectedPeak& each : list)
    EXPECT_NEAR(peak(result, each.quantity, each.where), each.value, tolerance * each.value)
        << each.quantity << " at " << each.where;
}

void expect_isolated_periods(const Superstructure& building, const std::vector<std::pair<std::size_t, double>>& list) {
  Model model;
  add(model, building);
  SparseMatrix mass = model.zero_matrix();
  model.mass_matrix().add_to(1.0, mass);
  const std::vector<Mode> modes = slowest_modes(model.linear_stiffness(StiffnessStage::initial), mass, 6);
  for (const auto& [mode, period] : list) EXPECT_NEAR(modes.at(mode).period(), period, 6e-7) << mode;
}

TEST_F(BenchmarkBuildingTest, HasTheSensitivityToContactsOfRunsByHand) {
  const auto building = [](Length clearance, Stiffness stiffness) {
    Model model;
    const SuperstructureParts parts = add(model, BenchmarkBuilding{}.from_matrices());
    BenchmarkBuilding{}.add_dashpots(model, parts.base);
    BenchmarkBuilding::add_walls(model, parts.base, clearance, stiffness);
    return model;
  };
  const Stiffness stiffness = 500 * MN / m;
  const ContactSensitivity sensitivity =
      run_case(building(30 * cm, stiffness), testing::newhall(true),
               {.error_bars = ErrorBarMode::never, .contact_sensitivity = ContactSensitivityMode::always})
          .contact_sensitivity;
  const std::vector<std::pair<Length, Stiffness>> by_hand{
      {30 * cm, stiffness / 3.0}, {30 * cm, 3.0 * stiffness}, {27 * cm, stiffness}, {33 * cm, stiffness}};
  ASSERT_EQ(sensitivity.changes.size(), by_hand.size()) << "an elastic law has no restitution";
  for (std::size_t i = 0; i < by_hand.size(); ++i) {
    const auto& [clearance, changed_stiffness] = by_hand[i];
    const PeaksAndImpacts run = compute_peaks(building(clearance, changed_stiffness), testing::newhall(true), {});
    EXPECT_EQ(sensitivity.changes[i].impacts, run.touches.size());
    ASSERT_EQ(sensitivity.peaks.size(), run.peaks.size());
    for (std::size_t p = 0; p < run.peaks.size(); ++p)
      EXPECT_NEAR(sensitivity.peaks[p].changed[i], run.peaks[p].value, 1e-6 * std::abs(run.peaks[p].value))
          << run.peaks[p].quantity << " at " << run.peaks[p].where << ", change " << i;
  }
}

TEST_F(BenchmarkBuildingTest, FromMatrices) {
  const BenchmarkRun open = run_benchmark(BenchmarkBuilding{}.from_matrices(), false, true);
  const std::vector<double> periods = open.parts.periods();
  for (const auto& [mode, period] : {std::pair{0, 0.897356}, {1, 0.780084}, {2, 0.658486}})
    EXPECT_NEAR(periods[static_cast<std::size_t>(mode)], period, 6e-7);
  expect_peaks(open.result, testing::without_walls, 1e-4);
  EXPECT_NEAR(drift(open.result, "floor 1"), 0.00497187, 1e-4 * 0.00497187);
  EXPECT_NEAR(drift(open.result, "floor 8"), 0.00539085, 1e-4 * 0.00539085);
  expect_isolated_periods(BenchmarkBuilding{}.from_matrices(),
                          {{0, 3.380681}, {1, 3.184160}, {2, 2.672401}, {3, 0.569417}, {4, 0.496820}, {5, 0.428299}});
}

TEST_F(BenchmarkBuildingTest, FromMatricesWithWalls) {
  const BenchmarkRun open = run_benchmark(BenchmarkBuilding{}.from_matrices(), true, true);
  expect_peaks(open.result, testing::with_walls, 1e-3);
  EXPECT_EQ(open.result.impacts.size(), testing::impacts_with_walls);
  EXPECT_NEAR(drift(open.result, "floor 1"), 0.00888729, 1e-3 * 0.00888729);
  EXPECT_NEAR(drift(open.result, "floor 8"), 0.01537396, 1e-3 * 0.01537396);
}

TEST_F(BenchmarkBuildingTest, FromAllModes) {
  const BenchmarkRun open = run_benchmark(BenchmarkBuilding{}.from_modes(), false, true);
  expect_peaks(open.result, testing::without_walls, 1e-4);
  EXPECT_NEAR(open.parts.periods()[0], 0.89735621, 1e-8);
  const BenchmarkRun walls = run_benchmark(BenchmarkBuilding{}.from_modes(), true, true);
  expect_peaks(walls.result, testing::with_walls, 1e-3);
  EXPECT_EQ(walls.result.impacts.size(), testing::impacts_with_walls);
}

TEST_F(BenchmarkBuildingTest, FromNineModes) {
  Superstructure building = BenchmarkBuilding{}.from_modes();
  building.modes->keep = 9;
  const BenchmarkRun open = run_benchmark(building, false, true);
  expect_peaks(open.result,
               {{"displacement", "base", 0.486766},
                {"rotation", "base", 0.00859752},
                {"absolute_acceleration_x", "floor 8", 2.822986},
                {"absolute_acceleration_y", "floor 8", 0.986490},
                {"absolute_acceleration_x", "base", 2.208831}},
               1e-3);
  const BenchmarkRun walls = run_benchmark(building, true, true);
  expect_peaks(walls.result,
               {{"displacement", "base", 0.375218},
                {"absolute_acceleration_x", "floor 8", 10.313344},
                {"impact_force", "moat", 28199.83e3}},
               1e-3);
  EXPECT_EQ(walls.result.impacts.size(), 9U);
}

TEST_F(BenchmarkBuildingTest, FromThreeModes) {
  Superstructure building = BenchmarkBuilding{}.from_modes();
  building.modes->keep = 3;
  expect_isolated_periods(building, {{0, 3.379091}, {3, 0.550385}});
  const BenchmarkRun walls = run_benchmark(building, true, true);
  expect_peaks(walls.result,
               {{"displacement", "base", 0.378074},
                {"displacement_x", "base", 0.347514},
                {"displacement_y", "base", 0.285896},
                {"rotation", "base", 0.00627018},
                {"absolute_acceleration_x", "floor 8", 6.603536},
                {"absolute_acceleration_y", "floor 8", 2.597944},
                {"absolute_acceleration_x", "base", 5.706684},
                {"absolute_acceleration_y", "base", 2.245152},
                {"impact_force", "moat", 29579.11e3}},
               1e-3);
  EXPECT_NEAR(drift(walls.result, "floor 1"), 0.00870645, 1e-3 * 0.00870645);
  EXPECT_EQ(walls.result.impacts.size(), 8U);
}

TEST_F(BenchmarkBuildingTest, OrthonormalisedModes) {
  Superstructure building = BenchmarkBuilding{}.from_modes();
  building.modes->orthonormalise = true;
  const BenchmarkRun open = run_benchmark(building, false, true);
  expect_peaks(open.result,
               {{"displacement", "base", 0.486358},
                {"absolute_acceleration_x", "floor 8", 2.794098},
                {"absolute_acceleration_y", "floor 8", 0.978171},
                {"absolute_acceleration_x", "base", 2.200887}},
               1e-3);
  expect_isolated_periods(building, {{0, 3.380172}, {3, 0.565470}});
  const BenchmarkRun walls = run_benchmark(building, true, true);
  expect_peaks(walls.result,
               {{"displacement", "base", 0.375451},
                {"displacement_x", "base", 0.345019},
                {"displacement_y", "base", 0.286127},
                {"rotation", "base", 0.00617383},
                {"absolute_acceleration_x", "floor 8", 10.065998},
                {"absolute_acceleration_y", "floor 8", 2.724054},
                {"absolute_acceleration_x", "base", 5.056770},
                {"absolute_acceleration_y", "base", 1.966167},
                {"impact_force", "moat", 28203.91e3}},
               1e-3);
  EXPECT_NEAR(drift(walls.result, "floor 1"), 0.00888134, 1e-3 * 0.00888134);
  EXPECT_EQ(walls.result.impacts.size(), 8U);
}

TEST_F(BenchmarkBuildingTest, OnLeadRubberBearings) {
  expect_peaks(run_benchmark(BenchmarkBuilding{}.on_lead_rubber(), false, false).result, testing::on_lead_rubber, 1e-3);
}

class Frame12 : public ::testing::Test {
 protected:
  void SetUp() override {
    if (const std::string why = testing::why_experiment_is_missing("frame12"); !why.empty()) GTEST_SKIP() << why;
  }

  [[nodiscard]] static CaseResult run(bool has_walls, std::vector<double>& periods) {
    Superstructure building{
        .stiffness =
            read_matrix(testing::folder_of_experiment("frame12") + "stiffness_kN_m.csv", {.force = kN, .length = m}),
        .freedoms = per_floor(Freedoms::x),
        .damping = ModalDamping{0.05},
        .base = SuperstructureBase{.mass = 80 * tonne},
        .isolation = LeadRubberBearing{
            .yield_force = 500 * kN, .yield_displacement = 10 * mm, .post_yield_stiffness = 3.4 * MN / m}};
    for (int floor = 1; floor <= 12; ++floor)
      building.floors.push_back({.height = (4.5 + 3.5 * (floor - 1)) * m, .mass = (floor == 12 ? 50.0 : 60.0) * tonne});
    Model model;
    const SuperstructureParts parts = add(model, building);
    periods = parts.periods();
    EXPECT_NEAR(parts.modes[0].x, 0.79994, 1e-5);
    if (has_walls)
      add(model, Moat{.around = parts.base, .clearance = 25 * cm, .law = LinearElastic{.stiffness = 2e8 * N / m}});
    CaseRun run{model, testing::newhall(false)};
    run.run();
    return run.result();
  }
};

TEST_F(Frame12, OnBearings) {
  std::vector<double> periods;
  const CaseResult result = run(false, periods);
  for (const auto& [mode, period] : {std::pair{0, 1.08026131}, {1, 0.36226188}, {5, 0.07820498}})
    EXPECT_NEAR(periods[static_cast<std::size_t>(mode)], period, 1e-8);
  expect_peaks(result,
               {{"displacement", "base", 0.2915797},
                {"displacement", "floor 12", 0.3598867},
                {"absolute_acceleration", "base", 6.193},
                {"absolute_acceleration", "floor 6", 2.334774},
                {"absolute_acceleration", "floor 12", 7.118568},
                {"drift", "storey 1", 0.007497492},
                {"drift", "storey 6", 0.01402007},
                {"storey_shear", "storey 1", 1331.840e3},
                {"storey_shear", "storey 7", 1558.451e3},
                {"overturning_moment", "storey 1", 50.91561e6}},
               1e-3);
}

TEST_F(Frame12, AgainstItsWalls) {
  std::vector<double> periods;
  const CaseResult result = run(true, periods);
  expect_peaks(result,
               {{"displacement", "base", 0.2601413},
                {"displacement", "floor 12", 0.3589647},
                {"absolute_acceleration", "base", 16.03976},
                {"absolute_acceleration", "floor 6", 11.50064},
                {"absolute_acceleration", "floor 12", 16.69191},
                {"drift", "storey 1", 0.01306285},
                {"storey_shear", "storey 1", 2580.755e3},
                {"overturning_moment", "storey 1", 56.92264e6},
                {"impact_force", "moat", 2028.263e3}},
               1e-3);
  EXPECT_EQ(result.impacts.size(), 1U);
}

}  // namespace
}  // namespace moat
