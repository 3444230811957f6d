// Names that a script may give its options.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/script/script.hpp"
#include "base/units.hpp"
#include "in_folder.hpp"
#include "message_of.hpp"
#include "motions/near_fault_pulse.hpp"

namespace moat {
namespace {

using testing::message_of;
using units::m;

class OptionNames : public ::testing::Test {
 protected:
  std::string program = "script";
  std::vector<char*> arguments{program.data(), nullptr};
  Script script{1, arguments.data(), "names"};
};

TEST_F(OptionNames, AreUsedOnce) {
  script.length("gap", 1 * m, "");
  const std::string message = message_of([&] { script.number("gap", 1.0, ""); });
  EXPECT_TRUE(message.starts_with("--gap: there is an option of this name. Name each once; ")) << message;
  EXPECT_NO_THROW(script.number("gap_2", 1.0, ""));
}

TEST_F(OptionNames, OfTheScriptItselfAreTaken) {
  EXPECT_THROW(script.text("help", "", ""), InputError);
  EXPECT_EQ(script.text("wall", "built", "wall", {"built", "rigid"}), "built");
  EXPECT_EQ(message_of([&] {
              script.text("face", "Built", "wall", {"built", "rigid"});
            }),
            "--face: \"Built\" is not one of built, rigid.");
  script.motion(near_fault_pulse());
  EXPECT_THROW(script.text("record", "", ""), InputError);
  script.number("quiet", 1.0, "");
  Model model;
  add(model, Node{.name = "body", .mass = 1 * units::kg});
  const std::string message = message_of([&] { script.run(model, near_fault_pulse()); });
  EXPECT_TRUE(message.starts_with("--quiet: there is an option of this name.")) << message;
}

TEST(RecordOptions, OfATableNeedARecord) {
  const PlanMotion preset{near_fault_pulse(), near_fault_pulse(), {}};
  for (const std::vector<std::string>& words : std::vector<std::vector<std::string>>{
           {"script", "--records-table", "records.csv"},
           {"script", "--record", "a.AT2", "--record-2", "b.AT2", "--records-table", "records.csv"}}) {
    std::vector<std::string> line = words;
    std::vector<char*> arguments;
    for (std::string& word : line) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    Script script{static_cast<int>(line.size()), arguments.data(), "records"};
    EXPECT_EQ(message_of([&] { (void)script.plan_motion(preset); }),
              "--records-table: give it together with --record FILE or FOLDER, and without --record-2.");
  }
}

using RecordTable = testing::InFolder;

TEST_F(RecordTable, IsLookedForWhereTheProgramRuns) {
  std::filesystem::create_directory(folder / "records");
  for (const char* name : {"A000.AT2", "A090.AT2"})
    std::ofstream{folder / "records" / name} << "PEER NGA STRONG MOTION DATABASE RECORD\nsynthetic\nACCELERATION TIME "
                                                "SERIES IN UNITS OF G\nNPTS= 4, DT= .1 SEC\n 0.0 0.1 -0.2 0.0\n";
  std::ofstream{folder / "table.csv"} << "file,sign\nA000.AT2,-1\nA090.AT2,-1\n";
  std::vector<std::string> line{"script", "--record", (folder / "records").string(), "--records-table",
                                std::filesystem::relative(folder / "table.csv").string()};
  std::vector<char*> arguments;
  for (std::string& word : line) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  Script script{static_cast<int>(line.size()), arguments.data(), "records"};
  const PlanMotion motion = script.plan_motion({near_fault_pulse(), near_fault_pulse(), {}});
  EXPECT_NEAR(motion.first.samples()[2], 0.2 * 9.80665, 1e-12);
  EXPECT_NEAR(motion.second.samples()[2], 0.2 * 9.80665, 1e-12);
}

TEST_F(OptionNames, AreLettersDigitsDashesAndUnderscores) {
  for (const char* name : {"", "-gap", "two words", "a=b", "gap,g"})
    EXPECT_EQ(message_of([&] { script.text(name, "", ""); }),
              std::string{"Script: \""} + name + "\" cannot be the name of an option. Use letters, digits, - and _.");
}

}  // namespace
}  // namespace moat
