// The command line of a script: accepted options, refused options, and exit codes.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "analyses/integrators/integrators.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

using testing::ProgramResult;

class ScriptOptions : public testing::InTemporaryFolder {
 protected:
  ProgramResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--frame-interval", "0 s"});
    return testing::run_program(OPTION_SCRIPT, std::move(arguments), folder);
  }
  // The value that the script printed for one of its options.
  std::string value(const std::string& name, std::vector<std::string> arguments) {
    const ProgramResult result = run(std::move(arguments));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    std::istringstream lines{result.output};
    for (std::string line; std::getline(lines, line);)
      if (line.starts_with(name + " ")) return line.substr(name.size() + 1);
    return "not printed";
  }
  double number(const std::string& name, std::vector<std::string> arguments) {
    return std::atof(value(name, std::move(arguments)).c_str());
  }
  void expect_refusal(std::vector<std::string> arguments, int exit_code, const std::string& message) {
    const ProgramResult result = run(std::move(arguments));
    EXPECT_EQ(result.exit_code, exit_code) << result.errors;
    EXPECT_EQ(result.errors, message);
    EXPECT_FALSE(std::filesystem::exists(folder / "results")) << "nothing may be left behind";
  }
};

TEST_F(ScriptOptions, DefaultsAreUsedWithoutArguments) {
  EXPECT_EQ(number("length", {}), 0.1);
  EXPECT_EQ(number("acceleration", {}), 0.5 * 9.80665);
  EXPECT_EQ(number("hertz", {}), 8.0);
  EXPECT_EQ(value("integer", {}), "5");
  EXPECT_EQ(value("text", {}), "none");
}

TEST_F(ScriptOptions, EveryKindIsRead) {
  const std::vector<std::string> arguments{
      "--length", "12 cm",     "--time",         "3ms",  "--mass",      "2t",       "--push",  "1 MN",
      "--speed",  "36 km/min", "--acceleration", "0.4g", "--stiffness", "1 MN/cm",  "--hertz", "2.95e9 N/m^1.5",
      "--number", "0.5",       "--integer",      "7",    "--text",      "some text"};
  for (const auto& [name, expected] : {std::pair{"length", 0.12},
                                       {"time", 0.003},
                                       {"mass", 2000.0},
                                       {"push", 1e6},
                                       {"speed", 600.0},
                                       {"acceleration", 0.4 * 9.80665},
                                       {"stiffness", 1e8},
                                       {"hertz", 2.95e9},
                                       {"number", 0.5},
                                       {"integer", 7.0}})
    EXPECT_DOUBLE_EQ(number(name, arguments), expected) << name;
  EXPECT_EQ(value("text", arguments), "some text");
}

TEST_F(ScriptOptions, AnEqualSignWorksToo) {
  EXPECT_EQ(number("length", {"--length=12 cm"}), 0.12);
  EXPECT_EQ(number("length", {"--length=12cm"}), 0.12);
  EXPECT_EQ(value("text", {"--text=a=b"}), "a=b");
}

TEST_F(ScriptOptions, NegativeValuesAreValues) {
  EXPECT_EQ(number("length", {"--length", "-12 cm"}), -0.12);
  EXPECT_EQ(number("length", {"--length=-12 cm"}), -0.12);
  EXPECT_EQ(number("length", {"--length", "-.5m"}), -0.5);
  EXPECT_EQ(number("number", {"--number", "-0.5"}), -0.5);
  EXPECT_EQ(number("number", {"--number", "-1e-3"}), -1e-3);
  EXPECT_EQ(value("integer", {"--integer", "-3"}), "-3");
  EXPECT_EQ(value("text", {"--text", "-dash"}), "-dash");
}

