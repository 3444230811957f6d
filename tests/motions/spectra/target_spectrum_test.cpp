// Spectra from tables and files.
#include "motions/spectra/target_spectrum.hpp"

#include <gtest/gtest.h>

#include <string>

#include "base/units.hpp"
#include "motion_files.hpp"

namespace moat {
namespace {

using namespace units;

SpectrumTable table() {
  return {.name = "mine",
          .periods = {0.01 * s, 0.1 * s, 1 * s, 10 * s},
          .accelerations = {0.4 * g, 1 * g, 0.6 * g, 0.03 * g}};
}

double in_g(const TargetSpectrum& spectrum, double period) { return spectrum.acceleration(period * s) / g; }

TEST(SpectrumTable, IsStraightBetweenItsPoints) {
  const TargetSpectrum spectrum = table();
  EXPECT_EQ(spectrum.name, "mine");
  EXPECT_EQ(spectrum.corners.size(), 4u);
  EXPECT_NEAR(in_g(spectrum, 0.01), 0.4, 1e-15);
  EXPECT_NEAR(in_g(spectrum, 0.055), 0.7, 1e-15);
  EXPECT_NEAR(in_g(spectrum, 0.1), 1.0, 1e-15);
  EXPECT_NEAR(in_g(spectrum, 0.55), 0.8, 1e-14);
  EXPECT_NEAR(in_g(spectrum, 10.0), 0.03, 1e-15);
  EXPECT_EQ(message_of([&] { (void)spectrum.acceleration(12 * s); }),
            "TargetSpectrum \"mine\": period = 12 s is not allowed; it must be from 0.01 s to 10 s. The table ends "
            "there.");
  EXPECT_EQ(message_of([&] { (void)spectrum.acceleration(0 * s); }),
            "TargetSpectrum \"mine\": period = 0 s is not allowed; it must be from 0.01 s to 10 s. Check its sign and "
            "its unit.");
}

TEST(SpectrumTable, GoesOnToTheLongPeriodAndBeyond) {
  SpectrumTable longer = table();
  longer.long_period = 16 * s;
  const TargetSpectrum spectrum = longer;
  EXPECT_NEAR(in_g(spectrum, 15.0), 0.02, 1e-15);
  EXPECT_NEAR(in_g(spectrum, 32.0), 0.03 * 10.0 * 16.0 / (32.0 * 32.0), 1e-15);
  EXPECT_NE(spectrum.source.find("recalled, not read in the code"), std::string::npos);
  longer.long_period = 8 * s;
  EXPECT_NEAR(in_g(longer, 20.0), 0.0075, 1e-15);
}

TEST(SpectrumTable, RefusesBadPoints) {
  const auto message = [](auto change) {
    SpectrumTable bad = table();
    change(bad);
    return message_of([&] { (void)static_cast<TargetSpectrum>(bad); });
  };
  using T = SpectrumTable;
  EXPECT_EQ(message([](T& bad) { bad.accelerations.pop_back(); }),
            "SpectrumTable \"mine\": it has 4 periods and 3 accelerations. Give at least two periods, and an "
            "acceleration for each.");
  EXPECT_EQ(message([](T& bad) { bad.periods[2] = 0.1 * s; }),
            "SpectrumTable \"mine\": period = 0.1 s is not allowed; it must be > 0.1 s, the one before. Sort the table "
            "by periods.");
  EXPECT_NE(message([](T& bad) { bad.periods[0] = -1 * s; }).find("it must be >= 0 s."), std::string::npos);
  EXPECT_NE(message([](T& bad) { bad.accelerations[1] = 0 * g; }).find("acceleration at 0.1 s = 0 m/s^2"),
            std::string::npos);
  EXPECT_NE(message([](T& bad) { bad.damping_ratio = 5; }).find("Give 5 % as 0.05."), std::string::npos);
  EXPECT_EQ(message([](T& bad) {
              bad.periods[3] = 5 * s;
              bad.long_period = 8 * s;
            }),
            "SpectrumTable \"mine\": last period = 5 s is not allowed; it must be >= 10 s where long_period is given. "
            "Leave out long_period, or give the whole table.");
  EXPECT_NE(message([](T& bad) { bad.long_period = 0 * s; }).find("long_period = 0 s"), std::string::npos);
}

using TargetFiles = MotionFiles;

TEST_F(TargetFiles, InCsvAreRead) {
  const auto file = write("site.csv", "# of the report\nperiod_s,sa_g\r\n0, 0.5\n0.2,1.25\n\n2,.5\n");
  const TargetSpectrum spectrum = read_target_spectrum(file, {.level = SpectrumLevel::mce_r, .damping_ratio = 0.1});
  EXPECT_EQ(spectrum.name, "site, MCE_R");
  EXPECT_EQ(spectrum.source, "file site.csv");
  EXPECT_EQ(spectrum.damping_ratio, 0.1);
  EXPECT_NEAR(in_g(spectrum, 0.1), 0.875, 1e-15);
  EXPECT_NEAR(in_g(spectrum, 2.0), 0.5, 1e-15);
  EXPECT_EQ(read_target_spectrum(file).name, "site");
}

const std::string answer = R"({"request": {"status": "success"}, "response": {"data": {"sds": 1.0, "tl": 12,
  "multiPeriodDesignSpectrum": {"periods": [0.0, 1.0, 10.0], "ordinates": [0.4, 0.6, 0.05]},
  "multiPeriodMCErSpectrum": {"periods": [0.0, 1.0, 10.0], "ordinates": [0.6, 0.9, 0.075]}}}})";

