#include "structures/files/matrix_file.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/files_read.hpp"
#include "base/sha256.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

const MatrixUnits kilonewtons{.force = kN, .length = m};

class ReadMatrix : public testing::WrittenFiles {
 protected:
  [[nodiscard]] MatrixInUnits read(const std::string& content, const MatrixUnits& units = kilonewtons) const {
    return read_matrix(write("K.txt", content), units);
  }
  // The message of a refusal behind the path of the file.
  [[nodiscard]] std::string refusal(const std::string& content) const {
    const std::string message = message_of<FileError>([&] { (void)read(content); }), file = path("K.txt").string();
    EXPECT_TRUE(message.starts_with(file)) << message;
    return message.substr(std::min(message.size(), file.size()));
  }
};

Eigen::MatrixXd expected() {
  Eigen::MatrixXd matrix(3, 3);
  matrix << 12345.678, -1.5, 0.0, -1.5, 250.0, -3e4, 0.0, -3e4, 9.0;
  return matrix;
}

TEST_F(ReadMatrix, KnowsEveryLayoutByItsContent) {
  for (const char* content :
       {"12345.678,-1.5,0\n-1.5,250,-3e4\n0,-3e4,9\n",  // CSV
        "\xEF\xBB\xBF"
        "12345.678, -1.5, 0\r\n-1.5, 250, -3e4\r\n0, -3e4, 9\r\n",      // of Windows
        "12345.678;-1.5;0\n-1.5;250;-3e4\n0;-3e4;9",                    //
        "12345.678\t-1.5\t0\n-1.5\t250\t-3e4\n0\t-3e4\t9\n",            //
        "\n12345.678 -1.5 0 \n-1.5 250 -30000 \n0 -30000 9 \n\n",       // printA of OpenSees
        "  1.2345678D+04  -1.5d0  +0.\n -1.5 2.5E2 -3e4\n\n 0 -3e4 9",  // Fortran
        "# kN/m\n% by hand\n// 2026\nStiffness of 3 floors\n12345.678 -1.5 0\n\n-1.5 250 -3e4\n# last\n0 -3e4 9\n",
        "stiffness\n12345.678,-1.5,0\n-1.5,250,-3e4\n0,-3e4,9\n",
        "%%MatrixMarket matrix coordinate real general\n% kN/m\n3 3 7\n1 1 12345.678\n1 2 -1.5\n2 1 -1.5\n2 2 250\n"
        "2 3 -3e4\n3 2 -3e4\n3 3 9\n",
        "%%MatrixMarket matrix coordinate real symmetric\n3 3 5\n1 1 12345.678\n2 1 -1.5\n2 2 250\n3 2 -3e4\n3 3 9\n",
        "%%matrixmarket MATRIX Array Real General\n3 3\n12345.678\n-1.5\n0\n-1.5\n250\n-3e4\n0\n-3e4\n9\n",
        "%%MatrixMarket matrix array real symmetric\n3 3\n12345.678\n-1.5\n0\n250\n-3e4\n9\n"}) {
    EXPECT_EQ(read(content).values, expected()) << content;
  }
  EXPECT_EQ(read("%%MatrixMarket matrix coordinate integer general\n2 2 1\n2 1 7\n").values,
            (Eigen::Matrix2d{{0.0, 0.0}, {7.0, 0.0}}));
  EXPECT_EQ(read("7").values, Eigen::MatrixXd::Constant(1, 1, 7.0));
}

TEST_F(ReadMatrix, TakesNamesOfRowsAndColumns) {
  const std::vector<std::string> names{"floor 1 x", "floor 2 x"};
  for (const char* content :
       {"floor 1 x,floor 2 x\n1,2\n2,3\n",                       //
        ",floor 1 x,floor 2 x\nfloor 1 x,1,2\nfloor 2 x,2,3\n",  //
        "kN/m;\"floor 1 x\";\"floor 2 x\"\nfloor 1 x;1;2\nfloor 2 x;2;3\n",
        "floor 1 x\tfloor 2 x\nfloor 1 x\t1\t2\nfloor 2 x\t2\t3\n", "floor 1 x,1,2\nfloor 2 x,2,3\n"}) {
    const MatrixInUnits matrix = read(content);
    EXPECT_EQ(matrix.names, names) << content;
    EXPECT_EQ(matrix.values, (Eigen::Matrix2d{{1.0, 2.0}, {2.0, 3.0}})) << content;
  }
  EXPECT_EQ(read("\"floor 1, x\",\"floor 2, x\"\n1,2\n2,3\n").names[1], "floor 2, x");
  EXPECT_TRUE(read("1,2\n2,3\n").names.empty());
}

