// A floor on four columns in the layout of SAP2000's files. The files are made for this test, not by SAP2000.
#include "structures/frame/sap2000.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <string>
#include <tuple>

#include "base/error.hpp"
#include "base/units.hpp"
#include "message_of.hpp"
#include "written_files.hpp"

namespace moat {
namespace {

using namespace units;

const std::filesystem::path samples = MOAT_SOURCE_DIR "/tests/structures/frame/space_floor";

class Sap2000 : public testing::WrittenFiles {
 protected:
  Sap2000() {
    for (const auto& entry : std::filesystem::directory_iterator{samples})
      std::filesystem::copy(entry.path(), path(entry.path().filename().string()));
  }

  FiniteElements read(const MatrixUnits& units = {.force = kN, .length = m}) const {
    return read_sap2000(path("space_floor"), path("joints.csv"), units);
  }

  // Replaces a text in a file.
  void change(const std::string& name, const std::string& from, const std::string& to) const {
    std::string text = testing::read_file(path(name));
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ignore = write(name, text.replace(at, from.size(), to));
  }

  std::string message(const std::string& name, const std::string& from, const std::string& to) const {
    const std::string whole = testing::read_file(path(name));
    change(name, from, to);
    std::string text = testing::message_of<FileError>([&] { return read(); });
    std::ignore = write(name, whole);
    const std::size_t begin = text.find(folder.string());
    return begin == std::string::npos ? text : text.erase(begin, folder.string().size() + 1);
  }
};

void expect_closed_form(const CondensedStructure& floor) {
  const double E = 206e9, h = 3.5, kx = 3 * E * 5e-4 / (h * h * h), ky = 1.6 * kx;
  double Sx = 0, Sy = 0, Sxx = 0, Syy = 0;
  for (const auto& [X, Y] : {std::pair{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {1.0, 5.0}}) {
    Sx += X - 3.1;
    Sy += Y - 2.2;
    Sxx += (X - 3.1) * (X - 3.1);
    Syy += (Y - 2.2) * (Y - 2.2);
  }
  Eigen::Matrix3d expected;
  expected << 4 * kx, 0, -kx * Sy, 0, 4 * ky, ky * Sx, -kx * Sy, ky * Sx,
      kx * Syy + ky * Sxx + 4 * E / 2.6 * 1.2e-3 / h;
  EXPECT_LT((floor.stiffness - expected).norm(), 1e-12 * expected.norm());
  EXPECT_LT((floor.mass - Eigen::MatrixXd{Eigen::Vector3d{24e3, 24e3, 150e3}.asDiagonal()}).norm(), 1e-6);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.x, 3.1, 1e-12);
  EXPECT_NEAR(floor.levels[0].centre_of_mass.y, 2.2, 1e-12);
}

TEST_F(Sap2000, FloorHasItsClosedForm) {
  FiniteElements model = read();
  EXPECT_EQ(model.nodes.size(), 8U);
  model.diaphragms = {{.height = 3.5 * m}};
  expect_closed_form(condensed(model));
}

TEST_F(Sap2000, UnitsAreThoseOfTheFile) {
  // The same numbers in N and mm: lengths of coefficients and joints, and powers of length in the matrices.
  FiniteElements model = read({.force = N, .length = mm, .mass = tonne});
  const FiniteElements in_m = read({.force = N, .length = m, .mass = tonne});
  EXPECT_DOUBLE_EQ(model.equations.coeff(24, 14), 2.2e-3);
  EXPECT_DOUBLE_EQ(model.stiffness.coeff(0, 0), 1e3 * in_m.stiffness.coeff(0, 0));   // N/mm
  EXPECT_DOUBLE_EQ(model.stiffness.coeff(13, 1), in_m.stiffness.coeff(13, 1));       // N
  EXPECT_DOUBLE_EQ(model.stiffness.coeff(1, 1), 1e-3 * in_m.stiffness.coeff(1, 1));  // N mm
  EXPECT_DOUBLE_EQ(model.mass.coeff(12, 12), 24e3);
  EXPECT_DOUBLE_EQ(model.mass.coeff(14, 14), 150e-3);
  // Left out, the unit of mass is force s^2/length.
  EXPECT_DOUBLE_EQ(read({.force = N, .length = mm}).mass.coeff(12, 12), 24e3);
  change("joints.csv", "x [m],y [m],z [m]", "x [cm],y [m],z [m]");
  EXPECT_DOUBLE_EQ(read().nodes[5].x.si(), 0.06);
}

TEST_F(Sap2000, RecordMayGoOnInTheNextLine) {
  change("space_floor.TXE", "\t3\t-3", "\t3\t\n-3");
  FiniteElements model = read();
  model.diaphragms = {{.height = 3.5 * m}};
  expect_closed_form(condensed(model));
}

TEST_F(Sap2000, MassesMayBeMissing) {
  std::filesystem::remove(path("space_floor.TXM"));
  FiniteElements model = read();
  model.diaphragms = {{.height = 3.5 * m}};
  EXPECT_EQ(condensed(model).mass.norm(), 0.0);
}

TEST_F(Sap2000, BadFilesAreRefused) {
  EXPECT_EQ(message("space_floor.TXK", "14\t2\t", "1031\t2\t"),
            "space_floor.TXK, line 4: TXE has no equation 1031, TXK has.");
  EXPECT_EQ(message("space_floor.TXK", "14\t2\t", "1\t1\t"),
            "space_floor.TXK, line 4: entry (1, 1) stands in line 2 already. One triangle is expected.");
  EXPECT_EQ(message("space_floor.TXK", "14\t2\t", "14\t2.5\t"), "space_floor.TXK, line 4: 2.5 is no whole number.");
  EXPECT_EQ(message("space_floor.TXK", "Row\tColumn\tValue\n", ""),
            "space_floor.TXK, line 1: there are numbers where the heading must stand.");
  EXPECT_EQ(message("space_floor.TXK", "14\t2\t", "14\t"), "space_floor.TXK, line 4: has 2 fields, not 3.");
  EXPECT_EQ(message("space_floor.TXC", "-2\t14", "-2\t31"),
            "space_floor.TXC, line 4: TXE has no equation 31, TXC has.");
  EXPECT_EQ(message("space_floor.TXC", "-12\t15", "-13\t15"), "space_floor.TXE: TXC has no constraint -12, TXE has.");
  EXPECT_EQ(
      message("space_floor.TXE", "\t0\t15", "\t0\t1000000000"),
      "space_floor.TXE: it has 15 equations, and the last has the number 1000000000. They must be numbered 1, 2, 3 "
      "and so on.");
  EXPECT_EQ(message("space_floor.TXE", "\n8\t", "\n9\t"),
            "space_floor.TXE, line 9: joint 9 has no coordinates. Add it to the file of joints.");
  EXPECT_EQ(message("joints.csv", "8,1,5,3.5", "8,1,5,3.5\n9,1,1,1"),
            "space_floor.TXE: it has 8 joints, the file of joints has 9.");
  EXPECT_EQ(message("joints.csv", "x [m]", "x"), "joints.csv, line 1: the heading must be joint,x [m],y [m],z [m].");
  EXPECT_EQ(message("joints.csv", "8,1,5,3.5", "8,1,5,high"), "joints.csv, line 9: \"high\" is not a number.");
  EXPECT_NE(testing::message_of([&] { return read({.length = m}); }).find("force"), std::string::npos);
}

}  // namespace
}  // namespace moat
