#include "structures/files/mode_files.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using testing::message_of;

const std::string two_modes = "mode,period [s],ratio\n1,0.5,0.05\n2,250e-3,0.03\n";

class ReadModes : public testing::WrittenFiles {
 protected:
  [[nodiscard]] ModesFromFile read(const std::string& modes, const std::string& shapes,
                                   const std::vector<std::string>& floors = {}) const {
    return read_modes(write("modes.csv", modes), write("shapes.csv", shapes), floors);
  }
  // The message of a refusal behind the folder of the files.
  [[nodiscard]] std::string refusal(const std::string& modes, const std::string& shapes,
                                    const std::vector<std::string>& floors = {}) const {
    const std::string message = message_of<FileError>([&] { (void)read(modes, shapes, floors); });
    const std::string begin = path("").string();
    EXPECT_TRUE(message.starts_with(begin)) << message;
    return message.substr(std::min(message.size(), begin.size()));
  }
};

TEST_F(ReadModes, TakesPeriodsAndAMatrixOfShapes) {
  const ModesFromFile modes = read(two_modes, ",mode 1,mode 2\nfloor 1 x,0.5,1\nfloor 2 x,1,-0.5\nfloor 3 x,2,3\n");
  ASSERT_EQ(modes.eigenvalues.size(), 2);
  EXPECT_DOUBLE_EQ(modes.eigenvalues[0], 16.0 * std::numbers::pi * std::numbers::pi);
  EXPECT_DOUBLE_EQ(modes.eigenvalues[1], 64.0 * std::numbers::pi * std::numbers::pi);
  EXPECT_EQ(modes.shapes, (Eigen::Matrix<double, 3, 2>{{0.5, 1.0}, {1.0, -0.5}, {2.0, 3.0}}));
  EXPECT_EQ(modes.ratios, (std::vector<double>{0.05, 0.03}));
  EXPECT_EQ(modes.names, (std::vector<std::string>{"floor 1 x", "floor 2 x", "floor 3 x"}));
  EXPECT_TRUE(modes.notes.empty());
}

TEST_F(ReadModes, TakesEigenvalues) {
  const ModesFromFile modes = read("mode;eigenvalue [1/s2];remark\n1;49.0;first\n2;5e2;\n", "0.5 1\n1 -0.5\n");
  EXPECT_DOUBLE_EQ(modes.eigenvalues[0], 49.0);
  EXPECT_DOUBLE_EQ(modes.eigenvalues[1], 500.0);
  EXPECT_TRUE(modes.ratios.empty());
  EXPECT_TRUE(modes.names.empty());
  EXPECT_EQ(modes.notes, std::vector<std::string>{"column \"remark\" of modes.csv is not used."});
}

TEST_F(ReadModes, TakesATableOfShapes) {
  const std::string shapes = "mode,floor,x [mm],y [m],rotation [rad]\n1,2,1,2,3\n1,1,4,5,6\n2,2,7,8,9\n2,1,10,11,12\n";
  const ModesFromFile modes = read(two_modes, shapes);
  EXPECT_EQ(modes.names, (std::vector<std::string>{"floor 2 x", "floor 2 y", "floor 2 rotation", "floor 1 x",
                                                   "floor 1 y", "floor 1 rotation"}));
  Eigen::Matrix<double, 6, 2> expected;
  expected << 1e-3, 7e-3, 2, 8, 3, 9, 4e-3, 10e-3, 5, 11, 6, 12;
  EXPECT_TRUE(modes.shapes.isApprox(expected, 1e-15)) << modes.shapes;
  const ModesFromFile line =
      read(two_modes, "floor,mode,x [m]\nRoof,1,3\nStory1,1,2\nRoof,2,-1\nStory1,2,1\n", {"Story1", "Roof"});
  EXPECT_EQ(line.names, (std::vector<std::string>{"floor 2 x", "floor 1 x"}));
  EXPECT_EQ(line.shapes, (Eigen::Matrix2d{{3.0, -1.0}, {2.0, 1.0}}));
  EXPECT_EQ(read(two_modes, "mode,floor,x [m]\n1,floor 1,3\n2,floor 1,2\n").names,
            std::vector<std::string>{"floor 1 x"});
}

TEST_F(ReadModes, RefusesBadModes) {
  const std::string shapes = "1\n";
  EXPECT_EQ(refusal("mode\n1\n", shapes), "modes.csv: give period [s] or eigenvalue [1/s2], one of them.");
  EXPECT_EQ(refusal("mode,period [s],eigenvalue [1/s2]\n1,1,39\n", shapes),
            "modes.csv: give period [s] or eigenvalue [1/s2], one of them.");
  EXPECT_EQ(refusal("mode,period [s]\n2,1\n", shapes),
            "modes.csv, line 2: mode is 2; modes are numbered 1, 2, 3 from row to row.");
  EXPECT_EQ(refusal("mode,period [s]\n1,0\n", shapes), "modes.csv, line 2: period is 0; it must be > 0.");
  EXPECT_EQ(refusal("mode,period [s]\n1,1e-200\n", shapes),
            "modes.csv, line 2: period is 1e-200; it is too small. Check its unit.");
  EXPECT_EQ(refusal("mode,eigenvalue [1/s2]\n1,-4\n", shapes), "modes.csv, line 2: eigenvalue is -4; it must be > 0.");
  EXPECT_EQ(refusal("mode,eigenvalue [1/s]\n1,4\n", shapes),
            "modes.csv, line 2, eigenvalue: \"4 1/s\" is in 1/s, but it must be in s^-2 or multiples of it.");
  EXPECT_EQ(refusal("mode,period [s],ratio\n1,1,5\n", shapes),
            "modes.csv, line 2: ratio of mode 1 is 5; it must be >= 0 and < 1. 5 % is 0.05.");
}

TEST_F(ReadModes, RefusesShapesThatDoNotFit) {
  EXPECT_EQ(refusal(two_modes, "1,2,3\n4,5,6\n"),
            "shapes.csv: 3 columns for 2 modes of " + path("modes.csv").string() + ".");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m]\n1,1,3\n1,2,3\n2,1,3\n"),
            "shapes.csv: 3 rows for 2 modes. Every mode must have all floors.");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m]\n1,1,3\n1,2,3\n1,3,3\n2,1,3\n"),
            "shapes.csv, line 4: mode is 1, where mode 2 has 2 floors. Every mode must have all floors.");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m]\n1,1,3\n1,2,3\n2,2,3\n2,1,3\n"),
            "shapes.csv, line 4: floor 2 stands in place 1, in mode 1 another floor does. Give the floors in one "
            "order.");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m]\n1,Story1,3\n2,Story1,3\n"),
            "shapes.csv, line 2: floor \"Story1\" is unknown. Give the names of the floors from the lowest up: "
            "read_modes(modes, shapes, {\"Story1\", \"Story2\"}).");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m],y [m]\n1,1,3,2\n2,1,3,2\n"),
            "shapes.csv: column rotation is missing; write rotation [rad].");
  EXPECT_EQ(refusal(two_modes, "mode,floor,x [m]\n1,1,3\n1,1,2\n2,1,3\n2,1,2\n"),
            "shapes.csv, line 3: floor 1 stands twice in mode 1.");
}

}  // namespace
}  // namespace moat
