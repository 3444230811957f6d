// Superstructures of finite elements: motions that are kept, towers on a podium, a level at the feet.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <string>
#include <vector>

#include "message_of.hpp"
#include "peak_in.hpp"
#include "structures/superstructure/superstructure.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;
using testing::peak;

GroundMotion shaking() {
  std::vector<double> samples;
  for (int i = 0; i < 400; ++i)
    samples.push_back(3.0 * std::sin(0.07 * i) * std::exp(-1e-5 * i * i) + std::cos(0.31 * i));
  return {"shaking", 0.01, samples};
}

CaseResult run(const Model& model) {
  CaseRun run{
      model, shaking(), {.transient = {.step = 2 * ms, .force_tolerance = 1e-12}, .error_bars = ErrorBarMode::never}};
  run.run();
  return run.result();
}

void expect_equal(const CaseResult& a, const std::string& place_a, const CaseResult& b, const std::string& place_b,
                  const std::string& quantity, double factor = 1.0, double tolerance = 1e-9) {
  const double expected = factor * peak(b, quantity, place_b);
  EXPECT_NEAR(peak(a, quantity, place_a), expected, tolerance * expected) << quantity << " at " << place_a;
}

constexpr MemberSection column{.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 8e-4 * m_4};
constexpr ElasticMaterial steel{.E = 206 * GPa, .poisson = 0.3};

// Columns between levels at these heights, with beams on them. Nodes are numbered from the lowest up, and from the
// left.
Frame columns_and_beams(const std::vector<Length>& heights, const std::vector<Length>& lines) {
  Frame frame{.motion = LevelMotion::along_x};
  const int count = static_cast<int>(lines.size());
  for (std::size_t level = 0; level < heights.size(); ++level)
    for (std::size_t line = 0; line < lines.size(); ++line) {
      frame.nodes.push_back({.x = lines[line], .z = heights[level]});
      const int node = static_cast<int>(frame.nodes.size());
      if (level == 0) continue;
      frame.members.push_back({.from = node - count, .to = node, .section = column, .material = steel});
      if (line > 0) frame.members.push_back({.from = node - 1, .to = node, .section = column, .material = steel});
    }
  return frame;
}

Superstructure isolated(CondensedStructure condensed) {
  return {.condensed = std::move(condensed),
          .damping = ModalDamping{0.05},
          .base = SuperstructureBase{.mass = 60 * tonne},
          .isolation = LeadRubberBearing{
              .yield_force = 60 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0.8 * MN / m}};
}

// Two storeys of 4 m; a mass of 9 t hangs on the left column, 2 m up.
FiniteElements with_mezzanine() {
  Frame frame = columns_and_beams({0 * m, 4 * m, 8 * m}, {0 * m, 6 * m});
  frame.nodes.push_back({.name = "mezzanine", .z = 2 * m});
  frame.members[0].to = "mezzanine";
  frame.members.push_back({.from = "mezzanine", .to = 3, .section = column, .material = steel});
  frame.levels = {{.height = 4 * m, .mass = 40 * tonne}, {.height = 8 * m, .mass = 30 * tonne}};
  FiniteElements model = frame.finite_elements();
  model.mass.insert(36, 36) = 9e3;
  model.masses = Vanishing::keep;
  return model;
}

TEST(FrameBuildings, AKeptMotionIsALevelOfItsOwn) {
  const FiniteElements kept = with_mezzanine();
  FiniteElements level = kept;
  level.diaphragms.insert(level.diaphragms.begin(), {.nodes = {"mezzanine"}});
  for (const bool on_bearings : {true, false}) {
    Superstructure one = isolated(condensed(kept)), other = isolated(condensed(level));
    if (!on_bearings)
      for (Superstructure* each : {&one, &other}) {
        each->base.reset();
        each->isolation.reset();
      }
    Model a, b;
    const SuperstructureParts parts = add(a, one), of_levels = add(b, other);
    ASSERT_EQ(parts.floors.size(), 2U);
    ASSERT_EQ(parts.modes.size(), 3U);
    EXPECT_EQ(parts.notes.back(),
              "total_base_shear leaves out the inertia of motions that are kept, 9 t; storey shears have it.");
    for (std::size_t mode = 0; mode < 3; ++mode) {
      EXPECT_NEAR(parts.periods()[mode], of_levels.periods()[mode], 1e-12);
      EXPECT_NEAR(parts.modes[mode].x, of_levels.modes[mode].x, 1e-11);
    }
    const CaseResult x = run(a), y = run(b);
    if (on_bearings) {
      expect_equal(x, "base", y, "base", "displacement");
      expect_equal(x, "bearings", y, "bearings", "isolator_deformation");
    }
    for (const char* quantity : {"displacement", "absolute_acceleration"}) {
      expect_equal(x, "floor 1", y, "floor 2", quantity);
      expect_equal(x, "floor 2", y, "floor 3", quantity);
    }
    for (const char* quantity : {"storey_shear", "overturning_moment"}) {
      expect_equal(x, "storey 1", y, "storey 1", quantity);
      expect_equal(x, "storey 2", y, "storey 3", quantity);
    }
  }
}

