// Gaps between two buildings on a line, from the heights of their floors.
#include "structures/neighbours/neighbours.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "ended_case.hpp"
#include "materials/impact/exact_hertz_damp.hpp"
#include "materials/impact/exact_kelvin.hpp"
#include "message_of.hpp"
#include "small_models.hpp"
#include "structures/plan_building.hpp"
#include "structures/shear_building.hpp"
#include "structures/superstructure/superstructure.hpp"

namespace moat {
namespace {

using namespace units;
using testing::EndedCase;
using testing::message_of;
using testing::run_to_end;

ExactHertzDamp law() { return {.stiffness = 1e9 * N / m_3_2, .restitution = 0.6}; }

Building shear_building(Model& model, const std::string& name, std::vector<Length> storey_heights, bool isolated) {
  const int storeys = static_cast<int>(storey_heights.size());
  ShearBuilding building{.name = name,
                         .storeys = storeys,
                         .floor_mass = 300 * tonne,
                         .storey_stiffness = 400 * MN / m,
                         .damping = {.ratio = 0.05},
                         .storey_height = std::move(storey_heights)};
  if (isolated) {
    building.base_mass = 350 * tonne;
    building.isolation =
        LeadRubberBearing{.yield_force = 400 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 8 * MN / m};
  }
  return add(model, building);
}

Building hospital(Model& model) {
  return shear_building(model, "hospital", {4.2 * m, 3.6 * m, 3.6 * m, 3.6 * m}, true);
}
Building old_building(Model& model) {
  return shear_building(model, "old", {3.4 * m, 3.2 * m, 3.2 * m, 3.2 * m, 1.8 * m}, false);
}

std::map<std::string, const ElementInfo*> gaps_of(const Model& model) {
  std::map<std::string, const ElementInfo*> gaps;
  for (const auto& block : model.blocks())
    for (const ElementInfo& info : block->infos())
      if (block->kind().contacts) gaps[info.name] = &info;
  return gaps;
}

std::vector<std::string> names(std::initializer_list<const char*> list) { return {list.begin(), list.end()}; }

// 15 m and 14.8 m differ by the thickness of a slab, but for round-off.
TEST(Neighbours, FloorsMeetUpToTheThicknessOfASlab) {
  for (const Length slab : {20 * cm, 19 * cm}) {
    Model model;
    const Building left = hospital(model), right = old_building(model);
    const NeighbourGaps made = add(
        model,
        Neighbours{.name = "joint", .left = left, .right = right, .clearance = 12 * cm, .law = law(), .slab = slab});
    EXPECT_EQ(made.names.back() == "joint: hospital floor 4 - old floor 5 at 14.90 m", slab == 20 * cm)
        << made.names.back();
  }
}

TEST(Neighbours, EveryFloorMeetsTheFloorOrColumnAtItsHeight) {
  Model model;
  const Building left = hospital(model), right = old_building(model);
  const NeighbourGaps made = add(
      model,
      Neighbours{.name = "joint", .left = left, .right = right, .clearance = 12 * cm, .law = law(), .slab = 25 * cm});
  EXPECT_EQ(
      made.names,
      names({"joint: old floor 1 - hospital storey 1 at 3.40 m", "joint: hospital floor 1 - old storey 2 at 4.20 m",
             "joint: old floor 2 - hospital storey 2 at 6.60 m", "joint: hospital floor 2 - old storey 3 at 7.80 m",
             "joint: old floor 3 - hospital storey 3 at 9.80 m", "joint: hospital floor 3 - old storey 4 at 11.40 m",
             "joint: old floor 4 - hospital storey 4 at 13.00 m", "joint: hospital floor 4 - old floor 5 at 14.90 m"}));
  EXPECT_EQ(
      made.notes,
      names({"\"hospital base\" at 0.00 m faces the foundations of \"old\", between which there is no gap. Give a "
             "moat where they can touch.",
             "joint: 7 gaps are those of floors against columns, with the law of slabs. A column is softer than "
             "a slab, and its shear is not checked: give .column_law."}));

  const auto gaps = gaps_of(model);
  ASSERT_EQ(gaps.size(), 8U);
  struct Expected {
    std::size_t gap;
    MemberPoint left, right;
  };
  const auto hospital_at = [&](int storey, double share) {
    return MemberPoint{storey == 1 ? left.base : left.floor(storey - 1), left.floor(storey), share};
  };
  const auto old_at = [&](int storey, double share) {
    return MemberPoint{right.floor(storey - 1), right.floor(storey), share};
  };
  for (const auto& [gap, left_point, right_point] :
       {Expected{0, hospital_at(1, 0.809524), right.floor(1)}, Expected{1, left.floor(1), old_at(2, 0.25)},
        Expected{2, hospital_at(2, 0.666667), right.floor(2)}, Expected{3, left.floor(2), old_at(3, 0.375)},
        Expected{4, hospital_at(3, 0.555556), right.floor(3)}, Expected{5, left.floor(3), old_at(4, 0.5)},
        Expected{6, hospital_at(4, 0.444444), right.floor(4)}, Expected{7, left.floor(4), right.floor(5)}}) {
    SCOPED_TRACE(made.names[gap]);
    const ElementInfo& info = *gaps.at(made.names[gap]);
    EXPECT_EQ(info.place, "joint");
    EXPECT_EQ(info.offset, 0.12);
    EXPECT_EQ(info.second, left_point.node);
    EXPECT_EQ(info.first, right_point.node);
    if (gap == 7) {
      EXPECT_EQ(info.member_ends(), nullptr);
      continue;
    }
    ASSERT_NE(info.member_ends(), nullptr);
    for (const auto& [end, expected] :
         {std::pair{info.member_ends()->second, left_point}, {info.member_ends()->first, right_point}}) {
      EXPECT_EQ(end.node, expected.node);
      EXPECT_EQ(end.other, expected.other);
      EXPECT_NEAR(end.share, expected.share, 5e-7);
    }
  }
}

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i < 300; ++i) samples.push_back(6.0 * std::sin(0.09 * i));
  return {"shaking", 0.01, samples};
}

