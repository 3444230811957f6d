#include "output/files/summary.hpp"

#include <limits>
#include <nlohmann/json.hpp>

#include "output_testing.hpp"
#include "plan_facts.hpp"

namespace moat {
namespace {

using Json = nlohmann::ordered_json;

class Summary : public testing_output::InFolder {};

CaseResult example() {
  CaseResult result;
  result.title = "Five storeys \"in\" a moat";
  result.provenance = {"moat run a.cpp --gap '20 cm'", "/a.cpp", "def", {{"gap", "20 cm"}}, "1.2.3", "0123",
                       "2026-01-31T12:00:00Z"};
  result.motion = {.name = "record",
                   .peak_acceleration = 3.92266,
                   .peak_velocity = 0.45,
                   .time_step = 0.005,
                   .duration = 28.0,
                   .notes = {"header", "scaled"},
                   .components = {{"a", {"/records/a.AT2", "abc"}, 1.5}, {"b", {}, 2.5}}};
  result.model = {{{"base", 5.0, 1.0, 0.5, 0.01, -0.5}},
                  {{"storey 1", "storey", "Linear", "base", "floor 1", {{"stiffness", 2e9, "N/m"}}},
                   {.name = "gap",
                    .kind = "gap",
                    .law = "Hertz",
                    .first = "base",
                    .second = "floor 1",
                    .parameters = {},
                    .second_other = "floor 2",
                    .second_share = 0.25}}};
  result.buildings = {{"tower", "base", {"floor 1"}, {"bearing"}}};
  result.analysis = {"Newmark", "located", "always", "never", {{"step", 0.005, "s"}, {"max_cuts", 12.0, "1"}}};
  result.clearances = {{"moat left", 0.5, 0.2, 3.5}};
  result.periods = {{"isolated", 2.1}, {"fixed base", 1.0 / 3.0}};
  result.peaks = {{"displacement", "base", 0.1234567, "m", 4.5},
                  {"absolute_acceleration", "floor 5", 12.5, "m/s^2", 12.25},
                  {"displacement", "floor 5", -0.05, "m", 14.5, std::numeric_limits<double>::quiet_NaN(), "left"},
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
  EXPECT_EQ(json["moat_version"], "1.2.3");
  EXPECT_EQ(json["motion"],
            Json::parse(R"({"name": "record", "peak_acceleration": 3.92266, "peak_velocity": 0.45, "time_step": 0.005,
                            "duration": 28.0, "file": "/records/a.AT2", "sha256": "abc", "scale_factor": 1.5,
                            "components": [{"name": "a", "file": "/records/a.AT2", "sha256": "abc",
                                            "scale_factor": 1.5},
                                           {"name": "b", "file": null, "sha256": null, "scale_factor": 2.5}],
                            "notes": ["header", "scaled"],
                            "units": {"peak_acceleration": "m/s^2", "peak_velocity": "m/s", "time_step": "s",
                                      "duration": "s"}})"));
  EXPECT_EQ(json["provenance"],
            Json::parse(R"({"command_line": "moat run a.cpp --gap '20 cm'", "script": "/a.cpp", "script_sha256": "def",
                            "options": {"gap": "20 cm"}, "moat_version": "1.2.3", "git_commit": "0123",
                            "date": "2026-01-31T12:00:00Z"})"));
  EXPECT_EQ(json["model"], Json::parse(R"({"nodes": [{"name": "base", "mass": 5.0, "x": 1.0, "height": 0.5,
                                       "initial_displacement": 0.01, "initial_velocity": -0.5}],
                            "node_units": {"mass": "kg", "x": "m", "height": "m", "initial_displacement": "m",
                                           "initial_velocity": "m/s"},
                            "elements": [{"name": "storey 1", "kind": "storey", "law": "Linear", "first": "base",
                                          "second": "floor 1",
                                          "parameters": {"stiffness": {"value": 2e9, "unit": "N/m"}}},
                                         {"name": "gap", "kind": "gap", "law": "Hertz", "first": "base",
                                          "second": "floor 1", "parameters": {},
                                          "second_point": {"other": "floor 2", "share": 0.25}}],
                            "buildings": [{"name": "tower", "base": "base", "floors": ["floor 1"],
                                           "isolators": ["bearing"]}]})"));
  EXPECT_EQ(json["clearances"], Json::parse(R"([{"where": "moat left", "clearance": 0.5, "clearance_left": 0.2,
                                                 "unit": "m", "time": 3.5, "error": null}])"));
  EXPECT_EQ(json["periods"][1]["name"], "fixed base");
  EXPECT_EQ(json["periods"][1]["unit"], "s");
  EXPECT_EQ(json["periods"][1]["value"].get<double>(), 1.0 / 3.0);
  EXPECT_EQ(json["analysis"], Json::parse(R"({"integrator": "Newmark", "events": "located", "error_bars": "always",
                            "contact_sensitivity": "never", "options": {
                                               "step": {"value": 0.005, "unit": "s"},
                                               "max_cuts": {"value": 12.0, "unit": "1"}}})"));
  EXPECT_EQ(json["assumptions"], Json::parse(R"(["Average acceleration.", "Signs: tension positive."])"));
  ASSERT_EQ(json["peaks"].size(), 4u);
  EXPECT_EQ(json["peaks"][0], Json::parse(R"({"quantity": "displacement", "where": "base", "value": 0.1234567,
                                              "unit": "m", "time": 4.5, "error": null,
                                              "side": ""})"));
  EXPECT_EQ(json["peaks"][2]["value"], -0.05);
  EXPECT_EQ(json["peaks"][2]["side"], "left");
  ASSERT_TRUE(json["impacts"].is_number_integer());
  EXPECT_EQ(json["impacts"], 2);
  EXPECT_EQ(json["impact_units"]["approach_speed"], "m/s");
  ASSERT_EQ(json["impact_table"].size(), 2u);
  EXPECT_EQ(json["impact_table"][0],
            Json::parse(R"({"where": "moat left", "start": 3.25, "duration": 0.125, "approach_speed": 0.5,
                            "largest_indentation": 0.01, "largest_force": 2.5e7, "rebound_ratio": 0.75,
                            "restitution": 0.7, "energy_lost": 1e5})"));
  EXPECT_EQ(json["solver"], Json::parse(R"({"accepted_steps": 11, "rejected_steps": 12, "repeated_steps": 17,
                                            "event_solves": 13,
                                            "events": 14, "passed_changes": 0, "newton_iterations": 15, "factorisations": 16,
                                            "cpu_seconds": 0.5, "longest_step": 0.005})"));
}

