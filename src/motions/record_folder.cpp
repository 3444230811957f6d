#include "motions/record_folder.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <string>

#include "base/error.hpp"
#include "motions/read_motion.hpp"
#include "motions/text_file.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

bool is_capital(char c) { return std::isupper(static_cast<unsigned char>(c)) != 0; }
bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

bool is_vertical(const std::string& stem) {
  for (const char* end : {"-UP", "-DWN", "-VER", "-V"})
    if (stem.ends_with(end)) return true;
  return stem.size() > 2 && stem.ends_with("UP") &&
         (is_digit(stem[stem.size() - 3]) || is_capital(stem[stem.size() - 3]));
}

std::vector<fs::path> records_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> files;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
    const bool is_at2 = upper_case(entry->path().extension().string()) == ".AT2";
    if (is_at2 && !is_vertical(entry->path().stem().string())) files.push_back(entry->path());
  }
  if (error)
    throw FileError{"records " + folder.string() + ": " + error.message() + ". Give a folder with .AT2 files."};
  if (files.empty())
    throw FileError{"records " + folder.string() +
                    ": there is no horizontal .AT2 file. Give the folder of the records."};
  std::ranges::sort(files);
  return files;
}

/// The name without its component: "RSN1044_NORTHR_NWH" of "RSN1044_NORTHR_NWH090".
std::string station_of(const std::string& stem) {
  std::size_t end = stem.size();
  while (end > 0 && is_digit(stem[end - 1])) --end;
  if (end == stem.size() && end > 1 && is_capital(stem[end - 1]) && stem[end - 2] == '-') end -= 2;
  return stem.substr(0, end);
}

}  // namespace

std::vector<GroundMotion> read_record_folder(const fs::path& folder) {
  std::vector<GroundMotion> motions;
  for (const fs::path& file : records_in(folder)) motions.push_back(read_motion(file));
  return motions;
}

std::vector<PlanMotion> read_record_pairs(const fs::path& folder) {
  std::map<std::string, std::vector<fs::path>> stations;
  for (const fs::path& file : records_in(folder)) stations[station_of(file.stem().string())].push_back(file);
  std::vector<PlanMotion> pairs;
  for (const auto& [station, files] : stations) {
    if (files.size() > 2)
      throw FileError{"records " + folder.string() + ": " + station + " has " + std::to_string(files.size()) +
                      " horizontal components. Leave two in the folder."};
    if (files.size() == 2) pairs.push_back({read_motion(files[0]), read_motion(files[1]), {}});
  }
  if (pairs.empty())
    throw FileError{"records " + folder.string() +
                    ": no record has two components, files whose names differ only in their last digits or letter."};
  return pairs;
}

}  // namespace moat
