// Records by the folder.

#include "motions/readers/record_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <tuple>
#include <utility>

#include "base/error.hpp"
#include "base/files_read.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

class RecordFolder : public testing::InTemporaryFolder {
 protected:
  void put(const std::string& name) const { put(name, "synthetic, " + name); }
  void put(const std::string& name, const std::string& second_line) const {
    std::ofstream{folder / name} << "PEER NGA STRONG MOTION DATABASE RECORD\n"
                                 << second_line
                                 << "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n 0.0 0.1 0.0\n";
  }
};

/// Whether one of the notes has the words.
bool notes_have(const std::string& words) {
  return std::ranges::any_of(record_folder_notes(),
                             [&](const std::string& note) { return note.find(words) != std::string::npos; });
}

TEST_F(RecordFolder, ReadsHorizontalRecordsInTheOrderOfTheirNames) {
  for (const char* name : {"RSN2_B090.AT2", "RSN1_A000.at2", "RSN1_A-UP.AT2", "RSN3_CUP.AT2", "RSN4_D-V.AT2"})
    put(name);
  std::ofstream{folder / "notes.md"} << "Notes about\nthese records\n";
  const std::vector<GroundMotion> motions = read_record_folder(folder);
  ASSERT_EQ(motions.size(), 2u);
  EXPECT_EQ(motions[0].file().path, (folder / "RSN1_A000.at2").string());
  EXPECT_EQ(motions[1].file().path, (folder / "RSN2_B090.AT2").string());
}

TEST_F(RecordFolder, FindsPairsByTheirNames) {
  for (const char* name : {"RSN1_NWH090.AT2", "RSN1_NWH360.AT2", "RSN2_TCU068-E.AT2", "RSN2_TCU068-N.AT2",
                           "RSN3_PUL164.AT2", "RSN1_NWH-UP.AT2"})
    put(name);
  const std::vector<PlanMotion> pairs = read_record_pairs(folder);
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_NE(pairs[0].first.file().path.find("NWH090"), std::string::npos) << "90 degrees clockwise of the other";
  EXPECT_NE(pairs[0].second.file().path.find("NWH360"), std::string::npos);
  EXPECT_NE(pairs[1].second.file().path.find("TCU068-N"), std::string::npos);
  EXPECT_TRUE(notes_have("RSN1_NWH-UP.AT2 is left out: its name says \"UP\"."));
  EXPECT_FALSE(pairs[0].vertical);
}

TEST_F(RecordFolder, RefusesFoldersWithoutThem) {
  EXPECT_THROW(read_record_folder(folder / "none"), FileError);
  EXPECT_THROW(read_record_folder(folder), FileError);
  put("RSN1_A000.AT2");
  EXPECT_THROW(read_record_pairs(folder), FileError);
  put("RSN1_A090.AT2");
  put("RSN1_A180.AT2");
  EXPECT_NE(testing::message_of<FileError>([&] {
              read_record_pairs(folder);
            }).find("RSN1_A has 3 horizontal components (000, 090, 180)"),
            std::string::npos);
}

std::vector<std::string> names_of(const std::vector<GroundMotion>& motions) {
  std::vector<std::string> names;
  for (const GroundMotion& motion : motions) names.push_back(motion.name());
  return names;
}

TEST_F(RecordFolder, BelievesHeadersBeforeNames) {
  put("first.AT2", "Kobe Japan, 1/16/1995, KJMA, 0");
  put("second-UP.AT2", "Kobe Japan, 1/16/1995, KJMA, 90 (JMA)");
  put("third090.AT2", "Kobe Japan, 1/16/1995, KJMA, UP");
  put("fourth.AT2", "Pacoima Dam (upper left abut), vert");
  put("fifth-N.AT2", "Kobe Japan, 1/16/1995, Takatori, N");
  EXPECT_EQ(names_of(read_record_folder(folder)), (std::vector<std::string>{"fifth-N", "first", "second-UP"}));
  EXPECT_TRUE(notes_have(folder.string() + ": third090.AT2 is left out: its header says \"UP\""));
  EXPECT_TRUE(notes_have("fourth.AT2 is left out: its header says \"vert\""));
  const std::vector<PlanMotion> pairs = read_record_pairs(folder);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first.name() + pairs[0].second.name(), "second-UPfirst");
  EXPECT_TRUE(notes_have("second-UP.AT2 is x of \"KJMA\": its header says \"90\"."));
  EXPECT_TRUE(notes_have("first.AT2 is y of \"KJMA\": its header says \"0\"."));
  EXPECT_TRUE(notes_have(
      "fifth-N.AT2 is left out: its header says \"N\", 0 deg, and Takatori has no second horizontal component."));
}

TEST_F(RecordFolder, KnowsTheWordsAtTheEndOfNames) {
  for (const char* name : {"a-UP", "a_ver", "a-DWN", "a V", "a-Z", "a-ud", "aUP1UP"}) put(name + std::string{".AT2"});
  for (const char* name : {"b-N", "b_ew", "b-H1", "b-L", "b045", "b-360"}) put(name + std::string{".AT2"});
  EXPECT_EQ(read_record_folder(folder).size(), 6u);
  for (const char* name : {"a-UP", "a_ver", "a-DWN", "a V", "a-Z", "a-ud", "aUP1UP"})
    EXPECT_TRUE(notes_have(name + std::string{".AT2 is left out: its name says"})) << name;
}

