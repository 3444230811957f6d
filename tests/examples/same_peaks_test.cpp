// The tours with the convenience layer and by hand make the same building: same peaks.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;

class Tours : public testing::InTemporaryFolder {
 protected:
  json summary_of(const char* program, const std::string& out) {
    const auto result = testing::run_program(program, {"--out", out, "--frame-interval", "0 s"}, folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(testing::text_of(folder / out / "summary.json"));
  }
};

using Peaks = std::map<std::pair<std::string, std::string>, double>;

Peaks peaks_of(const json& summary) {
  Peaks peaks;
  for (const json& peak : summary.at("peaks"))
    peaks[{peak.at("quantity").get<std::string>(), peak.at("where").get<std::string>()}] =
        peak.at("value").get<double>();
  return peaks;
}

// The motion makes both buildings pound, so that the impacts are compared too. Storeys of the first have shears and
// moments that nodes and springs by hand do not have.
void expect_same(const json& one, const json& other, double tolerance) {
  const Peaks expected = peaks_of(one), peaks = peaks_of(other);
  ASSERT_LE(peaks.size(), expected.size());
  for (const auto& [key, value] : expected) {
    const bool of_storeys = key.first.starts_with("storey_") || key.first.starts_with("overturning_");
    if (of_storeys && peaks.count(key) == 0) continue;
    ASSERT_EQ(peaks.count(key), 1u) << key.first << " " << key.second;
    EXPECT_LE(std::abs(peaks.at(key) - value), tolerance * std::abs(value)) << key.first << " " << key.second;
  }
  EXPECT_GT(one.at("impacts").get<int>(), 0);
  EXPECT_EQ(one.at("impacts"), other.at("impacts"));
}

TEST_F(Tours, OneAndTwoHaveTheSamePeaks) {
  const json first = summary_of(FIRST_TOUR, "first"), second = summary_of(SECOND_TOUR, "second");
  expect_same(first, second, 1e-12);
  ASSERT_GE(first.at("peaks").size(), 6u + 6u + 5u + 5u + 4u);
  for (const auto& [key, value] : peaks_of(first)) EXPECT_NE(value, 0.0) << key.first << " " << key.second;
  ASSERT_EQ(first.at("periods").size(), second.at("periods").size());
  for (std::size_t i = 0; i < first.at("periods").size(); ++i)
    EXPECT_NEAR(first.at("periods").at(i).at("value").get<double>(),
                second.at("periods").at(i).at("value").get<double>(), 1e-12);
}

TEST_F(Tours, FiveAndSixHaveTheSamePeaks) {
  const json fifth = summary_of(FIFTH_TOUR, "fifth"), sixth = summary_of(SIXTH_TOUR, "sixth");
  expect_same(fifth, sixth, 1e-9);
  EXPECT_GT(fifth.at("energy").at("friction").get<double>(), 0.0);
  EXPECT_EQ(fifth.at("impact_table").at(0).at("edge"), sixth.at("impact_table").at(0).at("edge"));
}

TEST_F(Tours, SevenNamesTheAngleOfTheLargestResults) {
  const auto result = testing::run_program(SEVENTH_TOUR, {"--step", "120"}, folder);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("incidence = "), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("eccentricity = "), std::string::npos) << result.output;
}

}  // namespace
}  // namespace moat