TEST(FrameBuildings, ALineAlongYIsThatAlongX) {
  FiniteElements x = with_mezzanine();
  Frame frame = columns_and_beams({0 * m, 4 * m, 8 * m}, {0 * m, 6 * m});
  frame.nodes.push_back({.name = "mezzanine", .z = 2 * m});
  frame.members[0].to = "mezzanine";
  frame.members.push_back({.from = "mezzanine", .to = 3, .section = column, .material = steel});
  for (FrameNode& node : frame.nodes) std::swap(node.x, node.y);
  FiniteElements y = frame.finite_elements();
  y.motion = LevelMotion::along_y;
  y.diaphragms = x.diaphragms;
  y.masses = Vanishing::keep;
  y.mass.insert(37, 37) = 9e3;
  for (const int node : {2, 3, 4, 5})
    x.mass.insert(6 * node + 2, 6 * node + 2) = y.mass.insert(6 * node + 2, 6 * node + 2) = 2e3;
  const CondensedStructure a = condensed(x), b = condensed(y);
  EXPECT_TRUE(a.stiffness.isApprox(b.stiffness, 1e-12));
  EXPECT_EQ(a.mass, b.mass);
  ASSERT_EQ(a.kept.size(), b.kept.size());
  for (std::size_t i = 0; i < a.kept.size(); ++i)
    for (const int motion : {0, 2, 4}) EXPECT_NEAR(a.kept[i].rigid[motion], b.kept[i].rigid[motion], 1e-12);
}

TEST(FrameBuildings, KeptVerticalMassesMoveWithTheGround) {
  FiniteElements model = with_mezzanine();
  for (const int node : {2, 3, 4, 5}) model.mass.insert(6 * node + 2, 6 * node + 2) = 1e3 * node;
  Superstructure building = isolated(condensed(model));
  building.base.reset();
  building.isolation.reset();
  Model whole;
  add(whole, building);
  SparseMatrix mass = whole.zero_matrix();
  whole.mass_matrix().add_to(1.0, mass);
  const int size = whole.degrees_of_freedom();
  ASSERT_EQ(size, 7);
  const Vector x = Vector::Map(whole.ground_influence().x, size), z = Vector::Map(whole.ground_influence().z, size);
  EXPECT_NEAR(x.dot(mass * x), 79e3, 1e-6);
  EXPECT_NEAR(z.dot(mass * z), 14e3, 1e-6);
  EXPECT_NEAR(x.dot(mass * z), 0.0, 1e-6);
}

TEST(FrameBuildings, SmallVerticalMassesChangeNothing) {
  FiniteElements model = with_mezzanine();
  model.mass.coeffRef(36, 36) = 0.0;
  model.mass.prune(0.0);
  const CondensedStructure without = condensed(model);
  for (const int node : {2, 3, 4, 5}) model.mass.insert(6 * node + 2, 6 * node + 2) = 1.0;
  Model a, b;
  add(a, isolated(condensed(model)));
  add(b, isolated(without));
  const CaseResult x = run(a), y = run(b);
  for (const char* quantity : {"drift", "storey_shear", "overturning_moment"})
    for (const char* storey : {"storey 1", "storey 2"}) expect_equal(x, storey, y, storey, quantity, 1.0, 1e-3);
  expect_equal(x, "base", y, "base", "total_base_shear", 1.0, 1e-3);
}

// A podium with its base as a level, and two equal towers of one bay; or their floors tied.
Superstructure podium(bool tied) {
  const std::vector<Length> heights{0 * m, 4 * m, 7.5 * m, 11 * m};
  Frame frame = columns_and_beams(heights, {0 * m, 6 * m, 14 * m, 20 * m});
  // No beams between the towers.
  std::erase_if(frame.members, [](const FrameMember& member) {
    const std::string &from = member.from.value().text(), &to = member.to.value().text();
    return (from == "10" && to == "11") || (from == "14" && to == "15");
  });
  frame.levels = {{.height = 0 * m, .mass = 60 * tonne}, {.height = 4 * m, .mass = 40 * tonne}};
  if (tied)
    for (const std::size_t level : {2, 3}) frame.levels.push_back({.height = heights[level], .mass = 24 * tonne});
  else
    for (const int left : {9, 11})
      for (const int node : {left, left + 4})
        frame.levels.push_back({.tower = left == 9 ? "west" : "east", .nodes = {node, node + 1}, .mass = 12 * tonne});
  Superstructure building = isolated(frame.condensed());
  building.name = "hospital";
  building.base.reset();
  return building;
}

