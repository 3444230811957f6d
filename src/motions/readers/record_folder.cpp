#include "motions/readers/record_folder.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/read_motion.hpp"
#include "motions/readers/record_formats.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr const char *table_name = "records.csv", *table_head = "file,record,component";

/// A file of a folder: its component, and where that is said.
struct Record {
  fs::path path{};
  std::string station{}, component{}, source{};
};

std::mutex notes_mutex;
std::vector<std::string> all_notes;

void note(const fs::path& folder, const std::string& text) {
  const std::lock_guard lock{notes_mutex};
  const std::string line = "records " + folder.string() + ": " + text;
  if (std::ranges::find(all_notes, line) == all_notes.end()) all_notes.push_back(line);
}

[[noreturn]] void refuse(const fs::path& folder, const std::string& problem) {
  throw FileError{"records " + folder.string() + ": " + problem + " Say it in the table " +
                  (folder / table_name).string() + ": first the line \"" + table_head +
                  "\", then one for each file, such as \"a.AT2,Kobe,first\"; components are first, second, "
                  "vertical and out."};
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_azimuth(const std::string& word) {
  constexpr int turn = 360;
  return !word.empty() && word.size() <= 3 && std::ranges::all_of(word, is_digit) && std::stoi(word) <= turn;
}

bool is_vertical(const std::string& component) {
  static const std::set<std::string> words{"UP", "DOWN", "DWN", "DN", "VER", "VERT", "V", "Z", "UD", "U-D", "VERTICAL"};
  return words.contains(component);
}

bool is_component(const std::string& word) {
  static const std::set<std::string> horizontal{"N",  "E",  "S", "W", "NS", "EW", "N-S", "E-W",
                                                "H1", "H2", "L", "T", "R",  "FN", "FP"};
  return is_vertical(word) || horizontal.contains(word) || is_azimuth(word);
}

/// A header of PEER ends its second line with the component: "Kobe Japan, 1/16/1995, KJMA, 90".
void look_at_header(Record& record) {
  std::ifstream file{record.path};
  std::string text, line, second;
  for (int i = 0; i < 4 && std::getline(file, line); ++i) {
    text += line + "\n";
    if (i == 1) second = upper_case(line);
  }
  const std::size_t comma = std::min(second.rfind(','), second.size());
  // A remark may follow: "230 (USGS STATION 5028)".
  const std::string_view field = std::string_view{second}.substr(comma, second.find('(', comma) - comma);
  const std::string word{trimmed(field.substr(std::min<std::size_t>(1, field.size())))};
  if (is_component(word) && has_peer_at2_header({record.path, text, {}}))
    record = {record.path, second.substr(0, comma), word, "its header"};
}

/// "TCU068-E", "KBU-UP", "NWH090", "KJMUP".
void look_at_name(Record& record) {
  const std::string name = record.path.stem().string(), stem = upper_case(name);
  const std::size_t size = stem.size(), separator = stem.find_last_of("-_. ");
  std::size_t length = separator == std::string::npos ? 0 : size - separator - 1;
  // Numbers of fewer digits may count records.
  const bool ends_in_azimuth = size > 3 && is_azimuth(stem.substr(size - 3)) && !is_digit(stem[size - 4]);
  if (ends_in_azimuth) length = 3;
  const bool ends_in_up = size > 2 && name.ends_with("UP") &&
                          (is_digit(name[size - 3]) || std::isupper(static_cast<unsigned char>(name[size - 3])) != 0);
  if (ends_in_up) length = 2;
  const std::string word = stem.substr(size - length);
  if (!is_component(word) || (is_azimuth(word) && !ends_in_azimuth)) return;
  const std::string station = stem.substr(0, size - length);
  record = {record.path, station.substr(0, station.find_last_not_of("-_. ") + 1), word, "its name"};
}

void look_at_file(Record& record) {
  look_at_header(record);
  if (record.component.empty()) look_at_name(record);
}

/// By the name of a file, the rows of the table in the folder.
std::map<std::string, Record> read_table(const fs::path& folder, const std::set<fs::path>& files) {
  std::map<std::string, Record> rows;
  if (!fs::exists(folder / table_name)) return rows;
  const TextFile table = read_text_file(folder / table_name);
  LineReader lines{table};
  for (std::string_view line; lines.next(line);) {
    const std::size_t one = line.find(','), two = line.rfind(',');
    if (lines.line_number() == 1 ? trimmed(line) == table_head : trimmed(line).empty()) continue;
    const std::string row =
        "line " + std::to_string(lines.line_number()) + " of its table, " + moat::quoted(line) + ", ";
    if (lines.line_number() == 1 || one == two) refuse(folder, row + "is not of this form.");
    const std::string file{trimmed(line.substr(0, one))}, component{trimmed(line.substr(two + 1))};
    if (component != "first" && component != "second" && component != "vertical" && component != "out")
      refuse(folder, row + "names no component.");
    if (!files.contains(folder / file)) refuse(folder, row + "names a file that is not there.");
    const std::string record{trimmed(line.substr(one + 1, two - one - 1))};
    if (!rows.try_emplace(file, Record{folder / file, record, component, table_name}).second)
      refuse(folder, row + "names a file for the second time.");
  }
  return rows;
}

std::vector<Record> records_in(const fs::path& folder) {
  std::error_code error;
  std::set<fs::path> files;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error))
    if (entry->path().filename() != table_name) files.insert(entry->path());
  if (error)
    throw FileError{"records " + folder.string() + ": " + error.message() + ". Give a folder with .AT2 files."};
  const std::map<std::string, Record> table = read_table(folder, files);
  std::vector<Record> records;
  std::string undecided;
  for (const fs::path& file : files) {
    const std::string name = file.filename().string();
    Record record{.path = file};
    if (const auto row = table.find(name); row != table.end()) {
      record = row->second;
    } else if (!fs::is_regular_file(file, error) || upper_case(file.extension().string()) != ".AT2") {
      note(folder, name + " is left out: it is no .AT2 file, and not in " + table_name + ".");
      continue;
    } else {
      look_at_file(record);
    }
    if (record.component.empty())
      undecided += (undecided.empty() ? "" : ", ") + name;
    else if (is_vertical(upper_case(record.component)) || record.component == "out")
      note(folder, name + " is left out: " + record.source + " says " + moat::quoted(record.component) + ".");
    else
      records.push_back(std::move(record));
  }
  if (!undecided.empty())
    refuse(folder, "neither header nor name says whether " + undecided + " is horizontal or vertical.");
  if (records.empty()) refuse(folder, "there is no horizontal .AT2 file.");
  return records;
}

