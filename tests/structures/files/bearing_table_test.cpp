#include "structures/files/bearing_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "moved_model.hpp"
#include "structures/plan_building.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const LeadRubberBearing rubber{
    .yield_force = 30 * kN, .yield_displacement = 6 * mm, .post_yield_stiffness = 0.6 * MN / m};
const FrictionPendulum pendulum{.radius = 2.0 * m, .friction = 0.05, .yield_displacement = 1 * mm};

class ReadBearings : public testing::WrittenFiles {
 protected:
  [[nodiscard]] PlanBearings read(const std::string& content, const BearingTypes& types) const {
    return read_bearings(write("bearings.csv", content), types);
  }
  [[nodiscard]] std::string refusal(const std::string& content) const {
    const std::string message = message_of<FileError>([&] { (void)read(content, {.types = {{"LRB", rubber}}}); });
    const std::string file = path("bearings.csv").string();
    EXPECT_TRUE(message.starts_with(file)) << message;
    return message.substr(std::min(message.size(), file.size()));
  }
};

const std::string four = "name,x [m],y [m],type\nB1,-9,-5,LRB\nB2,9,-5,LRB\nB3,9,5,FPS\nB4,-9,5,FPS\n";

PlanBuilding on(PlanBearings bearings) {
  return {.name = "north",
          .outline = rectangle(20 * m, 12 * m),
          .storeys = 1,
          .floor_mass = 700 * tonne,
          .columns = grid(2, 2, {.stiffness = 100 * MN / m}),
          .base_mass = 800 * tonne,
          .bearings = std::move(bearings)};
}

TEST_F(ReadBearings, NamesThemAndGroupsThemByType) {
  Model model;
  add(model, on(read(four, {.types = {{"LRB", rubber}, {"FPS", pendulum}}})));
  std::map<std::string, std::string> place_of;
  for (const auto& block : model.blocks())
    for (const ElementInfo& info : block->infos())
      if (info.name.starts_with("north B")) place_of[info.name] = info.listed_under();
  EXPECT_EQ(
      place_of,
      (std::map<std::string, std::string>{
          {"north B1", "north LRB"}, {"north B2", "north LRB"}, {"north B3", "north FPS"}, {"north B4", "north FPS"}}));
}

TEST_F(ReadBearings, PutsWeightsOnThem) {
  // F = mu W: the friction of two pendulums under their own weights.
  const PlanBearings bearings =
      read("type,weight [MN],y [m],x [mm],name\nFPS,4,1,-2000,a\nFPS,6,1,2000,b\n", {.types = {{"FPS", pendulum}}});
  const auto placed = bearings.placed(Check{"test", ""}, {});
  ASSERT_EQ(placed.size(), 2u);
  EXPECT_DOUBLE_EQ(placed[0].weight.si(), 4e6);
  EXPECT_DOUBLE_EQ(placed[1].weight.si(), 6e6);
  EXPECT_DOUBLE_EQ(placed[1].at.x.si(), 2.0);
  EXPECT_DOUBLE_EQ(placed[1].at.y.si(), 1.0);
  EXPECT_EQ(placed[1].name, "b");
  EXPECT_EQ(placed[1].type, "FPS");
}

// The weight of a row wins over that of its type, and reports show both.
TEST_F(ReadBearings, PutsWeightsOnDesignsThatHaveOne) {
  FrictionPendulum single = pendulum;
  single.weight = 1 * MN;
  DoublePendulum two = DoublePendulum::typical();
  two.weight = 1 * MN;
  Model model;
  add(model, on(read("name,x [m],y [m],type,weight [MN]\n"
                     "B1,-9,-5,FPS,4\nB2,9,-5,FPS,4\nB3,9,5,double,3\nB4,-9,5,double,3\n",
                     {.types = {{"FPS", single}, {"double", two}}})));
  AnalysisState state{model};
  // Under the weight W it slides with W (d/R + mu), in the direction of the motion.
  const double d = 0.02, sliding = 4e6 * (d / 2.0 + 0.05);
  testing::move_to(state, Vector{{d}}, Vector{{0.1}}, 0.1);
  int seen = 0;
  for (std::size_t b = 0; b < model.blocks().size(); ++b)
    for (std::size_t e = 0; e < model.blocks()[b]->infos().size(); ++e) {
      const LawAsGiven law = model.blocks()[b]->law(e);
      const std::string name = model.blocks()[b]->info(e).name;
      if (!name.starts_with("north B")) continue;
      const bool is_single = name < "north B3";
      EXPECT_EQ(law.name, is_single ? "FrictionPendulum" : "DoublePendulum") << name;
      EXPECT_EQ(law.parameters.back().name, "weight") << name;
      EXPECT_EQ(law.parameters.back().value, is_single ? 4e6 : 3e6) << name;
      if (is_single) {
        EXPECT_NEAR(state.elements(b).results()[e].force, sliding, 1e-9 * sliding) << name;
      }
      ++seen;
    }
  EXPECT_EQ(seen, 4);
}

TEST_F(ReadBearings, NotesTypesWithoutBearingsAndOtherColumns) {
  EXPECT_EQ(
      read("name,x [m],y [m],type,maker\nB1,0,0,LRB,me\n", {.types = {{"LRB", rubber}, {"FPS", pendulum}}}).notes(),
      (std::vector<std::string>{"column \"maker\" of bearings.csv is not used.",
                                "no bearing of bearings.csv has the type FPS."}));
}

TEST_F(ReadBearings, RefusesUnknownTypesAndBadRows) {
  EXPECT_EQ(refusal(four), ", line 4: type \"FPS\" is not given; types are LRB.");
  EXPECT_EQ(refusal("name,x [m],y [m]\nB1,0,0\n"), ", line 1: column type is missing; write type.");
  EXPECT_EQ(refusal("name,x,y [m],type\nB1,0,0,LRB\n"), ", line 1: column x has no unit; write x [m].");
  EXPECT_EQ(refusal("name,x [m],y [m],type\nB1,0,0,LRB\nb1,1,0,LRB\n"), ", line 3: \"b1\" stands in line 2 too.");
  EXPECT_EQ(refusal("name,x [m],y [m],type,weight [kN]\nB1,0,0,LRB,0\n"), ", line 2: weight is 0; it must be > 0.");
  EXPECT_EQ(refusal("name,x [m],y [m],type,weight [kN]\nB1,0,0,LRB,\n"), ", line 2: weight is empty.");
  const auto file = write("bearings.csv", four);
  EXPECT_EQ(message_of([&] {
              (void)read_bearings(file, {.types = {{"LRB", rubber}, {"LRB", rubber}}});
            }),
            "read_bearings \"" + file.string() + "\": type \"LRB\" is given twice. Give every type once.");
}

}  // namespace
}  // namespace moat