TEST_F(ReadMatrix, KeepsUnitsAndSource) {
  const std::string content = "1234567,0\n0,1\n";
  const MatrixInUnits stiffness = read(content, {.force = kN, .length = mm});
  EXPECT_EQ(stiffness.force, 1e3);
  EXPECT_EQ(stiffness.length, 1e-3);
  EXPECT_DOUBLE_EQ(stiffness.mass, 1e6);
  EXPECT_EQ(stiffness.source, path("K.txt").string());
  EXPECT_TRUE(stiffness.notes.empty());
  const MatrixInUnits mass = read(content, {.length = m, .mass = tonne});
  EXPECT_EQ(mass.force, 0.0);
  EXPECT_EQ(mass.mass, 1e3);
  EXPECT_DOUBLE_EQ(read(content, {.force = N, .length = mm}).mass, 1e3) << "N s^2/mm are tonnes";
}

TEST_F(ReadMatrix, NotesTheFile) {
  const std::string content = "1,2\n3,4\n";
  const FilesOfThisThread files;
  (void)read(content);
  ASSERT_EQ(files.files().size(), 1u);
  EXPECT_EQ(files.files()[0], (FileRead{path("K.txt").string(), sha256_of(content)}));
}

TEST_F(ReadMatrix, NotesHeadingsAndFewDigits) {
  const std::string few =
      "no number of K.txt has more than 6 digits. Long periods are differences of large entries and lose digits: write "
      "17.";
  EXPECT_EQ(read("K of 2 floors\n-1.23456e+06 0.00123456\n1234560000.00 7\n").notes,
            (std::vector<std::string>{"heading: K of 2 floors", few}));
  EXPECT_TRUE(read("1234.567 0\n0 1\n").notes.empty());
  EXPECT_EQ(read("%%MatrixMarket matrix coordinate real general\n1 1 1\n1 1 2.5\n").notes,
            std::vector<std::string>{few});
}

TEST_F(ReadMatrix, FollowsTheFormatThatIsGiven) {
  MatrixUnits units = kilonewtons;
  units.format = MatrixFormat::csv;
  EXPECT_THROW((void)read("%%MatrixMarket matrix array real general\n2 2\n1\n2\n3\n4\n", units), FileError);
  units.format = MatrixFormat::text;
  EXPECT_EQ(read("1 2\n3 4\n", units).values, (Eigen::Matrix2d{{1.0, 2.0}, {3.0, 4.0}}));
  EXPECT_THROW((void)read("1,2\n3,4\n", units), FileError);
  units.format = MatrixFormat::matrix_market;
  EXPECT_THROW((void)read("1,2\n3,4\n", units), FileError);
}

TEST_F(ReadMatrix, RefusesRowsThatAreNoMatrix) {
  EXPECT_EQ(refusal("1,2,3\n\n4,5\n7,8,9\n"), ", line 3: it has 2 numbers, line 1 has 3.");
  EXPECT_EQ(refusal("1 2\n3 4\n5 6\n"),
            ": 3 lines of 2 numbers. A square matrix has as many lines as numbers in each.");
  EXPECT_EQ(refusal("1 2\n"), ": 1 line of 2 numbers. A square matrix has as many lines as numbers in each.");
  EXPECT_EQ(refusal("1,x\n3,4\n"), ", line 1: \"x\" is not a number.");
  EXPECT_EQ(refusal("1,2\n3,4 kN\n"), ", line 2: \"4 kN\" is not a number.");
  EXPECT_EQ(refusal("x,1\n3,4\n"), ", line 1: \"x\" is not a number.");
  EXPECT_EQ(refusal("1,2\n3,nan\n"), ", line 2: \"nan\" is not a number.");
  EXPECT_EQ(refusal("1,2\n3,1e400\n"), ", line 2: \"1e400\" is too large or too small for a double.");
  EXPECT_EQ(refusal("1,2,\n3,4,\n"), ", line 1: field 3 is empty.");
  EXPECT_EQ(refusal(""), ": it has no lines, or comments only.");
  EXPECT_EQ(refusal("# K\n\n"), ": it has no lines, or comments only.");
  EXPECT_EQ(refusal("stiffness\n"), ": there are no numbers in it.");
  EXPECT_EQ(refusal("stiffness\nfloor_1\nfloor_2\n"), ", line 2: there is no number behind \"floor_1\".");
}

TEST_F(ReadMatrix, RefusesDecimalCommas) {
  for (const char* content : {"1,5;2\n3;4\n", "1,5\t2\n3\t4\n", "1,5 2,5\n3 4,25\n"})
    EXPECT_NE(refusal(content).find("has a decimal comma. Write decimals with a point: 1.5."), std::string::npos)
        << content;
}