/// Two horizontal components, in the order of the table or of their names.
PlanMotion pair_of(const fs::path& folder, const std::vector<Record>& files) {
  const Record &one = files[0], &two = files[1];
  const std::string names = one.path.filename().string() + " and " + two.path.filename().string();
  constexpr double most_parallel = 0.5;  // 30 degrees off square
  const bool are_parallel =
      is_azimuth(one.component) && is_azimuth(two.component) &&
      std::abs(std::cos((std::stoi(one.component) - std::stoi(two.component)) * units::pi / 180.0)) > most_parallel;
  if (files.size() > 2 || one.component == two.component || are_parallel)
    refuse(folder, one.station + " has " + std::to_string(files.size()) + " horizontal components, " + names +
                       (files.size() > 2 ? " and others" : "") + ", which are no pair at right angles.");
  note(folder, names + " are a pair: components " + one.component + " and " + two.component + " of " +
                   moat::quoted(one.station) + ", says " + one.source + ".");
  const bool turned = one.component == "second";
  return {read_motion((turned ? two : one).path), read_motion((turned ? one : two).path), {}};
}

}  // namespace

std::string says_vertical(const GroundMotion& motion) {
  for (const std::string& line : motion.notes()) {
    const std::string words = upper_case(line);
    if (words.find("VERTICAL") != std::string::npos || (words.starts_with("STREAM:") && words.ends_with('Z')))
      return "its header says " + moat::quoted(line);
  }
  Record record{.path = motion.file().path};
  look_at_file(record);
  return is_vertical(record.component) ? record.source + " says " + moat::quoted(record.component) : "";
}

std::vector<GroundMotion> read_record_folder(const fs::path& folder) {
  std::vector<GroundMotion> motions;
  for (const Record& record : records_in(folder)) motions.push_back(read_motion(record.path));
  return motions;
}

std::vector<PlanMotion> read_record_pairs(const fs::path& folder) {
  std::vector<std::vector<Record>> stations;  // in the order of their first files
  for (const Record& record : records_in(folder)) {
    const auto station = std::ranges::find_if(stations, [&](const std::vector<Record>& each) {
      return each[0].source == record.source && each[0].station == record.station;
    });
    if (station == stations.end())
      stations.push_back({record});
    else
      station->push_back(record);
  }
  std::vector<PlanMotion> pairs;
  for (const std::vector<Record>& files : stations) {
    if (files.size() > 1)
      pairs.push_back(pair_of(folder, files));
    else
      note(folder, files[0].path.filename().string() + " is left out: " + files[0].source +
                       " says that it is a component of " + moat::quoted(files[0].station) + ", and no other file is.");
  }
  if (pairs.empty()) refuse(folder, "no record has two components.");
  return pairs;
}

std::vector<std::string> record_folder_notes() {
  const std::lock_guard lock{notes_mutex};
  return all_notes;
}

}  // namespace moat