TEST_F(ScriptOptions, RefusesAValueWithoutOrWithAWrongUnit) {
  expect_refusal({"--length", "12"}, 1, "moat: error: --length: \"12\" has no unit. Write \"12 cm\" or \"12 m\".\n");
  expect_refusal({"--length=12"}, 1, "moat: error: --length: \"12\" has no unit. Write \"12 cm\" or \"12 m\".\n");
  expect_refusal({"--length", "12 kg"}, 1,
                 "moat: error: --length: \"12 kg\" is in kg, but it must be in m or multiples of it.\n");
  expect_refusal({"--number", "5 cm"}, 1,
                 "moat: error: --number: \"5 cm\" has a unit, but it must be a plain number.\n");
  expect_refusal({"--number", "5%"}, 1,
                 "moat: error: --number: \"5%\" is in percent. Write it as a plain number: 0.05.\n");
  for (const char* text : {"2.5", "two", "3 ", "99999999999"})
    expect_refusal({"--integer", text}, 1,
                   "moat: error: --integer: \"" + std::string{text} +
                       "\" is not a whole number. Write digits alone, 5 for example.\n");
}

TEST_F(ScriptOptions, TheIntegratorIsChosenByName) {
  for (const auto& [name, exact] : {std::pair{"newmark", false}, std::pair{"exact-between-events", true}}) {
    ASSERT_EQ(run({"--integrator", name, "--out", name}).exit_code, 0) << name;
    std::ifstream report{std::filesystem::path{folder} / name / "report.html"};
    const std::string text{std::istreambuf_iterator<char>{report}, {}};
    EXPECT_NE(text.find("Newmark's method"), std::string::npos) << name;
    EXPECT_EQ(text.find("Exact steps while no gap is closed") != std::string::npos, exact) << name;
  }
  expect_refusal({"--integrator", "euler"}, 1,
                 "moat: error: --integrator: \"euler\" is not known. Give one of: " + integrator_names() + ".\n");
}

TEST_F(ScriptOptions, RefusesWhatItDoesNotKnow) {
  const std::string script = std::filesystem::path{OPTION_SCRIPT}.stem(), no_option = script + " has no option ";
  for (const auto& [argument, text] :
       {std::pair<std::string, std::string>{"--lenght", no_option + "--lenght. Did you mean --length?"},
        {"--lenght=12 cm", no_option + "--lenght. Did you mean --length?"},
        {"--leng", no_option + "--leng. Did you mean --length?"},
        {"-length", no_option + "-length. Did you mean --length?"},
        {"--colour", no_option + "--colour."},
        {"-x", no_option + "-x."},
        {"cm",
         "\"cm\" belongs to no option. A value with a blank stands in quotes: "
         "\"12 cm\"."}})
    expect_refusal({argument}, 2, "moat: error: " + text + "\nmoat: --help lists all options.\n");
  // "red" is the value of the unknown option.
  expect_refusal({"--colour", "red"}, 2, "moat: error: " + no_option + "--colour.\nmoat: --help lists all options.\n");
  expect_refusal({"--colour=red", "blue"}, 2,
                 "moat: error: " + no_option +
                     "--colour.\nmoat: error: \"blue\" belongs to no option. A value with a "
                     "blank stands in quotes: \"12 cm\".\nmoat: --help lists all options.\n");
}

TEST_F(ScriptOptions, RefusesAPositionalArgumentAfterAnOption) {
  const ProgramResult result = run({"--length", "12 cm", "13 cm"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_NE(result.errors.find("13 cm"), std::string::npos) << result.errors;
  EXPECT_EQ(run({"--", "junk"}).exit_code, 2);
}

TEST_F(ScriptOptions, RefusesAnOptionGivenTwice) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--length", "12 cm", "--length", "13 cm"}, {"--length=12 cm", "--length", "13 cm"}}) {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_NE(result.errors.find("--length"), std::string::npos) << result.errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "results"));
  }
}

TEST_F(ScriptOptions, RefusesAnOptionWithoutItsValue) {
  const ProgramResult last = testing::run_program(OPTION_SCRIPT, {"--length"}, folder);
  EXPECT_EQ(last.exit_code, 2);
  EXPECT_TRUE(last.errors.starts_with("moat: error: --length")) << last.errors;
  // Another option where the value should be is no number.
  EXPECT_EQ(testing::run_program(OPTION_SCRIPT, {"--length", "--quiet"}, folder).exit_code, 1);
  EXPECT_EQ(testing::run_program(OPTION_SCRIPT, {"--length", ""}, folder).exit_code, 1);
  EXPECT_FALSE(std::filesystem::exists(folder / "results"));
}

