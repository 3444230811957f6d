// Names with control characters, which a terminal would obey.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "run_program.hpp"

namespace moat {
namespace {

using nlohmann::json;
using testing::ProgramResult;

// Red text, a bell, a line that is written over, and the second half of the control characters.
const std::string hostile =
    "\x1b[31m\a\b\t\r\x7F\xC2\x9B"
    "31m";
const std::string shown = "\\u001b[31m\\u0007\\u0008\\u0009\\u000d\\u007f\\u009b31m";
const std::string in_json = "\\u001b[31m\\u0007\\b\\t\\r\\u007f\\u009b31m";

class PrintedNames : public testing::InTemporaryFolder {
 protected:
  PrintedNames() { setenv("MOAT_TEST_NAME", hostile.c_str(), 1); }
  ~PrintedNames() override { unsetenv("MOAT_TEST_NAME"); }

  static void expect_printable(const ProgramResult& result) {
    for (const std::string& text : {result.output, result.errors})
      for (std::size_t i = 0; i < text.size(); ++i) {
        const auto code = static_cast<unsigned char>(text[i]);
        EXPECT_FALSE((code < 0x20 && code != '\n') || code == 0x7F || (code == 0x9B && text[i - 1] == '\xC2'))
            << "character " << static_cast<int>(code) << " in " << text.substr(0, i);
      }
    const std::string all = result.output + result.errors;
    EXPECT_NE(std::min(all.find(shown), all.find(in_json)), std::string::npos) << all;
  }
  void write_record(const std::string& name, const std::string& values) {
    std::ofstream{folder / name} << "A\nB\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 4, DT= .1 SEC\n"
                                 << values << "\n";
  }
};

TEST_F(PrintedNames, OfARunArePrintable) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--out", "out"},
                                                    {"--out", "quiet", "--check", "--step", "0.3 s"},
                                                    {"--help"},
                                                    {"--" + hostile},
                                                    {"--end", hostile},
                                                    {"--out", "out" + hostile},
                                                    {"--out", "out", "--force"}})
    expect_printable(testing::run_program(OBSERVER_SCRIPT, arguments, folder));
}

TEST_F(PrintedNames, OfARunStayAsTheyAreInJson) {
  const ProgramResult result = testing::run_program(OBSERVER_SCRIPT, {"--json", "--out", "out"}, folder);
  expect_printable(result);
  EXPECT_EQ(json::parse(result.output).at("title"), "Observers" + hostile);
}

TEST_F(PrintedNames, OfRecordsArePrintable) {
  write_record("good" + hostile + ".AT2", "0 .1 -.1 0");
  write_record("bad" + hostile + ".AT2", "0 .1 x 0");
  for (const char* name : {"good", "bad", "missing"}) {
    const std::string record = name + hostile + ".AT2";
    expect_printable(testing::run_program(FIRST_TOUR, {"--record", record, "--end", "0.2 s"}, folder));
    expect_printable(testing::run_program(MOTION_COMMAND, {record}, folder));
    expect_printable(testing::run_program(MOTION_COMMAND, {record, "--json"}, folder));
  }
  expect_printable(testing::run_program(MOTION_COMMAND, {"good" + hostile + ".AT2", "--out", "out" + hostile}, folder));
}

TEST_F(PrintedNames, OfStudiesAndReportsArePrintable) {
  const std::string out = "out" + hostile, record = "a" + hostile + ".AT2";
  write_record(record, "0 .1 -.1 0");
  ASSERT_EQ(testing::run_program(OBSERVER_SCRIPT, {"--out", out}, folder).exit_code, 0);
  expect_printable(testing::run_program(REPORT_COMMAND, {out}, folder));
  expect_printable(testing::run_program(REPORT_COMMAND, {out, "--json"}, folder));
  expect_printable(testing::run_program(REPORT_COMMAND, {"missing" + hostile}, folder));
  const std::string study = "study" + hostile;
  expect_printable(testing::run_program(
      STUDY_SCRIPT, {"--gaps", "2", "--failing", "1", "--out", study, "--inside", "missing" + hostile}, folder));
  expect_printable(testing::run_program(STUDY_SCRIPT, {"--gaps", "2", "--out", study, "--json"}, folder));
  for (const char* command : {"show", "export"})
    expect_printable(testing::run_program(STUDY_COMMAND, {command, study}, folder));
  expect_printable(testing::run_program(REPORT_COMMAND, {study}, folder));
}

}  // namespace
}  // namespace moat
