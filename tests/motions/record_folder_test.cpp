// Records by the folder.

#include "motions/record_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "base/error.hpp"
#include "message_of.hpp"
#include "run_program.hpp"

namespace moat {
namespace {

class RecordFolder : public testing::InTemporaryFolder {
 protected:
  void put(const std::string& name) const {
    std::ofstream{folder / name} << "PEER NGA STRONG MOTION DATABASE RECORD\nsynthetic, " << name
                                 << "\nACCELERATION TIME SERIES IN UNITS OF G\nNPTS= 3, DT= .01 SEC\n 0.0 0.1 0.0\n";
  }
};

TEST_F(RecordFolder, ReadsHorizontalRecordsInTheOrderOfTheirNames) {
  for (const char* name :
       {"RSN2_B090.AT2", "RSN1_A000.at2", "RSN1_A-UP.AT2", "RSN3_CUP.AT2", "RSN4_D-V.AT2", "notes.md"})
    put(name);
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
  EXPECT_NE(pairs[0].first.file().path.find("NWH090"), std::string::npos);
  EXPECT_NE(pairs[0].second.file().path.find("NWH360"), std::string::npos);
  EXPECT_NE(pairs[1].second.file().path.find("TCU068-N"), std::string::npos);
}

TEST_F(RecordFolder, RefusesFoldersWithoutThem) {
  EXPECT_THROW(read_record_folder(folder / "none"), FileError);
  EXPECT_THROW(read_record_folder(folder), FileError);
  put("RSN1_A000.AT2");
  EXPECT_THROW(read_record_pairs(folder), FileError);
  put("RSN1_A090.AT2");
  put("RSN1_A180.AT2");
  EXPECT_NE(testing::message_of<FileError>([&] { read_record_pairs(folder); }).find("RSN1_A has 3"), std::string::npos);
}

}  // namespace
}  // namespace moat