TEST_F(Summary, HasPlacesInPlan) {
  CaseResult result = example();
  result.model = testing::plan_facts();
  write_summary_json(result, folder / "summary.json");
  const Json model = Json::parse(testing_output::read_file(folder / "summary.json"))["model"];
  EXPECT_EQ(model["elements"][0]["first_position"], Json::parse("[1.0, 2.0]"));
  EXPECT_EQ(model["elements"][0]["second_position"], Json::parse("[1.5, 2.0]"));
  EXPECT_EQ(model["elements"][0]["direction"], Json::parse("[0.0, 1.0]"));
  EXPECT_FALSE(model["elements"][1].contains("direction"));
  EXPECT_EQ(model["diaphragms"], Json::parse(R"([{"name": "floor", "radius_of_gyration": 2.5,
                                                  "centre_of_mass": [0.5, 0.25],
                                                  "outline": [[0.0, 0.0], [4.0, 0.0], [4.0, 3.0]]}])"));
  EXPECT_EQ(model["corners"], Json::parse(R"([{"element": "contact", "corner": "floor corner 1", "edge": "wall 2",
                                               "position": [4.0, 0.0], "normal": [1.0, 0.0],
                                               "edge_begin": [4.5, -1.0], "edge_end": [4.5, 4.0],
                                               "clearance": 0.5}])"));
  for (const char* name : {"radius_of_gyration", "first_position", "edge_begin"})
    EXPECT_EQ(model["plan_units"][name], "m") << name;
}