TEST_F(ReadMatrix, RefusesNamesThatDoNotFit) {
  EXPECT_EQ(refusal("a,b,c\n1,2\n3,4\n"), ", line 1: 3 names for 2 columns. Begin remarks with #.");
  EXPECT_EQ(refusal(",a,b\nb,1,2\na,3,4\n"),
            ": row 1 is \"b\", column 1 is \"a\". Rows and columns must have one order.");
  EXPECT_EQ(refusal("a,a\n1,2\n3,4\n"), ": two rows or columns have the name \"a\".");
  EXPECT_EQ(refusal("a,\n1,2\n3,4\n"), ": a row or a column has no name. Give all names, or none.");
}

TEST_F(ReadMatrix, RefusesOtherKindsOfMatrixMarket) {
  const auto banner = [&](const std::string& words) { return refusal("%%MatrixMarket " + words + "\n1 1 1\n1 1 1\n"); };
  const std::string advice = ". Write \"%%MatrixMarket matrix coordinate real symmetric\", for example.";
  EXPECT_EQ(banner("matrix coordinate complex general"),
            ", line 1: \"complex\" is not read here; it must be real or integer" + advice);
  EXPECT_EQ(banner("matrix coordinate pattern general"),
            ", line 1: \"pattern\" is not read here; it must be real or integer" + advice);
  EXPECT_EQ(banner("matrix coordinate real skew-symmetric"),
            ", line 1: \"skew-symmetric\" is not read here; it must be general or symmetric" + advice);
  EXPECT_EQ(banner("matrix coordinate real hermitian"),
            ", line 1: \"hermitian\" is not read here; it must be general or symmetric" + advice);
  EXPECT_EQ(banner("vector coordinate real general"),
            ", line 1: \"vector\" is not read here; it must be matrix or matrix" + advice);
  EXPECT_EQ(banner("matrix coordinate real"),
            ", line 1: it must be \"%%MatrixMarket matrix coordinate real symmetric\", for example.");
}

TEST_F(ReadMatrix, RefusesDamagedMatrixMarket) {
  const auto body = [&](const std::string& kind, const std::string& lines) {
    return refusal("%%MatrixMarket matrix " + kind + "\n" + lines);
  };
  EXPECT_EQ(body("coordinate real symmetric", "2 2 2\n2 1 5\n1 2 5\n"),
            ", line 4: entry 1 2 stands in line 3 too. A symmetric file has one triangle.");
  EXPECT_EQ(body("coordinate real general", "2 2 2\n2 1 5\n2 1 6\n"),
            ", line 4: entry 2 1 stands in line 3 too. Give it once.");
  EXPECT_EQ(body("coordinate real general", "2 3 1\n2 1 5\n"), ", line 2: \"2 3 1\" is no square matrix.");
  EXPECT_EQ(body("coordinate real general", "2 2\n2 1 5\n"), ", line 2: \"2 2\" must be rows, columns, entries.");
  EXPECT_EQ(body("array real general", "2 2 4\n1\n"), ", line 2: \"2 2 4\" must be rows, columns.");
  EXPECT_EQ(body("coordinate real general", "2 2 3\n2 1 5\n"), ": it has 1 entry, and its size asks for 3.");
  EXPECT_EQ(body("array real symmetric", "2 2\n1\n2\n3\n4\n"), ": it has 4 entries, and its size asks for 3.");
  for (const std::string count : {"-3", "1e300", "0"})
    EXPECT_EQ(body("coordinate real general", "2 2 " + count + "\n2 1 5\n"),
              ", line 2: \"" + count + "\" must be a whole number from 1 to 100000000.");
  EXPECT_EQ(body("coordinate real general", "10001 10001 1\n2 1 5\n"),
            ", line 2: \"10001\" must be a whole number from 1 to 10000.");
  EXPECT_EQ(body("coordinate real general", "2 2 1\n3 1 5\n"), ", line 3: \"3\" must be a whole number from 1 to 2.");
  EXPECT_EQ(body("coordinate real general", "2 2 1\n0 1 5\n"), ", line 3: \"0\" must be a whole number from 1 to 2.");
  EXPECT_EQ(body("coordinate real general", "2 2 1\n1 1.5 5\n"),
            ", line 3: \"1.5\" must be a whole number from 1 to 2.");
  EXPECT_EQ(body("coordinate real general", "2 2 1\n1 1\n"), ", line 3: \"1 1\" must be row, column, value.");
  EXPECT_EQ(body("array real general", "1 1\n1 2\n"), ", line 3: \"1 2\" must be one number.");
  EXPECT_EQ(body("coordinate real general", "2 2 1\n1 1 x\n"), ", line 3: \"x\" is not a number.");
  EXPECT_EQ(body("coordinate real general", ""), ": it has no lines, or comments only.");
}

