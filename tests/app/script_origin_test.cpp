// The record of the origin in a results folder.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "app/script/script_origin.hpp"
#include "app/script/script_study_options.hpp"
#include "base/sha256.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;
using testing::text_of;

class ScriptOrigin : public testing::InTemporaryFolder {
 protected:
  ScriptOrigin() { unsetenv("MOAT_SCRIPT"); }
  ~ScriptOrigin() override { unsetenv("MOAT_SCRIPT"); }

  json summary_of(std::vector<std::string> arguments, const std::string& out) {
    arguments.insert(arguments.end(), {"--out", out, "--end", "1 s", "--frame-interval", "0 s"});
    const ProgramResult result = testing::run_program(FIRST_TOUR, arguments, folder);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return json::parse(text_of(folder / out / "summary.json"));
  }
};

TEST_F(ScriptOrigin, TwoRunsThatDifferInAnOptionDifferInTheirSummary) {
  const json first = summary_of({"--gap", "10 cm"}, "a"), second = summary_of({"--gap", "20 cm"}, "b");
  EXPECT_EQ(first.at("provenance").at("options").at("gap"), "10 cm");
  EXPECT_EQ(second.at("provenance").at("options").at("gap"), "20 cm");
  EXPECT_EQ(second.at("provenance").at("options").at("step"), "0 s") << "also those left at their defaults";
  EXPECT_NE(first.at("provenance").at("command_line"), second.at("provenance").at("command_line"));
  EXPECT_NE(first.at("model"), second.at("model"));
  EXPECT_NEAR(first.at("clearances").at(0).at("clearance").get<double>(), 0.1, 1e-15);
  EXPECT_NEAR(second.at("clearances").at(0).at("clearance").get<double>(), 0.2, 1e-15);
}

TEST_F(ScriptOrigin, WithoutTheLauncherItIsTheProgram) {
  const json provenance = summary_of({"--gap", "12 cm", "--quiet"}, "a").at("provenance");
  EXPECT_EQ(provenance.at("script"), std::filesystem::canonical(FIRST_TOUR).string());
  EXPECT_EQ(provenance.at("script_sha256"), sha256_of(text_of(FIRST_TOUR)));
  EXPECT_EQ(provenance.at("command_line"), std::filesystem::canonical(FIRST_TOUR).string() +
                                               " --gap '12 cm' --quiet --out a --end '1 s' --frame-interval '0 s'");
  EXPECT_EQ(provenance.at("options").at("quiet"), "yes");
}

TEST_F(ScriptOrigin, TheLauncherNamesTheScript) {
  const std::filesystem::path script = folder / "my tower's.cpp";
  std::ofstream{script} << "int main() {}\n";
  setenv("MOAT_SCRIPT", script.c_str(), 1);
  const json provenance = summary_of({}, "a").at("provenance");
  EXPECT_EQ(provenance.at("script"), script.string());
  EXPECT_EQ(provenance.at("script_sha256"), sha256_of("int main() {}\n"));
  EXPECT_EQ(provenance.at("command_line"),
            "moat run '" + folder.string() + "/my tower'\\''s.cpp' --out a --end '1 s' --frame-interval '0 s'");
}

TEST_F(ScriptOrigin, TheRecordIsKnownByPathHashAndScale) {
  std::ofstream{folder / "record.txt"} << "0 0.1\n0.02 0.2\n0.04 -0.4\n0.06 0.1\n";
  const json motion = summary_of({"--record", "record.txt", "--record-unit", "g", "--pga", "0.2 g"}, "a").at("motion");
  EXPECT_EQ(motion.at("file"), (folder / "record.txt").string());
  EXPECT_EQ(motion.at("sha256"), sha256_of(text_of(folder / "record.txt")));
  EXPECT_NEAR(motion.at("scale_factor").get<double>(), 0.5, 1e-15);
  EXPECT_EQ(motion.at("notes").back(), "accelerations multiplied by 0.5");
  EXPECT_NEAR(motion.at("duration").get<double>(), 0.06, 1e-9);
}

TEST_F(ScriptOrigin, BothRecordsInPlanAreKnownByPathHashAndScale) {
  std::ofstream{folder / "first.txt"} << "0 0.1\n0.02 0.2\n0.04 -0.4\n0.06 0.1\n";
  std::ofstream{folder / "second.txt"} << "0 0.1\n0.02 -0.3\n0.04 0.1\n0.06 0\n";
  const auto tour = std::filesystem::path{FIRST_TOUR}.replace_filename("05_plan");
  const ProgramResult result =
      testing::run_program(tour,
                           {"--record", "first.txt", "--record-2", "second.txt", "--record-unit", "g", "--pga", "0.2 g",
                            "--frame-interval", "0 s", "--out", "a"},
                           folder);
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json summary = json::parse(text_of(folder / "a/summary.json")), motion = summary.at("motion");
  ASSERT_EQ(motion.at("components").size(), 2u);
  const std::string report = text_of(folder / "a/report.html");
  for (const int i : {0, 1}) {
    const json& component = motion.at("components").at(i);
    const auto file = folder / (i == 0 ? "first.txt" : "second.txt");
    EXPECT_EQ(component.at("file"), file.string());
    EXPECT_EQ(component.at("sha256"), sha256_of(text_of(file)));
    EXPECT_NEAR(component.at("scale_factor").get<double>(), 0.5, 1e-15);
    EXPECT_NE(report.find(component.at("sha256").get<std::string>()), std::string::npos);
  }
  EXPECT_EQ(motion.at("file"), motion.at("components").at(0).at("file"));
  EXPECT_NEAR(motion.at("scale_factor").get<double>(), 0.5, 1e-15);
}

// Runs have options of these names on which nothing depends; those of a script with a study are its own.
TEST(IdentityOfScript, HasTheOwnOptionsOfAStudy) {
  std::string program = "script";
  std::vector<char*> arguments{program.data(), nullptr};
  CommandLine line{1, arguments.data(), "study"};
  for (const char* name : {"force", "checkpoint", "resume", "threads"}) line.look_up(name, "7 N", "", "TEXT");
  const StudyIdentity identity = identity_of_script(line, {}, ScriptStudyOptions::without_influence);
  for (const char* own : {"option --force", "option --checkpoint", "option --resume"})
    EXPECT_EQ(identity.count(own), 1u) << own;
  EXPECT_EQ(identity.count("option --threads"), 0u);
}

TEST_F(ScriptOrigin, ANumberIsNoFolderOfItsName) {
  std::filesystem::create_directory(folder / "400");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  std::string program = "script";
  std::vector<char*> arguments{program.data(), nullptr};
  CommandLine line{1, arguments.data(), "study"};
  line.look_up("cases", "400", "", "INTEGER");
  line.look_up("records", "./400", "", "TEXT");
  const StudyIdentity identity = identity_of_script(line, {}, {});
  std::filesystem::current_path(before);
  EXPECT_EQ(identity.at("option --cases"), "400");
  EXPECT_EQ(identity.at("option --records"), (std::filesystem::canonical(folder) / "400").string());
}

}  // namespace
}  // namespace moat