// Floors at 3 and 6 m beside floors at 4 and 8 m.
TEST(Neighbours, AreTheGapsMadeByHand) {
  const Length clearance = 2 * cm;
  const std::vector<Length> low_storeys(2, 3 * m), tall_storeys(2, 4 * m);
  Model made, by_hand;
  const Building low = shear_building(made, "low", low_storeys, false),
                 tall = shear_building(made, "tall", tall_storeys, true);
  const ExactKelvin column_law{.stiffness = 1e8 * N / m, .restitution = 0.5};
  const NeighbourGaps gaps =
      add(made, Neighbours{.left = low, .right = tall, .clearance = clearance, .law = law(), .column_law = column_law});
  EXPECT_EQ(gaps.names, names({"neighbours: low floor 1 - tall storey 1 at 3.00 m",
                               "neighbours: tall floor 1 - low storey 2 at 4.00 m",
                               "neighbours: low floor 2 - tall storey 2 at 6.00 m"}));
  EXPECT_EQ(gaps.notes.size(), 1U) << "the foundations alone: the law of columns is given";

  shear_building(by_hand, "low", low_storeys, false);
  shear_building(by_hand, "tall", tall_storeys, true);
  const auto gap = [&](const std::string& name, const MemberPoint& left, const MemberPoint& right) {
    add(by_hand, Gap{.name = name, .left = left, .right = right, .clearance = clearance, .law = column_law});
  };
  gap("1", low.floor(1), MemberPoint{tall.base, tall.floor(1), 0.75});
  gap("2", MemberPoint{low.floor(1), low.floor(2), 1.0 / 3.0}, tall.floor(1));
  gap("3", low.floor(2), MemberPoint{tall.floor(1), tall.floor(2), 0.5});
  const CaseOptions options{.error_bars = ErrorBarMode::never};
  const auto [result, state] = run_to_end(made, shaking(), options);
  const auto [expected, state_by_hand] = run_to_end(by_hand, shaking(), options);
  EXPECT_GT(result.impacts.size(), 2U);
  EXPECT_EQ(result.impacts.size(), expected.impacts.size());
  for (const NodeId node : {low.floor(1), low.floor(2), tall.base, tall.floor(2)}) {
    EXPECT_NEAR(state.displacement(node), state_by_hand.displacement(node), 1e-12);
    EXPECT_NEAR(state.velocity(node), state_by_hand.velocity(node), 1e-10);
  }
}