TEST_F(RecordFolder, ListsEveryFileThatItLeavesOut) {
  put("RSN1_A000.AT2");
  std::filesystem::create_directories(folder / "folder");
  std::filesystem::create_directories(folder / "more.AT2");
  read_record_folder(folder);
  for (const char* name : {"folder", "more.AT2"})
    EXPECT_TRUE(notes_have(folder.string() + ": " + name + " is left out: it is no file")) << name;
  const std::size_t count = record_folder_notes().size();
  read_record_folder(folder);
  EXPECT_EQ(record_folder_notes().size(), count) << "once";
}

// Numbers that count, years, words of a station: none is a component.
TEST_F(RecordFolder, RefusesToGuess) {
  for (const char* name : {"kobe", "kobe1", "kobe-2", "kobe_1995", "record999", "kobe2024", "SHE", "kobe-Vernon"}) {
    put(name + std::string{".AT2"}, "synthetic, Los Angeles - E");
    const std::string message = testing::message_of<FileError>([&] { read_record_folder(folder); });
    EXPECT_NE(message.find("neither header nor name says whether " + std::string{name} + ".AT2"), std::string::npos)
        << message;
    EXPECT_NE(message.find((folder / "records.csv").string()), std::string::npos) << message;
    EXPECT_NE(message.find("file,channel,record,component"), std::string::npos) << message;
    std::filesystem::remove(folder / (name + std::string{".AT2"}));
  }
}

TEST_F(RecordFolder, RefusesPairsThatAreParallel) {
  for (const auto& [one, two, is_pair] :
       std::vector<std::tuple<std::string, std::string, bool>>{{"000", "180", false},
                                                               {"010", "030", false},
                                                               {"260", "345", true},
                                                               {"045", "315", true},
                                                               {"000", "360", false},
                                                               {"090", "151", true}}) {
    const std::string first = "A" + one + ".AT2", second = "A" + two + ".AT2";
    const bool is_same = two == "360";
    put(first);
    put(second);
    if (is_pair)
      EXPECT_EQ(read_record_pairs(folder).size(), 1u) << first << second;
    else
      EXPECT_NE(testing::message_of<FileError>([&] {
                  read_record_pairs(folder);
                }).find(is_same ? "no record has two components" : "no pair at right angles"),
                std::string::npos)
          << first << second;
    std::filesystem::remove(folder / first);
    std::filesystem::remove(folder / second);
  }
}

TEST_F(RecordFolder, HasATableThatDecides) {
  for (const char* name : {"kobe1.AT2", "kobe2.AT2", "A000.AT2", "A090.AT2", "B-UP.AT2", "C000.AT2"}) put(name);
  std::ofstream{folder / "east.txt"} << "0 0\n0.1 1\n0.2 0\n";
  const auto table = [&](const std::string& rows) {
    std::ofstream{folder / "records.csv"} << "file,record,component\r\n" << rows;
  };
  table("kobe1.AT2,Kobe,second\nkobe2.AT2, Kobe , first\nA000.AT2,,out\nB-UP.AT2,B,first\n\nC000.AT2,C,vertical\n");
  EXPECT_EQ(names_of(read_record_folder(folder)), (std::vector<std::string>{"A090", "B-UP", "kobe1", "kobe2"}));
  EXPECT_TRUE(notes_have("A000.AT2 is left out: records.csv says \"out\""));
  EXPECT_TRUE(notes_have("C000.AT2 is left out: records.csv says \"vertical\""));
  const std::vector<PlanMotion> pairs = read_record_pairs(folder);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0].first.name() + pairs[0].second.name(), "kobe2kobe1");
  // A change of the table is seen as one of a record.
  const auto files = files_read_by_program();
  EXPECT_TRUE(std::ranges::any_of(files, [&](const FileRead& each) { return each.path == folder / "records.csv"; }));
  for (const auto& [rows, problem] : std::vector<std::pair<std::string, std::string>>{
           {"kobe1.AT2,first\n", "line 2 of its table, \"kobe1.AT2,first\", is not of this form"},
           {"kobe1.AT2,Kobe,up\n", "names no component"},
           {"none.AT2,Kobe,first\n", "names a file that is not there"},
           {"../kobe1.AT2,Kobe,first\n", "names a file that is not there"},
           {"A000.AT2,A,out\nA000.AT2,A,first\n", "line 3 of its table"},
           {"kobe1.AT2,K,first\nkobe2.AT2,K,first\n", "K has two components x, kobe1.AT2 and kobe2.AT2"}}) {
    table(rows);
    const std::string message = testing::message_of<FileError>([&] { read_record_pairs(folder); });
    EXPECT_NE(message.find(problem), std::string::npos) << message;
  }
  std::ofstream{folder / "records.csv"} << "A000.AT2,A,first\n";
  EXPECT_NE(testing::message_of<FileError>([&] { read_record_folder(folder); }).find("line 1 of its table"),
            std::string::npos);
}

}  // namespace
}  // namespace moat
