#include "output/summary.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "output_testing.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

class Summary : public testing_output::InFolder {};

CaseResult example() {
  CaseResult result;
  result.title = "Five storeys \"in\" a moat";
  result.motion = {"record", 3.92266, 0.45, 0.005, 28.0};
  result.periods = {{"isolated", 2.1}, {"fixed base", 1.0 / 3.0}};
  result.peaks = {{"displacement", "base", 0.1234567, "m", 4.5},
                  {"absolute_acceleration", "floor 5", 12.5, "m/s^2", 12.25},
                  {"displacement", "floor 5", 0.05, "m", 14.5},
                  {"impact_force", "moat left", 25.65e6, "N", 4.25}};
  result.impacts = {{"moat left", 3.25, 0.125, 0.5, 0.01, 2.5e7, 0.75, 0.7, 1e5},
                    {"moat right", 5.0, 0.25, 1.5, 0.02, 3e7, 0.5, 0.6, 2e5}};
  result.solver = {.accepted_steps = 11,
                   .rejected_steps = 12,
                   .repeated_steps = 17,
                   .event_solves = 13,
                   .events = 14,
                   .newton_iterations = 15,
                   .factorisations = 16,
                   .cpu_seconds = 0.5,
                   .longest_step = 0.005};
  result.assumptions = {"Average acceleration.", "Signs: tension positive."};
  return result;
}