// A column on the ground moves with its floor alone.
TEST(Neighbours, ColumnOfTheLowestStoreyMovesWithItsFloor) {
  Model model;
  const NodeId ram =
                   add(model, Node{.name = "ram", .mass = 2 * tonne, .initial_velocity = 0.5 * m / s, .height = 1 * m}),
               floor = add(model, Node{.name = "floor", .mass = 5 * tonne, .free = true, .height = 4 * m});
  add(model, Neighbours{.left = Building{.name = "left", .floors = {ram}},
                        .right = Building{.name = "right", .floors = {floor}},
                        .clearance = 1 * cm,
                        .law = law()});
  const auto [result, state] =
      run_to_end(model, testing::still_ground(0.2 * s, 5 * ms), {.error_bars = ErrorBarMode::never});
  // The gap counts for both buildings.
  for (const BuildingParts& building : result.buildings) {
    ASSERT_EQ(building.gaps.size(), 1U) << building.name;
    EXPECT_EQ(building.gaps[0].side, building.name == "ram" ? "right" : "left");
  }
  const double share = 0.25, impulse = 1.6 * 0.5 / (1.0 / 2e3 + share * share / 5e3);
  EXPECT_NEAR(state.velocity(ram), 0.5 - impulse / 2e3, 5e-4);
  EXPECT_NEAR(state.velocity(floor), share * impulse / 5e3, 5e-4);
}

TEST(Neighbours, ALevelMayMeetTwo) {
  Model model;
  const Building left = shear_building(model, "a", {4 * m, 4 * m}, false),
                 right = shear_building(model, "b", {3.8 * m, 0.5 * m, 6 * m}, false);
  EXPECT_EQ(add(model, Neighbours{.left = left, .right = right, .clearance = 5 * cm, .law = law()}).names,
            names({"neighbours: a floor 1 - b floor 1 at 3.90 m", "neighbours: a floor 1 - b floor 2 at 4.15 m",
                   "neighbours: a floor 2 - b storey 3 at 8.00 m"}));
}

// Matrices and all modes of a building are the same system.
TEST(Neighbours, FloorsGivenByModesMeetAsThoseOfMatrices) {
  Eigen::Matrix2d stiffness;
  stiffness << 2e8, -1e8, -1e8, 1e8;
  const Eigen::Matrix2d mass = 2e5 * Eigen::Matrix2d::Identity();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver{stiffness, mass};
  Superstructure tower{.name = "tower",
                       .freedoms = per_floor(Freedoms::x),
                       .floors = {{.height = 4 * m, .mass = 200 * tonne}, {.height = 8 * m, .mass = 200 * tonne}},
                       .damping = ModalDamping{0.05}};
  std::vector<EndedCase> cases;
  for (const bool by_modes : {false, true}) {
    tower.stiffness.reset();
    tower.modes.reset();
    if (by_modes)
      tower.modes = StructureModes{.eigenvalues = {solver.eigenvalues()[0], solver.eigenvalues()[1]},
                                   .shapes = solver.eigenvectors()};
    else
      tower.stiffness = in_units(stiffness, {.force = N, .length = m});
    Model model;
    const SuperstructureParts parts = add(model, tower);
    const Building beside = shear_building(model, "low", {3 * m, 3 * m}, false);
    const NeighbourGaps gaps =
        add(model, Neighbours{.left = beside, .right = parts, .clearance = 1 * cm, .law = law()});
    EXPECT_EQ(gaps.names, names({"neighbours: low floor 1 - tower storey 1 at 3.00 m",
                                 "neighbours: tower floor 1 - low storey 2 at 4.00 m",
                                 "neighbours: low floor 2 - tower storey 2 at 6.00 m"}));
    cases.push_back(run_to_end(model, shaking(), {.transient = {.step = 0.5 * ms}, .error_bars = ErrorBarMode::never}));
  }
  ASSERT_GT(cases[0].result.impacts.size(), 0U);
  ASSERT_EQ(cases[0].result.impacts.size(), cases[1].result.impacts.size());
  for (std::size_t i = 0; i < cases[0].result.impacts.size(); ++i)
    EXPECT_NEAR(cases[1].result.impacts[i].largest_force / cases[0].result.impacts[i].largest_force, 1.0, 1e-5);
}