TEST_F(TargetFiles, OfTheServiceOfTheUsgsAreRead) {
  const auto file = write("answer.json", answer);
  const TargetSpectrum design = read_target_spectrum(file, {.level = SpectrumLevel::design}),
                       mce_r = read_target_spectrum(file, {.level = SpectrumLevel::mce_r});
  EXPECT_EQ(design.name, "answer, design");
  EXPECT_NEAR(in_g(design, 0.5), 0.5, 1e-15);
  EXPECT_NEAR(in_g(mce_r, 0.5), 0.75, 1e-15);
  EXPECT_NEAR(in_g(mce_r, 24.0), 0.075 * 10.0 * 12.0 / (24.0 * 24.0), 1e-15);  // the file states T_L
  EXPECT_NE(design.source.find("answer.json, service asce7-22 of the USGS; beyond 10 s"), std::string::npos);
  EXPECT_NEAR(in_g(read_target_spectrum(file, {.level = SpectrumLevel::design, .long_period = 5 * s}), 20.0), 0.0125,
              1e-15);
}

TEST_F(TargetFiles, OfOtherFormsAreRefused) {
  const auto message = [&](const char* name, const std::string& text, const TargetFile& options = {}) {
    const auto file = write(name, text);
    std::string found = message_of<Error>([&] { (void)read_target_spectrum(file, options); });
    return found.starts_with(file.string()) ? found.substr(file.string().size()) : found;
  };
  EXPECT_EQ(message("a.csv", "T,Sa\n0,1\n"),
            ", line 1: expected the heading period_s,sa_g but found \"T,Sa\". Give periods in s and accelerations in "
            "g, separated by commas.");
  for (const char* line : {"0.1", "0.1,", "0.1,a", "0.1,1,2"})
    EXPECT_EQ(message("a.csv", std::string{"period_s,sa_g\n0,1\n"} + line),
              std::string{", line 3: expected a period in s and an acceleration in g, separated by a comma, but found "
                          "\""} +
                  line + "\".");
  EXPECT_NE(message("a.csv", "period_s,sa_g\n0,1\n").find("it has 1 periods and 1 accelerations."), std::string::npos);
  EXPECT_NE(message("a.csv", "").find("it has 0 periods"), std::string::npos);
  EXPECT_EQ(message("a.json", answer),
            ": it holds the design and the MCE_R spectrum. Say which: .level = SpectrumLevel::mce_r.");
  const TargetFile design{.level = SpectrumLevel::design};
  for (const std::string& text : {std::string{"{}"}, std::string{"{\"response\": 1}"}, answer.substr(0, 100)})
    EXPECT_NE(message("a.json", text, design)
                  .find(": it is no answer of the service asce7-22 of the USGS with multi-period spectra ("),
              std::string::npos)
        << text;
  std::string uneven = answer;
  uneven.replace(uneven.find("0.4, "), 5, "");
  EXPECT_EQ(message("a.json", uneven, design), ": periods and ordinates are not equally many.");
  EXPECT_NE(message("a.json", answer, {.level = SpectrumLevel::design, .damping_ratio = 5.0}).find("5 % as 0.05"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