TEST_F(Summary, ReadsBackWithEveryField) {
  write_summary_json(example(), folder / "summary.json");
  const Json json = Json::parse(testing_output::read_file(folder / "summary.json"));
  EXPECT_EQ(json["title"], "Five storeys \"in\" a moat");
  EXPECT_TRUE(json["moat_version"].is_string());
  EXPECT_EQ(json["motion"],
            Json::parse(R"({"name": "record", "peak_acceleration": 3.92266, "peak_velocity": 0.45, "time_step": 0.005,
                            "duration": 28.0})"));
  EXPECT_EQ(json["periods"][1]["name"], "fixed base");
  EXPECT_EQ(json["periods"][1]["value"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["assumptions"], Json::parse(R"(["Average acceleration.", "Signs: tension positive."])"));
  ASSERT_EQ(json["peaks"].size(), 4u);
  EXPECT_EQ(json["peaks"][0], Json::parse(R"({"quantity": "displacement", "where": "base", "value": 0.1234567,
                                              "unit": "m", "time": 4.5, "error": null})"));
  ASSERT_TRUE(json["impacts"].is_number_integer());
  EXPECT_EQ(json["impacts"], 2);
  ASSERT_EQ(json["impact_table"].size(), 2u);
  EXPECT_EQ(json["impact_table"][0],
            Json::parse(R"({"where": "moat left", "start": 3.25, "duration": 0.125, "approach_speed": 0.5,
                            "largest_indentation": 0.01, "largest_force": 2.5e7, "rebound_ratio": 0.75,
                            "restitution": 0.7, "energy_lost": 1e5})"));
  EXPECT_EQ(json["solver"], Json::parse(R"({"accepted_steps": 11, "rejected_steps": 12, "repeated_steps": 17,
                                            "event_solves": 13,
                                            "events": 14, "newton_iterations": 15, "factorisations": 16,
                                            "cpu_seconds": 0.5, "longest_step": 0.005})"));
}

TEST_F(Summary, HasTheErrorsOfPeaks) {
  CaseResult result = example();
  for (Peak& peak : result.peaks) peak.error = 0.001 * peak.value;
  result.peaks[1].error = std::numeric_limits<double>::infinity();
  result.error_bars = {.checked = true,
                       .companion = "Finer.",
                       .companion_impacts = 3,
                       .companion_solver = {.accepted_steps = 22, .cpu_seconds = 0.75},
                       .sensitive = true,
                       .reason = "it has 3 impacts instead of 2",
                       .unsettled = {result.peaks[1]}};
  write_summary_json(result, folder / "summary.json");
  const Json json = Json::parse(testing_output::read_file(folder / "summary.json"));
  EXPECT_EQ(json["peaks"][0]["error"].get<double>(), 0.001 * 0.1234567);
  EXPECT_TRUE(json["peaks"][1]["error"].is_null());
  const Json& bars = json["error_bars"];
  EXPECT_EQ(bars["checked"], true);
  EXPECT_TRUE(bars["method"].is_string());
  EXPECT_EQ(bars["companion"], "Finer.");
  EXPECT_EQ(bars["companion_impacts"], 3);
  EXPECT_EQ(bars["companion_solver"]["accepted_steps"], 22);
  EXPECT_EQ(bars["companion_solver"]["cpu_seconds"], 0.75);
  EXPECT_EQ(bars["companion_solver"].size(), json["solver"].size());
  EXPECT_EQ(json["solver"]["accepted_steps"], 11) << "the costs of the two runs stay apart";
  EXPECT_EQ(bars["sensitive"], true);
  EXPECT_EQ(bars["reason"], "it has 3 impacts instead of 2");
  EXPECT_EQ(bars["unsettled"], Json::parse(R"([{"quantity": "absolute_acceleration", "where": "floor 5"}])"));
}

TEST_F(Summary, SaysWhyThereAreNoErrors) {
  CaseResult result = example();
  result.error_bars.companion = "No error bars: a reason.";
  write_summary_json(result, folder / "summary.json");
  const Json bars = Json::parse(testing_output::read_file(folder / "summary.json"))["error_bars"];
  EXPECT_EQ(bars["checked"], false);
  EXPECT_EQ(bars["companion"], "No error bars: a reason.");
  for (const char* field : {"companion_impacts", "companion_solver", "sensitive"})
    EXPECT_TRUE(bars.at(field).is_null()) << field;
  EXPECT_EQ(bars["unsettled"], Json::array());
}

TEST_F(Summary, StaysValidWithoutResultsOrFiniteNumbers) {
  CaseResult result;
  result.title = "broken \xff text";
  result.peaks = {{"drift", "storey 1", std::numeric_limits<double>::quiet_NaN(), "m", 0.0}};
  write_summary_json(result, folder / "summary.json");
  const Json json = Json::parse(testing_output::read_file(folder / "summary.json"));
  EXPECT_TRUE(json["peaks"][0]["value"].is_null());
  EXPECT_EQ(json["impacts"], 0);
  EXPECT_TRUE(json["impact_table"].is_array());
  EXPECT_TRUE(json["periods"].is_array());
}

TEST(PeakTable, GroupsByQuantityInEngineeringUnits) {
  EXPECT_EQ(peak_table(example()),
            "peak displacement [cm]\n"
            "  base       12.35   at  4.500 s\n"
            "  floor 5     5.00   at 14.500 s\n"
            "peak absolute acceleration [m/s^2]\n"
            "  floor 5    12.50   at 12.250 s\n"
            "peak impact force [kN]\n"
            "  moat left  25650   at  4.250 s\n");
  EXPECT_EQ(peak_table(CaseResult{}), "");
}

TEST(PeakTable, GivesEveryValueTheDigitsThatItsErrorLeaves) {
  CaseResult result;
  result.peaks = {{"displacement", "base", 0.532812, "m", 4.5, 0.000151},
                  {"displacement", "floor 1", 0.532812, "m", 14.5, 0.0031},
                  {"displacement", "floor 2", 0.532812, "m", 14.5, 0.0000036},
                  {"displacement", "floor 3", 0.532812, "m", 4.5},
                  {"impact_force", "moat left", 25.6512e6, "N", 4.25, 33e3},
                  {"impact_force", "moat right", 0.0, "N", 0.0, 0.0}};
  EXPECT_EQ(peak_table(result),
            "peak displacement [cm]\n"
            "  base        53.28 +- 0.016    at  4.500 s\n"
            "  floor 1     53.3  +- 0.4      at 14.500 s\n"
            "  floor 2     53.28 +- 0.0004   at 14.500 s\n"
            "  floor 3     53.28             at  4.500 s\n"
            "peak impact force [kN]\n"
            "  moat left   25650 +- 40       at  4.250 s\n"
            "  moat right      0 +- 0        at  0.000 s\n");
}

}  // namespace
}  // namespace moat
