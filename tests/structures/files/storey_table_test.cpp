#include "structures/files/storey_table.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/files_read.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

class ReadStoreys : public testing::WrittenFiles {
 protected:
  [[nodiscard]] StoreyTable read(const std::string& content, const Outlines& outlines = {}) const {
    return read_storeys(write("storeys.csv", content), outlines);
  }
  // The message of a refusal behind the path of the file.
  [[nodiscard]] std::string refusal(const std::string& content, const Outlines& outlines = {}) const {
    const std::string message = message_of<FileError>([&] { (void)read(content, outlines); });
    const std::string file = path("storeys.csv").string();
    EXPECT_TRUE(message.starts_with(file)) << message;
    return message.substr(std::min(message.size(), file.size()));
  }
};

TEST_F(ReadStoreys, TakesEveryColumnWithItsUnit) {
  const StoreyTable table = read(
      "name,height [m],mass [t],inertia [t m2],x_mass [m],y_mass [m],x_rigidity [m],y_rigidity [m],kx [kN/m],ky "
      "[kN/m],k_rotation [kN m]\n"
      "base,,900,31500,0,0.1,,,,,\n"
      "floor 1,4.5,820,28700,0.6,0,-0.2,0.3,900e3,700e3,60e6\n"
      "roof,3.6,430,9460,-2.0,0.4,-2.4,0.5,380e3,300e3,14e6\n");
  ASSERT_TRUE(table.base);
  EXPECT_DOUBLE_EQ(table.base->mass / tonne, 900.0);
  EXPECT_DOUBLE_EQ(table.base->rotary_inertia.si(), 31'500e3);
  EXPECT_DOUBLE_EQ(table.base->centre_of_mass.y / m, 0.1);
  ASSERT_EQ(table.floors.size(), 2u);
  const StoreyRow& floor = table.floors[0];
  EXPECT_EQ(floor.name, "floor 1");
  EXPECT_DOUBLE_EQ(floor.height / m, 4.5);
  EXPECT_DOUBLE_EQ(floor.mass / tonne, 820.0);
  EXPECT_DOUBLE_EQ(floor.rotary_inertia.si(), 28'700e3);
  EXPECT_DOUBLE_EQ(floor.centre_of_mass.x / m, 0.6);
  EXPECT_DOUBLE_EQ(floor.centre_of_rigidity.x / m, -0.2);
  EXPECT_DOUBLE_EQ(floor.centre_of_rigidity.y / m, 0.3);
  EXPECT_DOUBLE_EQ(floor.stiffness_x.si(), 900e6);
  EXPECT_DOUBLE_EQ(floor.stiffness_y.si(), 700e6);
  EXPECT_DOUBLE_EQ(floor.rotational_stiffness.si(), 60e9);
  EXPECT_EQ(table.floors[1].name, "roof");
  EXPECT_TRUE(table.notes.empty());
  EXPECT_EQ(table.source, path("storeys.csv").string());
}

TEST_F(ReadStoreys, TakesAnyOrderOfColumnsAnyUnitAndSemicolons) {
  const FilesOfThisThread files;
  const StoreyTable table = read(
      "KX [N/mm];Mass [kg]; name ;height [cm];k_rotation [MN m/rad];x_rigidity [mm];"
      "y_rigidity [m];inertia [kg m^2]\n# a remark\n900;820e3;\"floor; one\";450;60;-200;0;5\n");
  EXPECT_EQ(table.floors[0].name, "floor; one");
  EXPECT_DOUBLE_EQ(table.floors[0].stiffness_x.si(), 900e3);
  EXPECT_DOUBLE_EQ(table.floors[0].mass.si(), 820e3);
  EXPECT_DOUBLE_EQ(table.floors[0].height.si(), 4.5);
  EXPECT_DOUBLE_EQ(table.floors[0].rotational_stiffness.si(), 60e6);
  EXPECT_DOUBLE_EQ(table.floors[0].centre_of_rigidity.x.si(), -0.2);
  EXPECT_DOUBLE_EQ(table.floors[0].rotary_inertia.si(), 5.0);
  ASSERT_EQ(files.files().size(), 1u);
  EXPECT_EQ(files.files()[0].path, path("storeys.csv").string());
}

TEST_F(ReadStoreys, NotesColumnsThatItDoesNotKnow) {
  EXPECT_EQ(read("name,height [m],mass [t],inerta [t m2],colour\nroof,3,50,4,red\n").notes,
            (std::vector<std::string>{"column \"inerta\" of storeys.csv is not used. Did you mean inertia?",
                                      "column \"colour\" of storeys.csv is not used."}));
}

TEST_F(ReadStoreys, SortsByElevation) {
  const StoreyTable table =
      read("name,elevation [m],height [m],mass [t]\nroof,6.6,3.6,50\nground,-0.5,,\nfloor 1,3,3.5,60\n");
  EXPECT_FALSE(table.base);
  ASSERT_EQ(table.floors.size(), 2u);
  EXPECT_EQ(table.floors[0].name, "floor 1");
  EXPECT_DOUBLE_EQ(table.floors[0].height.si(), 3.5);
  EXPECT_DOUBLE_EQ(table.floors[1].height.si(), 3.6);
  EXPECT_DOUBLE_EQ(read("name,elevation [m],mass [t]\nroof,6.6,50\nlower,3,60\n").floors[0].height.si(), 3.0);
}

TEST_F(ReadStoreys, TakesOutlines) {
  const Outlines outlines = read_outlines(
      write("outlines.csv",
            "name,x [m],y [m]\nL,0,0\nL,10,0\nL,10,4\nL,4,4\nL,4,8\nL,0,8\nroof,0,0\nroof,400,0\nroof,0,8\n"));
  ASSERT_EQ(outlines.size(), 2u);
  EXPECT_DOUBLE_EQ(outlines.at("L").area(), 56.0);
  const std::string content = "name,height [m],mass [t],outline\nfloor 1,3,50,L\nroof,3,40,\n";
  const StoreyTable table = read(content, outlines);
  EXPECT_EQ(table.floors[0].outline.size(), 6u);
  EXPECT_TRUE(table.floors[1].outline.empty());
  EXPECT_EQ(refusal(content),
            ", line 2: there is no outline \"L\". Give them: read_storeys(file, "
            "read_outlines(\"outlines.csv\")).");
  EXPECT_EQ(refusal("name,height [m],mass [t],outline\nfloor 1,3,50,M\n", outlines),
            ", line 2: there is no outline \"M\".");
  const auto clockwise = write("clockwise.csv", "name,x [m],y [m]\nA,0,0\nA,0,1\nA,1,0\n");
  EXPECT_TRUE(message_of([&] {
                (void)read_outlines(clockwise);
              }).starts_with("read_outlines \"" + clockwise.string() + "\": A"));
}

TEST_F(ReadStoreys, AsksForColumnsAndUnits) {
  EXPECT_EQ(refusal("name,height [m],mass [t],kx\nroof,3,50,1\n"), ", line 1: column kx has no unit; write kx [kN/m].");
  EXPECT_EQ(refusal("name,height [m]\nroof,3\n"), ", line 1: column mass is missing; write mass [t].");
  EXPECT_EQ(refusal("height [m],mass [t]\n3,3\n"), ", line 1: column name is missing; write name.");
  EXPECT_EQ(refusal("name,mass [t]\nroof,3\n"), ": column height is missing; write height [m].");
  EXPECT_EQ(refusal("name,height [m],mass [t],mass [kg]\nroof,3,50,1\n"), ", line 1: column mass is given twice.");
  EXPECT_EQ(refusal("name,height [m],mass [t],k_rotation [kN m]\nroof,3,50,1\n"),
            ": column x_rigidity is missing; write x_rigidity [m].");
  EXPECT_EQ(refusal("name,height [m],mass [kN]\nroof,3,50\n"),
            ", line 2, mass: \"50 kN\" is in N, but it must be in kg or multiples of it.");
  EXPECT_EQ(refusal("name,height [m],mass [stone]\nroof,3,50\n").substr(0, 57),
            ", line 2, mass: \"50 stone\" has an unknown unit \"stone\". K");
}

TEST_F(ReadStoreys, RefusesBadRows) {
  const std::string header = "name,height [m],mass [t]\n";
  EXPECT_EQ(refusal(header + "floor 2,3,50\nfloor 1,3,50\n"),
            ", line 2: floor 2 is the floor in place 1 from below. Rows stand from the lowest up unless there is an "
            "elevation; floor 1 is the first above base or ground.");
  EXPECT_EQ(read_storeys(write("floors.csv", header + "floor 01,3,50\nfloor 02,3,50\n")).floors.size(), 2U)
      << "a number, not a text";
  EXPECT_EQ(refusal(header), ": there are no rows below the names of the columns.");
  EXPECT_EQ(refusal(header + "a,3,50\nb,3\n"), ", line 3: it has 2 fields, line 1 has 3.");
  EXPECT_EQ(refusal(header + "a,3,\n"), ", line 2: mass is empty.");
  EXPECT_EQ(refusal(header + ",3,50\n"), ", line 2: name is empty.");
  EXPECT_EQ(refusal(header + "a,3,-50\n"), ", line 2: mass is -50; it must be > 0.");
  EXPECT_EQ(refusal(header + "a,0,50\n"), ", line 2: height is 0; it must be > 0.");
  EXPECT_EQ(refusal(header + "a,3,x\n").substr(0, 55), ", line 2, mass: \"x t\" does not start with a number. Wri");
  EXPECT_EQ(refusal("name;height [m];mass [t]\na;3,5;50\n"),
            ", line 2, height: \"3,5 m\" has a decimal comma. Write decimals with a point: 1.5.");
  EXPECT_EQ(refusal(header + "a,3,50\nA,3,50\n"), ", line 3: \"A\" stands in line 2 too.");
  EXPECT_EQ(refusal(header + "a,3,50\nbase,,80\n"), ", line 3: base must be the lowest row.");
  EXPECT_EQ(refusal(header + "base,3,80\na,3,50\n"), ", line 2: base has no storey below it; leave height empty.");
  EXPECT_EQ(refusal(header + "ground,,80\na,3,50\n"), ", line 2: the ground has no mass. Call the row base.");
  EXPECT_EQ(refusal(header + "base,,80\n"), ": there is no floor in it.");
  EXPECT_EQ(refusal("name,elevation [m],mass [t]\na,3,50\nb,3,50\n"),
            ", line 3: elevation must be above the row below, or above 0 m.");
  EXPECT_EQ(refusal("name,elevation [m],height [m],mass [t]\na,3,3,50\nb,6,3.5,50\n"),
            ", line 3: height is 3.5 m, but the elevations differ by 3 m.");
}

// 5 % of 20 m and of 10 m; the roof is smaller. Masses that are off the centre stay so.
TEST(StoreyTableWithEccentricity, MovesAllCentresOfMass) {
  StoreyTable table;
  table.base = StoreyRow{.name = "base", .outline = rectangle(20 * m, 10 * m)};
  table.floors = {{.name = "floor 1", .centre_of_mass = {1 * m, 2 * m}, .outline = rectangle(20 * m, 10 * m)},
                  {.name = "roof", .outline = rectangle(8 * m, 4 * m, {3 * m, 0 * m})}};
  const StoreyTable moved = with_eccentricity(table, 0.05, -0.05);
  EXPECT_NEAR(moved.base->centre_of_mass.x / m, 1.0, 1e-15);
  EXPECT_NEAR(moved.base->centre_of_mass.y / m, -0.5, 1e-15);
  EXPECT_NEAR(moved.floors[0].centre_of_mass.x / m, 2.0, 1e-15);
  EXPECT_NEAR(moved.floors[0].centre_of_mass.y / m, 1.5, 1e-15);
  EXPECT_NEAR(moved.floors[1].centre_of_mass.x / m, 0.4, 1e-15);
  EXPECT_NEAR(moved.floors[1].centre_of_mass.y / m, -0.2, 1e-15);
  EXPECT_NE(message_of([&] { (void)with_eccentricity(table, 0.6, 0.0); }).find("share_of_x = 0.6"), std::string::npos);
  EXPECT_NE(message_of([&] { (void)with_eccentricity(table, 0.0, -0.6); }).find("share_of_y = -0.6"),
            std::string::npos);
  table.floors[1].outline = {};
  EXPECT_EQ(message_of([&] { (void)with_eccentricity(table, 0.05, 0.0); }),
            "with_eccentricity: roof has no outline. Give one: the eccentricity is a share of it.");
  EXPECT_EQ(with_eccentricity(table, 0.0, 0.0).floors.size(), 2u);
}

}  // namespace
}  // namespace moat
