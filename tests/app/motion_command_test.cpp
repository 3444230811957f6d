// The command `moat motion`.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

class MotionCommand : public testing::InTemporaryFolder {
 protected:
  MotionCommand() {
    // A constant acceleration of 0.5 g over 4 s, in the format of PEER and in two columns.
    std::ofstream at2{folder / "constant.AT2"}, columns{folder / "columns.txt"};
    at2 << "SYNTHETIC\nTest\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 401, DT= .01 SEC\n";
    for (int i = 0; i <= 400; ++i) {
      at2 << " .5E+00\n";
      columns << 0.01 * i << " 0.5\n";
    }
  }
  ProgramResult motion(std::vector<std::string> arguments) {
    return testing::run_program(MOTION_COMMAND, std::move(arguments), folder);
  }
};

TEST_F(MotionCommand, ShowsTheMeasuresInEngineeringUnits) {
  const ProgramResult result = motion({"constant.AT2"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.errors, "");
  // PGV = 0.5 g t, PGD = 0.25 g t^2, pi/(2 g) (0.5 g)^2 t, 90 % of 4 s.
  for (const char* text :
       {"PGA                   0.5 g", "PGV                   1961 cm/s", "PGD                   3923 cm",
        "Arias intensity       15.4 m/s", "significant duration  3.60 s", "from 0.20 s to 3.80 s",
        "pseudo-acceleration [g] with 5 % damping"})
    EXPECT_NE(result.output.find(text), std::string::npos) << text << "\n" << result.output;
}

TEST_F(MotionCommand, JsonIsInSiUnits) {
  const ProgramResult result = motion({"constant.AT2", "--json", "--damping", "0.02"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json printed = json::parse(result.output).at(0);
  constexpr double g = 9.80665;
  EXPECT_EQ(printed.at("name"), "constant");
  EXPECT_EQ(printed.at("units").at("arias_intensity"), "m/s");
  EXPECT_EQ(printed.at("units").at("peak_acceleration"), "m/s^2");
  EXPECT_NEAR(printed.at("peak_acceleration").get<double>(), 0.5 * g, 1e-9);
  EXPECT_NEAR(printed.at("arias_intensity").get<double>(), std::numbers::pi / (2.0 * g) * 0.25 * g * g * 4.0, 1e-9);
  EXPECT_NEAR(printed.at("significant_duration").at("start").get<double>(), 0.2, 1e-9);
  EXPECT_NEAR(printed.at("significant_duration").at("length").get<double>(), 3.6, 1e-9);
  const json& spectrum = printed.at("spectrum");
  EXPECT_EQ(spectrum.at("damping_ratio"), 0.02);
  EXPECT_EQ(spectrum.at("period").size(), spectrum.at("pseudo_acceleration").size());
  // A step of acceleration is doubled by a short oscillator, but for its damping: 1 + exp(-pi z/sqrt(1 - z^2)).
  const double expected = 0.5 * g * (1.0 + std::exp(-std::numbers::pi * 0.02 / std::sqrt(1.0 - 0.0004)));
  EXPECT_NEAR(spectrum.at("pseudo_acceleration").at(0).get<double>() / expected, 1.0, 1e-4);
}

TEST_F(MotionCommand, WritesOneChartAndOneTableOfAllMotions) {
  const ProgramResult result = motion({"constant.AT2", "columns.txt", "--unit", "g", "--out", "a/b"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const std::string svg = text_of(folder / "a/b/spectrum.svg"), csv = text_of(folder / "a/b/spectrum.csv");
  EXPECT_NE(svg.find("<svg"), std::string::npos) << svg.substr(0, 40);
  EXPECT_EQ(csv.substr(0, csv.find('\n')),
            "period [s],pseudo_acceleration [m/s^2] constant,pseudo_acceleration [m/s^2] columns");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 121);
}

TEST_F(MotionCommand, RefusesWithTheRemedy) {
  ProgramResult result = motion({"columns.txt"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.output, "");
  EXPECT_NE(result.errors.find("Give the unit: --unit g,"), std::string::npos) << result.errors;
  // The readers name options as scripts have them; both names serve.
  std::ofstream{folder / "series.txt"} << "0.1\n0.5\n-0.2\n";
  result = motion({"series.txt", "--unit", "g"});
  EXPECT_NE(result.errors.find("Give it: --record-step"), std::string::npos) << result.errors;
  for (const char* name : {"--record-step", "--step"}) {
    result = motion({"series.txt", "--record-unit", "g", name, "0.01 s", "--record-columns", "series"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.output.find("every 0.01 s"), std::string::npos) << result.output;
  }
  result = motion({"none.AT2"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("there is no such file"), std::string::npos);
  EXPECT_EQ(motion({"constant.AT2", "--damping", "2"}).exit_code, 1);
  EXPECT_EQ(motion({}).exit_code, 2);
  const auto unknown = motion({"constant.AT2", "--dampin", "0.05"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_EQ(
      unknown.errors,
      "moat: error: moat motion has no option --dampin. Did you mean --damping?\nmoat: --help lists all options.\n");
  EXPECT_EQ(motion({"--help"}).exit_code, 0);
}

}  // namespace
}  // namespace moat
