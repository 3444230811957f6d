// The outputs of a script: results folder, progress, exit codes.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream{text};
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

class ScriptRun : public testing::InTemporaryFolder {
 protected:
  ProgramResult tour(std::vector<std::string> arguments) {
    return testing::run_program(FIRST_TOUR, std::move(arguments), folder);
  }
  /// Takes longer than the time in which nothing is written to a log.
  ProgramResult slow_run(std::vector<std::string> arguments) {
    ::setenv("MOAT_TEST_PAUSE", "", 1);
    ProgramResult result = testing::run_program(OBSERVER_SCRIPT, std::move(arguments), folder);
    ::unsetenv("MOAT_TEST_PAUSE");
    return result;
  }
  bool exists(const std::string& path) const { return std::filesystem::exists(folder / path); }
};

TEST_F(ScriptRun, LeavesEveryFileOfTheResults) {
  const ProgramResult result = tour({"--end", "4 s"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  for (const char* file : {"summary.json", "histories.csv", "histories.vtt", "impacts.csv", "peaks.csv", "report.html",
                           "charts.svg", "frames.pvd", "frames/frame_000000.vtu"}) {
    EXPECT_TRUE(exists(std::string{"results/01_moat_wall/"} + file)) << file;
    EXPECT_GT(std::filesystem::file_size(folder / "results/01_moat_wall" / file), 0u) << file;
  }
  EXPECT_NE(result.output.find("Results: results/01_moat_wall/"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("Five-storey isolated building inside a moat"), std::string::npos);
  EXPECT_NE(result.output.find("PGA 0.4000 g"), std::string::npos) << result.output;
  for (const char* period : {"fixed base", "isolation, rigid building", "first mode, post-yield bearings"})
    EXPECT_NE(result.output.find(period), std::string::npos) << period;
}

TEST_F(ScriptRun, TakesOptionsOfTheAnalysisUnderThoseOfTheCommandLine) {
  const auto assumptions = [&](std::vector<std::string> arguments, const std::string& out) {
    arguments.insert(arguments.end(), {"--out", out});
    EXPECT_EQ(testing::run_program(OBSERVER_SCRIPT, std::move(arguments), folder).exit_code, 0);
    return json::parse(text_of(folder / out / "summary.json")).at("assumptions").dump();
  };
  setenv("MOAT_TEST_INTEGRATOR", "1", 1);
  const std::string given = assumptions({}, "a"), same = assumptions({"--integrator", "generalized-alpha"}, "b"),
                    other = assumptions({"--integrator", "newmark"}, "c");
  unsetenv("MOAT_TEST_INTEGRATOR");
  EXPECT_NE(given.find("0.7"), std::string::npos) << given;
  EXPECT_EQ(given, same);
  EXPECT_EQ(other.find("0.7"), std::string::npos) << other;
}

TEST_F(ScriptRun, RefusesANullObserver) {
  setenv("MOAT_TEST_NULL_OBSERVER", "1", 1);
  const ProgramResult result = testing::run_program(OBSERVER_SCRIPT, {}, folder);
  unsetenv("MOAT_TEST_NULL_OBSERVER");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors,
            "moat: error: Script::run: an observer is null. Give the addresses of observers, such as {&drift}.\n");
}

TEST_F(ScriptRun, SummaryHasAllOptionsOfTheAnalysis) {
  ASSERT_EQ(testing::run_program(OBSERVER_SCRIPT, {"--tolerance", "1e-4", "--out", "out"}, folder).exit_code, 0);
  const json analysis = json::parse(text_of(folder / "out/summary.json")).at("analysis");
  EXPECT_EQ(analysis.at("options").at("tolerance"), (json{{"value", 1e-4}, {"unit", "1"}}));
  EXPECT_EQ(analysis.at("options").at("max_cuts").at("value"), 12.0);
  EXPECT_EQ(analysis.at("events"), "located");
}

TEST_F(ScriptRun, ReportsAnErrorBeforeTheScriptExists) {
  const ProgramResult result = testing::run_program(EARLY_ERROR_SCRIPT, {}, folder);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors,
            "moat: error: Node \"base\": mass = -1 kg is not allowed; it must be > 0 kg and finite. "
            "Every degree of freedom needs mass.\n");
}

TEST_F(ScriptRun, SummaryHasItsPeaksAndTheirSchema) {
  ASSERT_EQ(tour({"--end", "6 s", "--frame-interval", "0 s", "--out", "out"}).exit_code, 0);
  const json summary = json::parse(text_of(folder / "out/summary.json"));

  std::map<std::string, std::set<std::string>> places;
  for (const json& peak : summary.at("peaks")) {
    ASSERT_EQ(peak.size(), 7u) << peak;
    const std::string quantity = peak.at("quantity").get<std::string>();
    EXPECT_TRUE(places[quantity].insert(peak.at("where").get<std::string>()).second) << "listed twice: " << peak;
    const double value = peak.at("value").get<double>();
    EXPECT_NE(value, 0.0) << peak;
    if (quantity == "displacement") {
      EXPECT_EQ(peak.at("side"), value > 0.0 ? "right" : "left") << peak;
    }
    EXPECT_GE(peak.at("time").get<double>(), 0.0) << peak;
    EXPECT_LE(peak.at("time").get<double>(), 6.0) << peak;
    EXPECT_GT(peak.at("error").get<double>(), 0.0) << peak;
    EXPECT_LT(peak.at("error").get<double>(), 0.01 * std::abs(value)) << peak;
  }
  const std::set<std::string> nodes{"base", "floor 1", "floor 2", "floor 3", "floor 4", "floor 5"};
  const std::set<std::string> storeys{"storey 1", "storey 2", "storey 3", "storey 4", "storey 5"};
  EXPECT_EQ(places["displacement"], nodes);
  EXPECT_EQ(places["absolute_acceleration"], nodes);
  EXPECT_EQ(places["drift"], storeys);
  EXPECT_EQ(places["storey_shear"], storeys);
  EXPECT_EQ(places["isolator_force"], std::set<std::string>{"bearings"});
  EXPECT_EQ(places["impact_force"], std::set<std::string>{"moat"});
  EXPECT_EQ(places["total_base_shear"], std::set<std::string>{"base"});
  EXPECT_EQ(places["sum_of_floor_inertia_maxima"], std::set<std::string>{"base"});

  ASSERT_TRUE(summary.at("impacts").is_number_integer());
  const int impacts = summary.at("impacts").get<int>();
  EXPECT_GT(impacts, 0);
  EXPECT_EQ(summary.at("impact_table").size(), static_cast<std::size_t>(impacts));
  // A header and a line per impact.
  EXPECT_EQ(lines_of(text_of(folder / "out/impacts.csv")).size(), static_cast<std::size_t>(impacts) + 1);
  EXPECT_NEAR(summary.at("motion").at("peak_acceleration").get<double>(), 0.4 * 9.80665, 1e-9);
}

TEST_F(ScriptRun, AForcedRunThatIsStoppedLeavesTheOldResults) {
  const std::vector<std::string> common{"--frame-interval", "0 s", "--quiet", "--out", "out"};
  std::vector<std::string> arguments = common;
  arguments.insert(arguments.end(), {"--end", "0.1 s"});
  ASSERT_EQ(tour(arguments).exit_code, 0);
  const std::string old = text_of(folder / "out/summary.json");
  // The folder beside cannot be made, as if the disk were full.
  std::ofstream{folder / "out.new"} << "in the way";
  arguments.push_back("--force");
  EXPECT_EQ(tour(arguments).exit_code, 1);
  EXPECT_EQ(text_of(folder / "out/summary.json"), old);
  std::filesystem::remove(folder / "out.new");
  EXPECT_EQ(tour(arguments).exit_code, 0);
  EXPECT_NE(text_of(folder / "out/summary.json"), old);
  EXPECT_FALSE(exists("out.new"));
}

TEST_F(ScriptRun, ObserversOfTheScriptAreInHistoriesAndReport) {
  const ProgramResult result = testing::run_program(OBSERVER_SCRIPT, {"--out", "out"}, folder);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_NE(result.output.find("peak momentum [kg m/s]\n  body"), std::string::npos) << result.output;
  const json summary = json::parse(text_of(folder / "out/summary.json"));
  EXPECT_NE(result.output.find(std::to_string(summary.at("solver").at("accepted_steps").get<int>()) + " steps\n"),
            std::string::npos)
      << result.output;
  const std::string heading = lines_of(text_of(folder / "out/histories.csv")).front();
  EXPECT_TRUE(heading.ends_with(",momentum [kg m/s] body")) << heading;
  // m = 2 kg, w^2 = 40 / s^2: the body swings with m a / w = 0.316 kg m/s.
  const auto peak =
      std::ranges::find_if(summary.at("peaks"), [](const json& each) { return each.at("quantity") == "momentum"; });
  ASSERT_NE(peak, summary.at("peaks").end());
  EXPECT_NEAR(std::abs(peak->at("value").get<double>()), 2.0 / std::sqrt(40.0), 1e-3);
  EXPECT_NE(text_of(folder / "out/report.html").find("momentum [kg m/s]"), std::string::npos);
}

TEST_F(ScriptRun, DesignSheetsAreResults) {
  setenv("MOAT_TEST_SHEET", "1", 1);
  for (int i = 0; i < 2; ++i) {
    const ProgramResult result = testing::run_program(OBSERVER_SCRIPT, {"--out", "out", "--force"}, folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(text_of(folder / "out/design_sheet.html").find("<h2>body: a code</h2>"), std::string::npos);
  }
  unsetenv("MOAT_TEST_SHEET");
  // Overwritten results leave no sheet of old ones.
  EXPECT_EQ(testing::run_program(OBSERVER_SCRIPT, {"--out", "out", "--force"}, folder).exit_code, 0);
  EXPECT_FALSE(exists("out/design_sheet.html"));
}

TEST_F(ScriptRun, ProgressIsALineForEveryTenPercentWithoutATerminal) {
  std::vector<std::string> expected;
  const auto expect_lines_of = [&](const char* run) {
    for (int percent = 10; percent <= 100; percent += 10) {
      char line[40];
      std::snprintf(line, sizeof line, "moat: %s%3d %% of 2 s", run, percent);
      expected.push_back(line);
    }
  };
  expect_lines_of("");
  EXPECT_EQ(lines_of(slow_run({"--end", "2 s"}).errors), expected);
  expect_lines_of("check: ");
  EXPECT_EQ(lines_of(slow_run({"--end", "2 s", "--check"}).errors), expected);
}

TEST_F(ScriptRun, ErrorBarsOfALongRunAreMadeOnlyIfAsked) {
  const std::vector<std::string> common{"--end", "6 s", "--step", "0.1 ms", "--frame-interval", "0 s"};
  const ProgramResult plain = tour(common);
  EXPECT_NE(plain.output.find("No error bars by default for a run of this size"), std::string::npos) << plain.output;
  EXPECT_EQ(plain.output.find("+-"), std::string::npos) << plain.output;
  const json without = json::parse(text_of(folder / "results/01_moat_wall/summary.json"));
  EXPECT_EQ(without.at("error_bars").at("checked"), false);
  EXPECT_TRUE(without.at("peaks").at(0).at("error").is_null());

  std::vector<std::string> checked = common;
  checked.insert(checked.end(), {"--check", "--out", "checked"});
  const ProgramResult asked = tour(checked);
  EXPECT_NE(asked.output.find("cm], +- numerical error\n  base "), std::string::npos);
  EXPECT_NE(asked.output.find(" +- "), std::string::npos) << asked.output;
  const json with = json::parse(text_of(folder / "checked/summary.json"));
  EXPECT_EQ(with.at("error_bars").at("checked"), true);
  EXPECT_EQ(with.at("error_bars").at("companion"), "The same case with a fixed step of 5e-05 s.");
  EXPECT_EQ(with.at("error_bars").at("companion_impacts"), with.at("impacts"));
  for (std::size_t i = 0; i < with.at("peaks").size(); ++i)
    EXPECT_EQ(with.at("peaks").at(i).at("value"), without.at("peaks").at(i).at("value")) << i;
}

TEST_F(ScriptRun, StatesHowPeaksMoveWithContactsUnlessThatTakesLongOrIsNotWanted) {
  const auto run = [&](std::vector<std::string> options, const std::string& out) {
    for (const char* common : {"--end", "6 s", "--frame-interval", "0 s", "--out"}) options.emplace_back(common);
    options.push_back(out);
    return tour(options);
  };
  const auto sensitivity = [&](const std::string& out) {
    return json::parse(text_of(folder / out / "summary.json")).at("contact_sensitivity");
  };
  const ProgramResult plain = run({}, "plain");
  EXPECT_NE(plain.output.find("  if contact differs"), std::string::npos) << plain.output;
  EXPECT_NE(plain.output.find("Rigid walls: a wall that gives way changes this more than k."), std::string::npos);
  EXPECT_EQ(sensitivity("plain").at("computed"), true);
  EXPECT_EQ(sensitivity("plain").at("changes").size(), 6u);

  const ProgramResult without = run({"--no-sensitivity"}, "without");
  EXPECT_EQ(without.output.find("if contact differs"), std::string::npos) << without.output;
  EXPECT_EQ(without.output.find("Sensitivity"), std::string::npos) << without.output;
  EXPECT_EQ(sensitivity("without").at("reason"), "It was not wanted.");

  const ProgramResult fine = run({"--step", "0.1 ms"}, "fine");
  EXPECT_NE(fine.output.find("Sensitivity to contact parameters: not computed, at most "), std::string::npos)
      << fine.output;
  EXPECT_EQ(sensitivity("fine").at("computed"), false);

  const ProgramResult both = run({"--sensitivity", "--no-sensitivity"}, "both");
  EXPECT_EQ(both.exit_code, 1);
  EXPECT_NE(both.errors.find("both --sensitivity and --no-sensitivity are given."), std::string::npos) << both.errors;
}

TEST_F(ScriptRun, QuietSaysNothing) {
  const ProgramResult result = tour({"--end", "0.5 s", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.output, "");
  EXPECT_EQ(result.errors, "");
  EXPECT_TRUE(exists("results/01_moat_wall/summary.json"));
}

TEST_F(ScriptRun, AboutFourHundredFramesOfALongMotion) {
  ASSERT_EQ(tour({"--end", "100 s", "--quiet", "--out", "out"}).exit_code, 0);
  const std::string list = text_of(folder / "out/frames.pvd");
  EXPECT_NE(list.find("frame_000400.vtu"), std::string::npos);
  EXPECT_EQ(list.find("frame_000401.vtu"), std::string::npos);
  EXPECT_NE(list.find("timestep=\"0.25\""), std::string::npos) << list;
}

TEST_F(ScriptRun, FramesThatCannotBeWrittenAreAnErrorAndTheOtherResultsStay) {
  ASSERT_EQ(tour({"--end", "0.5 s", "--quiet"}).exit_code, 0);
  const testing::RunningProgram run{FIRST_TOUR, {"--step", "1e-4 s", "--frame-interval", "1 ms", "--force"}, folder};
  const std::filesystem::path frames = folder / "results/01_moat_wall.new/frames";
  while (!std::filesystem::exists(frames / "frame_000003.vtu"))
    std::this_thread::sleep_for(std::chrono::milliseconds{1});
  std::filesystem::rename(frames, folder / "gone");
  const ProgramResult result = run.wait();
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("moat: error: results/01_moat_wall.new/frames/frame_"), std::string::npos)
      << result.errors;
  EXPECT_NE(result.errors.find("The old results in results/01_moat_wall stay"), std::string::npos) << result.errors;
  const json summary = json::parse(text_of(folder / "results/01_moat_wall_2/summary.json"));
  const std::string warning = summary.at("warnings").at(0).get<std::string>();
  EXPECT_TRUE(warning.starts_with("The frames are incomplete: ")) << warning;
  EXPECT_NE(text_of(folder / "results/01_moat_wall_2/report.html").find("The frames are incomplete: "),
            std::string::npos);
}

TEST_F(ScriptRun, BadParametersOfTheModelAreOneMessage) {
  const ProgramResult result = tour({"--gap", "-5 cm"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_EQ(result.errors,
            "moat: error: Gap \"moat left\": clearance = -0.05 m is not allowed; it must be >= 0 m and finite. "
            "Give the free distance at rest, 0 m for wall to wall; a preload is an initial_displacement.\n");
  EXPECT_FALSE(exists("results"));
}

TEST_F(ScriptRun, BadOptionsOfTheAnalysisLeaveNothingBehind) {
  for (const auto& [option, value, words] : {std::array{"--step", "-1 ms", "is not allowed; it must be >= 0 s"},
                                             {"--end", "-1 s", "is not allowed; it must be >= 0 s"},
                                             {"--frame-interval", "-1 s", "is not allowed; it must be >= 0 s"},
                                             {"--step", "1e-30 s", "number of steps (end / step) = "},
                                             {"--end", "1e9 s", "number of steps (end / step) = "}}) {
    const ProgramResult result = tour({option, value});
    EXPECT_EQ(result.exit_code, 1) << option << value;
    EXPECT_TRUE(result.errors.starts_with("moat: error: ")) << result.errors;
    EXPECT_NE(result.errors.find(words), std::string::npos) << result.errors;
    EXPECT_FALSE(exists("results")) << option << value;
  }
}

TEST_F(ScriptRun, RefusesARecordItCannotUnderstand) {
  std::ofstream{folder / "synthetic.txt"} << "0 0.1\n0.02 0.2\n0.04 -0.1\n";
  std::ofstream{folder / "huge.AT2"} << "A\nB\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 2, DT= .02 SEC\n0 1e308\n";
  const auto refusal = [&](std::vector<std::string> arguments) {
    const ProgramResult result = tour(std::move(arguments));
    EXPECT_EQ(result.exit_code, 1);
    return result.errors;
  };
  EXPECT_NE(refusal({"--record", "synthetic.txt"}).find("--record-unit g"), std::string::npos);
  EXPECT_EQ(refusal({"--record", "huge.AT2"}).find("--record-unit"), std::string::npos) << "a unit would not help";
  EXPECT_NE(refusal({"--record", "missing.AT2"}).find("missing.AT2"), std::string::npos);
  std::ofstream{folder / "pair.txt"} << "0.1 0.2\n-0.1 0.1\n";
  EXPECT_NE(refusal({"--record", "pair.txt", "--record-unit", "gal"}).find("Name them: --record-columns x,y"),
            std::string::npos);
  EXPECT_EQ(refusal({"--record-step", "1s"}), "moat: error: --record-step: give it together with --record FILE.\n");
  EXPECT_EQ(refusal({"--record-unit", "g"}), "moat: error: --record-unit: give it together with --record FILE.\n");
  EXPECT_NE(refusal({"--record", "synthetic.txt", "--record-unit", "cm/s"}).find("it must be in m/s^2"),
            std::string::npos);
  EXPECT_FALSE(exists("results"));
}

TEST_F(ScriptRun, AStepThatDoesNotConvergeExitsWithThreeAndKeepsResults) {
  const ProgramResult result = testing::run_program(FAILING_SCRIPT, {"--out", "out"}, folder);
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_NE(result.errors.find("moat: error: The step from t = "), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("worst at \"body\""), std::string::npos) << result.errors;
  // The results up to the failure are there: the body moves at 10 cm/s and breaks at 5 cm.
  const json summary = json::parse(text_of(folder / "out/summary.json"));
  EXPECT_NEAR(summary.at("peaks").at(0).at("value").get<double>(), 0.05, 1e-3);
  // And it says that it is not the whole run.
  ASSERT_EQ(summary.at("warnings").size(), 1u);
  const std::string warning = summary.at("warnings").at(0).get<std::string>();
  EXPECT_TRUE(warning.starts_with("The analysis stopped at ")) << warning;
  EXPECT_NE(warning.find("did not converge"), std::string::npos) << warning;
  EXPECT_NE(text_of(folder / "out/report.html").find("The analysis stopped at "), std::string::npos);
  EXPECT_EQ(result.errors.find("moat: warning: "), std::string::npos) << "the error says it once";
  for (const char* file : {"histories.csv", "impacts.csv", "report.html", "frames.pvd"})
    EXPECT_TRUE(exists(std::string{"out/"} + file)) << file;
  EXPECT_GT(lines_of(text_of(folder / "out/histories.csv")).size(), 50u);
}

TEST_F(ScriptRun, AForcedRunThatDoesNotConvergeLeavesTheOldResults) {
  ASSERT_EQ(testing::run_program(FAILING_SCRIPT, {"--out", "out", "--end", "0.1 s"}, folder).exit_code, 0);
  const std::string old = text_of(folder / "out/summary.json");
  const ProgramResult result =
      testing::run_program(FAILING_SCRIPT, {"--out", "out", "--force", "--step", "10 ms", "--json"}, folder);
  EXPECT_EQ(result.exit_code, 3) << result.errors;
  EXPECT_EQ(text_of(folder / "out/summary.json"), old);
  EXPECT_NE(text_of(folder / "out_2/summary.json").find("The analysis stopped at "), std::string::npos);
  EXPECT_EQ(json::parse(result.output).at("results_folder"), "out_2");
  EXPECT_NE(result.errors.find("The old results in out stay; those of this run are in out_2.\n"), std::string::npos)
      << result.errors;
  EXPECT_FALSE(exists("out.new"));
}

}  // namespace
}  // namespace moat