TEST_F(Summary, HasTheErrorsOfPeaks) {
  CaseResult result = example();
  for (Peak& peak : result.peaks) peak.error = 0.001 * peak.magnitude();
  result.peaks[1].error = std::numeric_limits<double>::infinity();
  result.error_bars = {.checked = true,
                       .companion = "Finer.",
                       .companion_impacts = 3,
                       .companion_solver = {.accepted_steps = 22, .cpu_seconds = 0.75},
                       .unsettled = true,
                       .reason = "it has 3 impacts instead of 2",
                       .unsettled_peaks = {result.peaks[1]}};
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
  EXPECT_EQ(bars["unsettled"], true);
  EXPECT_EQ(bars["reason"], "it has 3 impacts instead of 2");
  EXPECT_EQ(bars["unsettled_peaks"], Json::parse(R"([{"quantity": "absolute_acceleration", "where": "floor 5"}])"));
}

TEST_F(Summary, SaysWhyThereAreNoErrors) {
  CaseResult result = example();
  result.error_bars.companion = "No error bars: a reason.";
  write_summary_json(result, folder / "summary.json");
  const Json bars = Json::parse(testing_output::read_file(folder / "summary.json"))["error_bars"];
  EXPECT_EQ(bars["checked"], false);
  EXPECT_EQ(bars["companion"], "No error bars: a reason.");
  for (const char* field : {"companion_impacts", "companion_solver", "unsettled"})
    EXPECT_TRUE(bars.at(field).is_null()) << field;
  EXPECT_EQ(bars["unsettled_peaks"], Json::array());
}

TEST_F(Summary, HasTheSensitivityToContacts) {
  CaseResult result = example();
  result.contact_sensitivity = {
      .computed = true,
      .rigid_walls = true,
      .impacts = 2,
      .changes = {{.parameter = "stiffness", .factor = 3.0, .impacts = 3, .contact = {{"moat", "more"}}},
                  {.parameter = "restitution",
                   .difference = -0.1,
                   .restitutions = {0.55},
                   .impacts = 0,
                   .contact = {{"moat", "vanishes"}}},
                  {.parameter = "clearance", .factor = 0.9, .failure = "it failed."}},
      .peaks = {{.quantity = "displacement",
                 .where = "base",
                 .unit = "m",
                 .value = -0.125,
                 .error = 0.5,
                 .changed = {-0.25, 0.5, std::numeric_limits<double>::quiet_NaN()}}},
      .unchanged_laws = {"Mine"}};
  write_summary_json(result, folder / "summary.json");
  EXPECT_EQ(Json::parse(testing_output::read_file(folder / "summary.json"))["contact_sensitivity"],
            Json::parse(R"({"computed": true, "reason": null, "unsettled": false, "rigid_walls": true, "impacts": 2,
                            "changes": [{"parameter": "stiffness", "places": null, "impacts": 3, "factor": 3.0,
                                         "contact": {"moat": "more"}, "failure": null},
                                        {"parameter": "restitution", "places": null, "impacts": 0, "difference": -0.1,
                                         "restitutions": [0.55], "contact": {"moat": "vanishes"}, "failure": null},
                                        {"parameter": "clearance", "places": null, "impacts": 0, "factor": 0.9,
                                         "contact": {}, "failure": "it failed."}],
                            "peaks": [{"quantity": "displacement", "where": "base", "unit": "m", "value": -0.125,
                                       "error": 0.5, "changed": [-0.25, 0.5, null]}],
                            "unchanged_laws": ["Mine"]})"));
  result.clearances.clear();
  write_summary_json(result, folder / "summary.json");
  EXPECT_TRUE(Json::parse(testing_output::read_file(folder / "summary.json")).at("contact_sensitivity").is_null())
      << "without contacts";
}

TEST_F(Summary, WritesNullForWhatIsNotKnown) {
  write_summary_json({}, folder / "summary.json");
  const Json json = Json::parse(testing_output::read_file(folder / "summary.json"));
  for (const char* field : {"command_line", "script", "script_sha256", "git_commit", "date"})
    EXPECT_TRUE(json["provenance"].at(field).is_null()) << field;
  EXPECT_TRUE(json["motion"]["file"].is_null());
  EXPECT_EQ(json["clearances"], Json::array());
  EXPECT_EQ(json["isolators_at_the_end"], Json::array());
  EXPECT_EQ(json["constant_quantities"], Json::array());
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

}  // namespace
}  // namespace moat
