#include "report/page_data.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "report_testing.hpp"

namespace moat {
namespace {

nlohmann::json data_of(const CaseResult& result) { return nlohmann::json::parse(html::page_data(result)); }

void expect_near(const nlohmann::json& written, const std::vector<double>& values, double factor = 1.0) {
  ASSERT_EQ(written.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(written[i].get<double>(), factor * values[i], 1e-4 * std::abs(factor * values[i])) << i;
}

TEST(PageData, HasTheMotionOfEveryNode) {
  const CaseResult result = testing_report::line_result();
  const nlohmann::json data = data_of(result);
  const std::vector<double>& time = result.histories.values("time");
  EXPECT_EQ(data["rows"], time.size());
  EXPECT_DOUBLE_EQ(data["interval"].get<double>(), time[1]);
  ASSERT_EQ(data["motions"].size(), 3u);
  expect_near(data["motions"][2], result.histories.values("displacement", "floor 2"));
  EXPECT_EQ(data["charts"].size(), 3u);
  expect_near(data["charts"][0]["series"][1]["values"], result.histories.values("displacement", "floor 2"), 100.0);
  ASSERT_EQ(data["impacts"].size(), result.impacts.size());
  ASSERT_FALSE(result.impacts.empty());
  EXPECT_EQ(data["impacts"][0]["where"], result.impacts[0].where);
  EXPECT_NEAR(data["impacts"][0]["end"].get<double>(), result.impacts[0].start + result.impacts[0].duration, 1e-6);
}

TEST(PageData, GivesRotationsInMetres) {
  const CaseResult result = testing_report::plan_result();
  const nlohmann::json data = data_of(result);
  ASSERT_EQ(data["motions"].size(), result.model.nodes.size());
  const DiaphragmFacts& base = result.model.diaphragms.front();
  ASSERT_EQ(result.model.nodes[2].name, base.name + ":r");
  expect_near(data["motions"][1], result.histories.values("displacement_y", base.name));
  expect_near(data["motions"][2], result.histories.values("rotation", base.name), base.gyration);
}

TEST(PageData, ThinsVeryLongHistories) {
  Column time{"time", "", "s", {}}, displacement{"displacement", "body", "m", {}};
  for (int i = 0; i < 45'000; ++i) {
    time.values.push_back(0.01 * i);
    displacement.values.push_back(i);
  }
  CaseResult result = testing_report::result_with({time, displacement});
  const nlohmann::json data = data_of(result);
  EXPECT_EQ(data["rows"], 15'000);
  EXPECT_DOUBLE_EQ(data["interval"].get<double>(), 0.03);
  EXPECT_EQ(data["charts"][0]["series"][0]["values"].size(), 15'000u);
  EXPECT_DOUBLE_EQ(data["charts"][0]["series"][0]["values"][1].get<double>(), 300.0) << "cm";
}

TEST(PageData, IsNothingWithoutHistories) { EXPECT_EQ(html::page_data({}), ""); }

}  // namespace
}  // namespace moat
