// Looks at all files in results folders of moat: valid_results FOLDER...
//
// Prints for each the word complete (results and their list), unfinished (the mark stands there) or partial, and every
// file that is torn. Exit code 1 if there is one.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <set>
#include <string>

namespace {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream stream{file, std::ios::binary};
  return {std::istreambuf_iterator<char>{stream}, {}};
}

/// Whether all lines have as many fields as the first, and the last one is whole.
bool is_whole_csv(const std::string& text) {
  std::set<int> counts;
  bool is_quoted = false;
  int commas = 0;
  for (const char c : text) {
    if (c == '"') is_quoted = !is_quoted;
    if (is_quoted) continue;
    commas += c == ',' ? 1 : 0;
    if (c == '\n') counts.insert(std::exchange(commas, 0));
  }
  return text.ends_with('\n') && counts.size() == 1 && !is_quoted;
}

bool ends_with(std::string text, const std::string& end) {
  text.erase(text.find_last_not_of(" \n") + 1);
  return text.ends_with(end);
}

/// Whether all frames that the list names are there.
bool has_its_frames(const fs::path& list) {
  const std::string text = text_of(list), key = "file=\"";
  for (std::size_t at = 0; (at = text.find(key, at)) != std::string::npos;) {
    at += key.size();
    if (!fs::exists(list.parent_path() / text.substr(at, text.find('"', at) - at))) return false;
  }
  return ends_with(text, "</VTKFile>");
}

bool is_whole(const fs::path& file) {
  const std::string kind = file.extension();
  if (kind == ".json") return nlohmann::json::accept(text_of(file));
  if (kind == ".csv") return is_whole_csv(text_of(file));
  if (kind == ".html") return ends_with(text_of(file), "</html>");
  if (kind == ".svg") return ends_with(text_of(file), "</svg>");
  if (kind == ".vtu" || kind == ".vtt") return ends_with(text_of(file), "</VTKFile>");
  if (kind == ".pvd") return has_its_frames(file);
  return file.filename().string().find(".unfinished-") == std::string::npos;
}

}  // namespace

int main(int count, char** folders) {
  int torn = 0;
  for (int i = 1; i < count; ++i) {
    const fs::path folder = folders[i];
    const bool is_complete = fs::exists(folder / "summary.json") && fs::exists(folder / ".moat");
    const bool is_unfinished = !is_complete && fs::exists(folder / "unfinished");
    std::cout << (is_unfinished ? "unfinished" : is_complete ? "complete" : "partial") << "\n";
    const std::string frames = text_of(folder / "frames.pvd");
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator{folder}) {
      const fs::path& file = entry.path();
      // A run that was killed may leave the file that it wrote then: a temporary one, or a frame that is not listed.
      const std::string name = file.filename();
      const bool was_in_work = name.find(".unfinished-") != std::string::npos || file.extension() == ".pvd" ||
                               (file.extension() == ".vtu" && frames.find(name) == std::string::npos);
      if (!entry.is_regular_file() || (is_unfinished && was_in_work) || is_whole(file)) continue;
      std::cout << "torn: " << file.string() << "\n";
      ++torn;
    }
  }
  return torn > 0 ? 1 : 0;
}