TEST_F(ReadMatrix, AsksForUnits) {
  const std::string file = write("K.txt", "1").string(), begin = "read_matrix \"" + file + "\": ";
  const auto refused = [&](const MatrixUnits& units) { return message_of([&] { (void)read_matrix(file, units); }); };
  const std::string give = "Give the units of its entries: {.force = kN, .length = m}";
  EXPECT_EQ(refused({.length = m}),
            begin + "neither force nor mass is given. " + give + ", or {.length = m, .mass = tonne} for masses.");
  EXPECT_EQ(refused({.force = kN, .length = 0.0 * m}),
            begin + "length = 0 m is not allowed; it must be > 0 m and finite. " + give + ".");
  EXPECT_EQ(refused({.force = -kN, .length = m}),
            begin + "force = -1000 N is not allowed; it must be >= 0 N and finite. " + give + ".");
  EXPECT_EQ(refused({.length = m, .mass = -kg}),
            begin + "mass = -1 kg is not allowed; it must be >= 0 kg and finite. " + give + ".");
  EXPECT_THROW((void)read_matrix(path("none.csv"), kilonewtons), FileError);
}

TEST(InUnits, TakesAMatrixOfAScript) {
  const MatrixInUnits matrix = in_units(expected(), {.force = MN, .length = cm});
  EXPECT_EQ(matrix.values, expected());
  EXPECT_EQ(matrix.force, 1e6);
  EXPECT_EQ(matrix.length, 1e-2);
  EXPECT_TRUE(matrix.source.empty());
  EXPECT_EQ(message_of([] { (void)in_units(Eigen::MatrixXd::Zero(2, 3), kilonewtons); }),
            "in_units: the matrix is 2 x 3. Give a square one.");
  EXPECT_EQ(message_of([] { (void)in_units(Eigen::MatrixXd{}, kilonewtons); }),
            "in_units: the matrix is 0 x 0. Give a square one.");
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(message_of([&] { (void)in_units(Eigen::MatrixXd::Constant(1, 1, nan), kilonewtons); }),
            "in_units: the matrix has entries that are not finite. Give numbers.");
  EXPECT_THROW((void)in_units(expected(), {.length = m}), InputError);
}

// The data of the twelve-storey frame, one matrix in three layouts.
TEST(MatrixOfAFrame, IsTheSameInEveryLayout) {
  const char* experiments = std::getenv("MOAT_EXPERIMENTS");
  if (!experiments) GTEST_SKIP() << "set MOAT_EXPERIMENTS to a folder with frame12 to run this test";
  const std::filesystem::path folder = std::filesystem::path{experiments} / "frame12";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "frame12 is not in the folder of MOAT_EXPERIMENTS";
  const MatrixInUnits csv = read_matrix(folder / "stiffness_kN_m.csv", kilonewtons);
  EXPECT_EQ(csv.values, read_matrix(folder / "stiffness_kN_m.mtx", kilonewtons).values);
  EXPECT_TRUE(csv.notes.empty());
  const MatrixInUnits printed = read_matrix(folder / "printA.txt", kilonewtons);
  EXPECT_EQ(printed.notes.size(), 1u);
  // Half a unit of the sixth digit.
  EXPECT_LE(((csv.values - printed.values).array().abs() / csv.values.array().abs()).maxCoeff(), 5.0e-6);
  const Eigen::MatrixXd whole = read_matrix(folder / "stiffness_with_base_kN_m.csv", kilonewtons).values;
  EXPECT_EQ(whole.bottomRightCorner(12, 12), csv.values);

  // t, floors 60, roof 50: the periods were computed by an independent program.
  Eigen::VectorXd mass = Eigen::VectorXd::Constant(12, 60.0);
  mass[11] = 50.0;
  const auto first_period = [&](const Eigen::MatrixXd& stiffness) {
    const Eigen::VectorXd root = mass.cwiseSqrt().cwiseInverse();
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> modes{root.asDiagonal() * stiffness * root.asDiagonal()};
    return 2.0 * pi / std::sqrt(modes.eigenvalues()[0]);
  };
  EXPECT_NEAR(first_period(csv.values), 1.08026131, 5e-9);
  EXPECT_NEAR(first_period(printed.values), 1.08018843, 5e-9);
}

}  // namespace
}  // namespace moat