TEST(FrameBuildings, TwoEqualTowersOnAPodiumMoveAsOne) {
  // The frame is its own mirror image: both towers move alike, and a tie between them carries no force.
  Model a, b;
  const SuperstructureParts towers = add(a, podium(false)), whole = add(b, podium(true));
  EXPECT_EQ(towers.floors.size(), 5U);
  ASSERT_EQ(a.buildings().size(), 3U);
  EXPECT_EQ(a.mass(towers.base), 60e3);
  EXPECT_EQ(a.buildings()[2].base, towers.floor(1).x);
  EXPECT_NEAR(towers.periods()[0], whole.periods()[0], 1e-12);
  const CaseResult x = run(a), y = run(b);
  expect_equal(x, "hospital base", y, "hospital base", "displacement");
  expect_equal(x, "hospital base", y, "hospital base", "total_base_shear");
  expect_equal(x, "hospital storey 1", y, "hospital storey 1", "drift");
  for (const char* quantity : {"storey_shear", "overturning_moment"})
    expect_equal(x, "hospital storey 1", y, "hospital storey 1", quantity);
  for (const std::string tower : {"hospital west ", "hospital east "})
    for (const int storey : {1, 2}) {
      const std::string own = std::to_string(storey), of_whole = std::to_string(storey + 1);
      expect_equal(x, tower + "floor " + own, y, "hospital floor " + of_whole, "displacement");
      for (const char* quantity : {"drift", "drift_ratio"})
        expect_equal(x, tower + "storey " + own, y, "hospital storey " + of_whole, quantity);
      for (const char* quantity : {"storey_shear", "overturning_moment"})
        expect_equal(x, tower + "storey " + own, y, "hospital storey " + of_whole, quantity, 0.5);
    }
}

TEST(FrameBuildings, ALevelAtTheFeetIsTheBase) {
  const std::vector<Length> heights{0 * m, 4 * m, 8 * m};
  Frame frame = columns_and_beams(heights, {0 * m, 6 * m});
  frame.levels = {{.height = 4 * m, .mass = 40 * tonne}, {.height = 8 * m, .mass = 30 * tonne}};
  Model a, b;
  add(a, isolated(frame.condensed()));
  frame.levels.insert(frame.levels.begin(), {.height = 0 * m, .mass = 60 * tonne});
  Superstructure with_level = isolated(frame.condensed());
  with_level.base.reset();
  add(b, with_level);
  const CaseResult x = run(a), y = run(b);
  for (const char* place : {"base", "floor 1", "floor 2"}) expect_equal(x, place, y, place, "displacement");
  expect_equal(x, "base", y, "base", "total_base_shear");
}

TEST(FrameBuildings, BadBasesAndDampingsAreRefused) {
  const auto message = [](auto change) {
    FiniteElements model = with_mezzanine();
    model.diaphragms.insert(model.diaphragms.begin(), {.height = 0 * m, .mass = 60 * tonne});
    Superstructure building = isolated({});
    change(model, building);
    return message_of([&] {
      building.condensed = condensed(model);
      Model whole;
      return add(whole, building);
    });
  };
  EXPECT_EQ(message([](FiniteElements&, Superstructure&) {}), "nothing was thrown");
  EXPECT_EQ(message([](FiniteElements&, Superstructure& s) { s.base->mass = 61 * tonne; }),
            "Superstructure: the level base at the feet has mass, and is not the base. Give bearings, and leave out "
            ".base or give this mass there.");
  EXPECT_EQ(message([](FiniteElements& f, Superstructure&) { f.masses = Vanishing::guyan; }),
            "Superstructure: masses couple the level base with others. Leave this level out, or take another "
            "Vanishing.");
  EXPECT_EQ(message([](FiniteElements&, Superstructure& s) {
              s.damping = in_units(Eigen::MatrixXd::Identity(2, 2), {.force = N, .length = m});
              s.freedoms = per_floor(Freedoms::x);
            }),
            "Superstructure: damping is a matrix of the floors, and other motions are kept. Give ModalDamping or "
            "RayleighDamping.");
  EXPECT_EQ(message([](FiniteElements& f, Superstructure&) { f.stiffness.coeffRef(12, 12) *= 1.5; }).substr(0, 84),
            "Superstructure: stiffness: rigid motion of base and floors strains row floor 1 x by ");
}

}  // namespace
}  // namespace moat