TEST_F(ScriptOptions, FlagsMayBeWrittenWithAValue) {
  EXPECT_EQ(run({"--quiet=true"}).output.find("Results: "), std::string::npos);
  EXPECT_EQ(run({"--quiet"}).output.find("Results: "), std::string::npos);
  EXPECT_NE(run({"--quiet=false"}).output.find("Results: "), std::string::npos);
  ASSERT_TRUE(std::filesystem::exists(folder / "results/moat_option_script_3"));
  EXPECT_EQ(run({"--force=true", "--out", "results/moat_option_script_3"}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder / "results/moat_option_script_3_2"));
  EXPECT_FALSE(std::filesystem::exists(folder / "results/moat_option_script_4"));
}

TEST_F(ScriptOptions, HelpWinsOverEverything) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                    {"-h"},
                                                    {"--length", "12", "--help"},
                                                    {"--length", "--help"},
                                                    {"--help", "--nonsense"},
                                                    {"--record", "missing.AT2", "--help"}}) {
    const ProgramResult result = run(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_NE(result.output.find("Usage:"), std::string::npos) << result.output;
    EXPECT_EQ(result.errors, "");
    EXPECT_FALSE(std::filesystem::exists(folder / "results"));
  }
}

TEST_F(ScriptOptions, HelpListsEveryOptionWithItsUnitAndDefault) {
  const std::string help = run({"--help"}).output;
  for (const char* line : {"--length [m]=0.1 m",
                           "--time [s]=2 s",
                           "--mass [kg]=3 kg",
                           "--push [N]=4000 N",
                           "--speed [m/s]=5 m/s",
                           "--stiffness [N/m]=7000 N/m",
                           "--hertz [N/m^1.5]=8 N/m^1.5",
                           "--number NUMBER=0.65",
                           "--integer INTEGER=5",
                           "--text TEXT=none",
                           "a plain number",
                           "--record FILE",
                           "--record-unit UNIT",
                           "--record-step TIME",
                           "--record-columns WORDS",
                           "--out TEXT=",
                           "--force",
                           "--step [s]=",
                           "--integrator TEXT=",
                           "--end [s]=",
                           "--frame-interval [s]=",
                           "--checkpoint [s]=",
                           "--resume",
                           "--check",
                           "--sensitivity",
                           "--no-sensitivity",
                           "--quiet",
                           "Exit code: 0 done, 1 bad input"})
    EXPECT_NE(help.find(line), std::string::npos) << line << "\n" << help;
}

TEST_F(ScriptOptions, AreCheckedInAScriptWithoutARun) {
  const auto loop = [&](std::vector<std::string> arguments) {
    return testing::run_program(LOOP_SCRIPT, std::move(arguments), folder);
  };
  EXPECT_EQ(loop({}).output, "loop with 0.1\n");
  EXPECT_EQ(loop({"--gap", "20 cm"}).output, "loop with 0.2\n");
  const ProgramResult help = loop({"--help"});
  EXPECT_EQ(help.exit_code, 0);
  EXPECT_NE(help.output.find("--gap [m]"), std::string::npos) << help.output;
  EXPECT_EQ(help.output.find("loop with"), std::string::npos) << help.output;
  const ProgramResult wrong = loop({"--gab", "20 cm"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_EQ(wrong.output, "");
}

TEST_F(ScriptOptions, AreCheckedAtTheEndOfAScriptThatDoesNotCheckThem) {
  const auto loop = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--checked", "0"});
    return testing::run_program(LOOP_SCRIPT, std::move(arguments), folder);
  };
  EXPECT_EQ(loop({"--gap", "20 cm"}).exit_code, 0);
  EXPECT_EQ(loop({"--gab", "20 cm"}).exit_code, 2);
  EXPECT_NE(loop({"--help"}).output.find("--gap [m]"), std::string::npos);
}

TEST_F(ScriptOptions, RefuseFramesWithoutNumber) {
  const ProgramResult result =
      testing::run_program(FIRST_TOUR, {"--end", "10 s", "--frame-interval", "1e-6 s", "--out", "out"}, folder);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("number of frames (end / frame-interval) = "), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("Give a longer --frame-interval"), std::string::npos) << result.errors;
  EXPECT_FALSE(std::filesystem::exists(folder / "out"));
}

}  // namespace
}  // namespace moat
