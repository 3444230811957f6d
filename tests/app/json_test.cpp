// --json: standard output for programs.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

class JsonRun : public testing::InTemporaryFolder {
 protected:
  ProgramResult run(const char* program, std::vector<std::string> arguments) {
    arguments.emplace_back("--json");
    return testing::run_program(program, std::move(arguments), folder);
  }
};

TEST_F(JsonRun, StandardOutputIsTheSummaryAlone) {
  const ProgramResult result = run(FIRST_TOUR, {"--end", "4 s", "--frame-interval", "0 s"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  json printed = json::parse(result.output);
  const std::string results = printed.at("results_folder").get<std::string>();
  printed.erase("results_folder");
  EXPECT_EQ(printed, json::parse(text_of(folder / results / "summary.json")));
  // The text for people goes to standard error.
  EXPECT_NE(result.errors.find("peak displacement [cm]"), std::string::npos) << result.errors;
}

TEST_F(JsonRun, QuietLeavesStandardErrorEmpty) {
  const ProgramResult result = run(FIRST_TOUR, {"--end", "0.1 s", "--frame-interval", "0 s", "--quiet"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.errors, "");
  EXPECT_TRUE(json::accept(result.output)) << result.output;
}

TEST_F(JsonRun, WrongInputLeavesStandardOutputEmpty) {
  for (const auto& [arguments, code] :
       {std::pair{std::vector<std::string>{"--frobnicate"}, 2}, {std::vector<std::string>{"--gap", "-1 m"}, 1}}) {
    const ProgramResult result = run(FIRST_TOUR, arguments);
    EXPECT_EQ(result.exit_code, code) << result.errors;
    EXPECT_EQ(result.output, "");
    EXPECT_NE(result.errors, "");
  }
}

TEST_F(JsonRun, HelpStaysOnStandardOutput) {
  const ProgramResult result = run(FIRST_TOUR, {"--help"});
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_NE(result.output.find("--json"), std::string::npos) << result.output;
}

TEST_F(JsonRun, AStudyGivesCountsAndAnswers) {
  const ProgramResult result = run(STUDY_SCRIPT, {"--out", "there"});
  ASSERT_TRUE(json::accept(result.output)) << result.output << result.errors;
  const json printed = json::parse(result.output);
  EXPECT_EQ(printed.at("results_folder"), "there");
  ASSERT_GE(printed.at("studies").size(), 1u);
  for (const json& study : printed.at("studies")) {
    EXPECT_TRUE(std::filesystem::exists(folder / study.at("file").get<std::string>())) << study;
    EXPECT_EQ(study.at("cases").get<int>(), study.at("done").get<int>() + study.at("not_converged").get<int>() +
                                                study.at("failed").get<int>() + study.at("open").get<int>());
  }
  EXPECT_TRUE(printed.at("answers").is_array());
}

TEST_F(JsonRun, APartOfAStudyGivesItsCounts) {
  const ProgramResult result = run(STUDY_SCRIPT, {"--out", "there", "--case", "0"});
  ASSERT_TRUE(json::accept(result.output)) << result.output << result.errors;
  const json study = json::parse(result.output).at("studies").at(0);
  EXPECT_EQ(study.at("done").get<int>() + study.at("failed").get<int>() + study.at("not_converged").get<int>(), 1);
  EXPECT_TRUE(std::filesystem::exists(folder / study.at("file").get<std::string>())) << study;
}

}  // namespace
}  // namespace moat
