// Every text in the headers of records, and in their names, with texts that try to be more than text.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "app/results.hpp"
#include "hostile_files.hpp"
#include "moat.hpp"
#include "motions/readers/record_folder.hpp"
#include "network_files.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using namespace units;
using testing::Hostile;

/// A record, and words of its header that the text replaces one at a time: stations, events, components, remarks.
struct HeaderTexts {
  std::string record;
  std::vector<std::string> words;
};

const std::vector<HeaderTexts> headers{
    {networks::knet, {"XYZ001", "2018/01/24 19:51:00", "Memo.             ", "E-W"}},
    {networks::afad, {"0921", "AYD\xDDN", "KEY : value", "Copyright", "E-W"}},
    {networks::dyna, {"synthetic", "XY-2018", "XYZ1", "NETWORK: XY", "00\n", "HNE"}},
    {networks::cwa, {"EAS", "2018/02/06-23:50:29.000", "DCoffset(corr)", "U(+)"}},
    {networks::geonet_channel("N80W", "12.25"), {"XYZ", "Line of a synthetic file", "Longitudinal", "N80W"}},
    {networks::cosmos(), {"Line of a synthetic file", "XYZ", "BNZ"}},
    {networks::volume_channel("L", true), {"CUYA", "Line of a synthetic file", "L        "}},
    {networks::volume_channel("L", false), {"Ahar", "Line of a synthetic file"}},
    {networks::smc(), {"SAF0A", "San Francisco, 1295", "1989  10  18", "epicentral", "360"}},
    {networks::csmip_channel("360 Deg", 360, "(8f10.5)"), {"15481673", "WLT", "Line of a synthetic file", "360 Deg"}},
    {networks::unam, {"Line of a synthetic file", "XYZ1", "N90E"}},
    {networks::peer(), {"Kobe Japan", "KJMA", "PEER NGA", "000"}},
    {"# a remark\n0.00 0.1\n0.01 0.2\n0.02 0.1\n", {"a remark"}},
};

class HostileRecords : public Hostile {
 protected:
  /// Reads it as a motion and as a folder. Keeps the notes, and the messages where it is refused.
  void read(const std::string& name, const std::string& content) {
    fs::create_directory(folder / "records");
    const fs::path file = folder / "records" / name;
    std::ofstream{file, std::ios::binary} << content;
    try {
      for (const RecordChannel& channel : read_channels(file, {.unit = 1 * g})) {
        const GroundMotion motion = motion_of(channel);
        last_name = motion.name();
        notes.insert(notes.end(), motion.notes().begin(), motion.notes().end());
        notes.insert(notes.end(), {channel.network, channel.station, channel.location, channel.event});
        notes.push_back(channel.component);
      }
    } catch (const FileError& error) {
      notes.emplace_back(error.what());
    }
    // Its note names the station.
    try {
      static_cast<void>(read_record_pairs(folder / "records"));
    } catch (const FileError& error) {
      notes.emplace_back(error.what());
    }
    fs::remove_all(folder / "records");
  }

  std::vector<std::string> notes;
  std::string last_name;
};

TEST_F(HostileRecords, AreReadWithoutThem) {
  for (const HeaderTexts& header : headers)
    for (const std::string& word : header.words) {
      const fs::path file = folder / "record.txt";
      std::ofstream{file, std::ios::binary} << testing::replaced(header.record, word, word);
      EXPECT_NO_THROW(static_cast<void>(read_channels(file, {.unit = 1 * g}))) << word;
    }
}

TEST_F(HostileRecords, KeepTextsOfHeadersAndNames) {
  for (const std::string& text : testing::hostile_strings()) {
    SCOPED_TRACE(printable(text.substr(0, 60)));
    notes.clear();
    int number = 0;
    for (const HeaderTexts& header : headers)
      for (const std::string& word : header.words)
        read(std::to_string(++number) + ".txt", testing::replaced(header.record, word, text));
    read(testing::file_name(text) + ".AT2", networks::peer());

    Model model;
    add(model, Node{.name = "body", .mass = 1 * kg, .free = true});
    CaseRun run{model, GroundMotion{last_name, 0.01, {0.0, 1.0, 0.0}, notes}, {}};
    run.run();
    CaseResult result = run.result();
    const std::vector<std::string> folder_notes = record_folder_notes();
    result.assumptions.insert(result.assumptions.end(), folder_notes.begin(), folder_notes.end());
    fs::create_directory(folder / "results");
    write_results(result, folder / "results");
    write_record_table(folder / "results" / "records.csv");
    expect_harmless_files("results", text);
    fs::remove_all(folder / "results");
  }
}

// The table that a run wrote reads the same record again.
TEST_F(HostileRecords, AreFoundAgainByTheirTable) {
  for (const std::string name : {"=cmd|' _C calc'!A0", "@SUM(1+1)", "a,b;c'd", "-2+3", "'quoted'"}) {
    const fs::path records = folder / name;
    fs::create_directory(records);
    std::ofstream{records / (name + ".AT2")} << networks::peer();
    const std::vector<Record> before = read_records(records);
    write_record_table(records / "records.csv", records);
    const std::vector<Record> after = read_records(records);
    ASSERT_EQ(after.size(), before.size()) << name;
    EXPECT_TRUE(std::ranges::equal(after[0].first.samples(), before[0].first.samples())) << name;
  }
}

}  // namespace
}  // namespace moat