TEST(Neighbours, ClearanceMayVaryOverTheHeight) {
  const Check check{"Neighbours", "joint"};
  const Clearance leaning = {{4 * m, 10 * cm}, {14 * m, 20 * cm}};
  EXPECT_NEAR(leaning.at(check, 4.0).si(), 0.10, 1e-15);
  EXPECT_NEAR(leaning.at(check, 9.0).si(), 0.15, 1e-15);
  EXPECT_NEAR(leaning.at(check, 14.0).si(), 0.20, 1e-15);
  EXPECT_EQ(Clearance{7 * cm}.at(check, 123.0).si(), 0.07);
  EXPECT_EQ(
      message_of([&] { std::ignore = leaning.at(check, 3.4); }),
      "Neighbours \"joint\": clearance: the list reaches from 4 to 14 m, and a gap is at 3.4 m. Give entries below "
      "and above all gaps.");
  EXPECT_EQ(message_of([&] {
              std::ignore = Clearance{{4 * m, 10 * cm}, {4 * m, 20 * cm}}.at(check, 4.0);
            }),
            "Neighbours \"joint\": clearance: heights must rise: 4 m, 4 m. Give the list from the lowest up.");
}

TEST(Neighbours, BadInputIsRefused) {
  const auto message = [](auto change) {
    Model model;
    const Building left = hospital(model), right = old_building(model);
    Neighbours neighbours{.name = "joint", .left = left, .right = right, .clearance = 12 * cm, .law = law()};
    return message_of([&] {
      change(model, neighbours);
      add(model, neighbours);
    });
  };
  EXPECT_EQ(message([](Model&, Neighbours&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Model&, Neighbours& n) { n.name = ""; }),
            "Neighbours: neighbours have no name. Give .name, or leave it out: \"neighbours\".");
  EXPECT_EQ(message([](Model&, Neighbours& n) { n.right = n.left.value(); }),
            "Neighbours \"joint\": \"hospital\" and \"hospital\" have a common floor. Give two buildings.");
  EXPECT_NE(message([](Model&, Neighbours& n) { n.slab = -1 * cm; }).find("slab = -0.01 m"), std::string::npos);
  EXPECT_NE(message([](Model&, Neighbours& n) { n.clearance = -1 * cm; }).find("clearance = -0.01 m"),
            std::string::npos);
  EXPECT_EQ(message([](Model& model, Neighbours& n) {
              const NodeId base = add(model, Node{.name = "tank base", .mass = 1 * tonne, .height = 20 * m}),
                           roof = add(model, Node{.name = "tank roof", .mass = 1 * tonne, .height = 25 * m});
              n.right = Building{.name = "tank", .base = base, .floors = {roof}};
            }),
            "Neighbours \"joint\": no floor of \"hospital\" or \"tank\" is at the height of a floor or a column of the "
            "other. Check their heights; the ground meets nothing: give a Moat around a base.");
  EXPECT_EQ(message([](Model& model, Neighbours& n) {
              const NodeId first = add(model, Node{.name = "shed 1", .mass = 1 * tonne}),
                           second = add(model, Node{.name = "shed 2", .mass = 1 * tonne});
              n.right = Building{.name = "shed", .base = first, .floors = {second}};
            }),
            "Neighbours \"joint\": heights must rise: \"shed 1\" at 0 m, \"shed 2\" at 0 m. Give .height to nodes and "
            "diaphragms, storey_height to buildings, and floors from the lowest up.");
  EXPECT_NE(message([](Model&, Neighbours& n) {
              Building unknown{.name = "unknown", .floors = {NodeId{1000}}};
              n.right = unknown;
            }).find("a level of \"unknown\""),
            std::string::npos);

  Model plan;
  const auto a = add(plan, PlanBuilding{.name = "a",
                                        .outline = rectangle(10 * m, 8 * m),
                                        .storeys = 1,
                                        .floor_mass = 100 * tonne,
                                        .columns = grid(2, 2, {.stiffness = 10 * MN / m})});
  EXPECT_EQ(message_of([&] { add(plan, Neighbours{.left = a, .right = a, .clearance = 1 * cm, .law = law()}); }),
            "Neighbours \"neighbours\": the model moves in plan. Give PlanNeighbours.");
}

}  // namespace
}  // namespace moat
