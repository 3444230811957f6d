#include "launcher/new_project.hpp"

#include <algorithm>
#include <cctype>
#include <system_error>

#include "launcher/phase.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {

void new_project(const Places& places, const std::filesystem::path& folder) {
  namespace fs = std::filesystem;
  const std::string name = folder.filename().string();
  const auto allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; };
  if (name.empty() || name.front() == '-' || !std::ranges::all_of(name, allowed))
    throw Stop{exit_usage, "\"" + name +
                               "\" cannot be the name of a project: use letters, digits, - and _.\n"
                               "For example: ./moat new tower --project"};
  if (fs::exists(fs::symlink_status(folder)))
    throw Stop{exit_usage, folder.string() + " exists already.\nGive another name, or delete it first."};
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : ".";
  if (!fs::is_directory(parent)) throw Stop{exit_usage, "There is no folder " + parent.string() + ".\nMake it first."};
  std::error_code error;
  if (!fs::create_directory(folder, error))
    throw Stop{exit_failed, folder.string() + " cannot be made: " + error.message() + "."};
  const fs::path examples = places.root / "examples";
  const auto write = [&](const fs::path& from, const std::string& to) {
    write_text(folder / to, replaced(text_of(from), "starter", name));
  };
  write(examples / "starter.cpp", name + ".cpp");
  write(examples / "project" / "CMakeLists.txt", "CMakeLists.txt");
  write(examples / "project" / "README.md", "README.md");
  say("Wrote the project " + folder.string() + ". " + (folder / "README.md").string() + " explains how to build it.");
}

}  // namespace moat::launcher
