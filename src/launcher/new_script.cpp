#include <algorithm>
#include <cctype>
#include <system_error>

#include "base/text/terminal.hpp"
#include "launcher/commands.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {
namespace {

namespace fs = std::filesystem;

// The file or folder is new, and can lie there.
void check_place(const fs::path& place) {
  std::error_code too_long;
  if (fs::exists(fs::symlink_status(place, too_long)))
    throw Stop{exit_usage, place.string() + " exists already.\nGive another name, or delete it first."};
  const fs::path folder = place.has_parent_path() ? place.parent_path() : ".";
  if (!fs::is_directory(folder)) throw Stop{exit_usage, "There is no folder " + folder.string() + ".\nMake it first."};
}

}  // namespace

void new_script(const Places& places, const fs::path& typed) {
  fs::path file = typed;
  if (!file.has_extension() && file.has_filename()) file += ".cpp";
  const std::string name = file.string();
  if (file.extension() != ".cpp")
    throw Stop{exit_usage, name + " does not end in .cpp.\nFor example: ./moat new tower.cpp"};
  if (name.starts_with('-')) throw Stop{exit_usage, name + " looks like an option.\nFor example: ./moat new ./" + name};
  check_place(file);
  std::string stem = file.stem().string();
  for (const auto& [plain, in_code] : {std::pair{"\\", "\\\\"}, {"\"", "\\\""}, {"\n", "\\n"}, {"\r", "\\r"}})
    stem = replaced(stem, plain, in_code);
  write_text(file, replaced(text_of(places.root / "examples" / "starter.cpp"), "\"starter\"", "\"" + stem + "\""));
  say("Wrote " + name + ". Run it with: " + places.adapted("./moat run ") + shell_word(name));
}

void new_project(const Places& places, const fs::path& folder) {
  const std::string name = folder.filename().string();
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || name.front() == '-' || !std::ranges::all_of(name, allowed))
    throw Stop{exit_usage, "\"" + name +
                               "\" cannot be the name of a project: use letters, digits, - and _.\n"
                               "For example: ./moat new tower --project"};
  check_place(folder);
  std::error_code error;
  if (!fs::create_directory(folder, error))
    throw Stop{exit_failed, folder.string() + " cannot be made: " + error.message() + "."};
  for (const auto& [from, to] : {std::pair{"starter.cpp", name + ".cpp"},
                                 {"project/CMakeLists.txt", "CMakeLists.txt"},
                                 {"project/README.md", "README.md"}})
    write_text(folder / to, replaced(text_of(places.root / "examples" / from), "starter", name));
  say("Wrote the project " + folder.string() + ". " + (folder / "README.md").string() + " explains how to build it.");
}

}  // namespace moat::launcher
