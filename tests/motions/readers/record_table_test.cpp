// The table of records is written by a user, or by moat for the user.

#include <cmath>
#include <map>
#include <optional>

#include "record_files.hpp"

namespace moat {
namespace {

using namespace units;

class RecordTables : public Records {};

TEST_F(RecordTables, Decide) {
  put("a.AT2", "0", "0.5 0.0");
  put("b.AT2", "90", "0.25 0.0");
  (void)write("c.txt", "0.125\n0.0\n");
  (void)write("readme.md", "Records\nof a test\nhere\n");
  (void)write("study.db", std::string(2000, '\1'));
  const auto table = [&](const std::string& rows) {
    (void)write("records.csv", "file,channel,record,component,azimuth,unit,step,sign\n" + rows);
  };
  table("a.AT2,1,Kobe,x,,,,-1\nb.AT2,1,Kobe,y,,g,.01,\nc.txt,,Kobe,z,,mg,0.01,\n");
  Record record = read();
  EXPECT_EQ(record.name, "Kobe");
  EXPECT_NEAR(values_of(record.first)[0], -0.5, 1e-12) << "mirrored by the user";
  EXPECT_NEAR(values_of(*record.second)[0], 0.25, 1e-12);
  EXPECT_NEAR(values_of(*record.vertical)[0], 0.125e-3, 1e-12);
  EXPECT_TRUE(notes_have("readme.md is left out: unknown format."));
  EXPECT_TRUE(notes_have("study.db is left out: this is no plain text"));
  table("a.AT2,,,,45,,,\nb.AT2,,,,315,,,\n");
  record = read();
  EXPECT_EQ(record.frame.azimuth, 45.0);
  EXPECT_TRUE(notes_have("c.txt is left out: plain text does not say its unit"));
  for (const auto& [rows, problem] : std::vector<std::pair<std::string, std::string>>{
           {"a.AT2,,,,45\n", "is not of this form"},
           {"a.AT2,,,q,,,,\n", "names no component"},
           {"a.AT2,,,,400,,,\n", "an azimuth outside 0 to 360 deg"},
           {"a.AT2,,,,,,,2\n", "a sign that is neither 1 nor -1"},
           {"a.AT2,,,,,bananas,,\n", "a unit that is not known"},
           {"a.AT2,,,,,,0,\n", "a step that is not > 0 s"},
           {"a.AT2,,,,x,,,\n", "records.csv, line 2: \"x\" is not a number."},
           {"d.AT2,,,,,,,\n", "names a file that is not there"},
           {"a.AT2,2,,x,,,,\n", "names channel 2 of a.AT2, which has 1"},
           {"a.AT2,1.5,,x,,,,\n", "a channel that is no whole number"},
           {"a.AT2,,,,,gal,,\n", "has another unit than the file, g"},
           {"a.AT2,,,,,,.02,\n", "has another step than the file"},
           {"a.AT2,,K,x,,,,\nb.AT2,,K,x,,,,\n", "K has two components x, a.AT2 and b.AT2"}}) {
    table(rows);
    expect_refused(problem);
  }
  (void)write("records.csv", "file,azimut\na.AT2,90\n");
  expect_refused("has a column \"azimut\" that is not known");
  expect_refused("no such file", {.table = folder / "none.csv"});
}

struct Kind {
  const char* name;
  std::map<std::string, std::string> files;
  RecordOptions options{};
};

std::string peer(const std::string& component, const std::string& values, const std::string& step = ".01") {
  return "PEER\nKobe Japan, 1/16/1995, KJMA, " + component + "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= " +
         std::to_string(std::count(values.begin(), values.end(), ' ') + 1) + ", DT= " + step + " SEC\n" + values + "\n";
}

// Azimuths of files, of the table and assumed ones; signs; steps that differ, that no short number gives, and that
// times give; units; several columns; names of files with the marks of a table.
const std::vector<Kind> kinds{
    {"azimuths that are not square", {{"a.AT2", peer("260", "1 0 .3")}, {"b.AT2", peer("345", "0 1 .7")}}},
    {"down", {{"a.AT2", peer("0", "1 0")}, {"b.AT2", peer("90", "0 1")}, {"c.AT2", peer("DWN", "0 .5")}}},
    {"azimuths assumed", {{"a.AT2", peer("T", "1 0")}, {"b.AT2", peer("L", "0 1")}}},
    {"one azimuth assumed", {{"a.AT2", peer("T", "1 0")}, {"b.AT2", peer("352", "0 1")}}},
    {"one azimuth assumed, turned",
     {{"a.AT2", peer("T", "1 0")}, {"b.AT2", peer("L", "0 1")}},
     {.x_azimuth = 30 * deg}},
    {"steps that differ", {{"a.AT2", peer("0", "1 0 .3")}, {"b.AT2", peer("90", "0 1 .7 .1", ".005")}}},
    {"signs and azimuths of a table",
     {{"a.AT2", peer("L", "1 0 .3")},
      {"b.AT2", peer("T", "0 1 .7")},
      {"c.AT2", peer("UP", ".5 0 0")},
      {"records.csv", "file,component,azimuth,sign\na.AT2,,10,-1\nb.AT2,,95,\nc.AT2,,,-1\n"}}},
    {"components of a table",
     {{"a.AT2", peer("0", "1 0 .3")},
      {"b.AT2", peer("90", "0 1 .7")},
      {"records.csv", "file,record,component,sign\na.AT2,\"Kobe, 1995\",x,-1\nb.AT2,\"Kobe, 1995\",y,\n"}}},
    {"text with and without times",
     {{"a-N.txt", "# 60 Hz\n.1\n.2\n-.3\n"}, {"a-E.txt", "0 .1\n.016666667 .2\n.033333333 -.5\n"}},
     {.text = {.unit = 1.0 / 3.0 * m / s / s}}},
    {"a step that was given",
     {{"a-N.txt", ".1\n.2\n-.3\n"}, {"a-E.txt", ".3\n.1\n-.3\n"}},
     {.text = {.unit = 1 * g, .step = 1.0 / 60.0 * s}}},
    {"columns that were named",
     {{"a.txt", "9 .1 .2\n8 .2 .5\n7 -.3 .1\n"}},
     {.text = {.unit = 1 * g, .step = 0.02 * s, .columns = "-,y,x"}}},
    {"names with the marks of a table", {{"#a, 1.AT2", peer("0", "1 0")}, {"b.AT2", peer("90", "0 1")}}},
};

TEST_F(RecordTables, WrittenByMoatReadTheSameAgain) {
  for (const Kind& kind : kinds) {
    SCOPED_TRACE(kind.name);
    const auto here = folder / kind.name, table = here / "read.csv";
    std::filesystem::create_directories(here);
    for (const auto& [name, text] : kind.files) (void)write((std::filesystem::path{kind.name} / name).string(), text);
    const Record before = read_record({here}, kind.options);
    write_record_table(table, here);
    // The table says all facts about text; an azimuth of x is no fact about a file.
    const Record after = read_record({here}, {.x_azimuth = kind.options.x_azimuth, .table = table});
    const auto expect_same = [](const GroundMotion& one, const GroundMotion& two) {
      EXPECT_EQ(std::vector<double>(one.samples().begin(), one.samples().end()),
                std::vector<double>(two.samples().begin(), two.samples().end()));
      EXPECT_EQ(one.time_step(), two.time_step());
    };
    EXPECT_EQ(before.name, after.name);
    expect_same(before.first, after.first);
    ASSERT_EQ(before.second.has_value(), after.second.has_value());
    if (before.second) expect_same(*before.second, *after.second);
    ASSERT_EQ(before.vertical.has_value(), after.vertical.has_value());
    if (before.vertical) expect_same(*before.vertical, *after.vertical);
    EXPECT_EQ(before.frame.azimuth, after.frame.azimuth);
    EXPECT_EQ(before.frame.is_assumed, after.frame.is_assumed);
    EXPECT_EQ(before.frame.is_mixed, after.frame.is_mixed);
    EXPECT_EQ(before.frame.channels, after.frame.channels);
  }
}

// Of two records, one is left out.
TEST_F(RecordTables, WrittenByMoatHoldTheFactsOfFilesAndTables) {
  put("a.AT2", "L", "0.5 0.0 0.1", ".02");
  put("b.AT2", "T", "0.25 0.0", ".01");
  put("c.AT2", "T", "0.25", ".01");
  (void)write("records.csv", "file,sign,component\na.AT2,-1,\nc.AT2,,out\n");
  const Record record = read();
  EXPECT_DOUBLE_EQ(record.first.time_step(), 0.01);
  EXPECT_TRUE(notes_have("a.AT2 is y of \"KJMA\": its header says \"L\", 0 deg assumed."));
  write_record_table(folder / "read.csv", folder);
  const std::string text = testing::read_file(folder / "read.csv");
  EXPECT_TRUE(
      text.starts_with("file,channel,record,component,azimuth,unit,step,sign,columns,format,level,reason,peak,start\n"))
      << text;
  // The azimuths are assumed, and a has the step of its file.
  EXPECT_NE(text.find("\na.AT2,1,,,,g,0.02,-1,,PEER AT2,corrected,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nb.AT2,1,,,,g,0.01,,,PEER AT2,corrected,"), std::string::npos) << text;
  EXPECT_NE(text.find("\nc.AT2,1,,out,"), std::string::npos) << text;
}

}  // namespace
}  // namespace moat
