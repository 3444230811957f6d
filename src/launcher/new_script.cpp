#include "launcher/new_script.hpp"

#include "launcher/installed_text.hpp"
#include "launcher/phase.hpp"
#include "launcher/stop.hpp"
#include "launcher/text.hpp"

namespace moat::launcher {

void new_script(const Places& places, const std::filesystem::path& typed) {
  namespace fs = std::filesystem;
  fs::path file = typed;
  if (!file.has_extension() && file.has_filename()) file += ".cpp";
  const std::string name = file.string();
  if (file.extension() != ".cpp")
    throw Stop{exit_usage, name + " does not end in .cpp.\nFor example: ./moat new tower.cpp"};
  if (name.starts_with('-')) throw Stop{exit_usage, name + " looks like an option.\nFor example: ./moat new ./" + name};
  std::error_code too_long;
  if (fs::exists(fs::symlink_status(file, too_long)))
    throw Stop{exit_usage, name + " exists already.\nGive another name, or delete it first."};
  const fs::path folder = file.has_parent_path() ? file.parent_path() : ".";
  if (!fs::is_directory(folder)) throw Stop{exit_usage, "There is no folder " + folder.string() + ".\nMake it first."};
  const std::string stem = replaced(replaced(file.stem().string(), "\\", "\\\\"), "\"", "\\\"");
  write_text(file, replaced(text_of(places.root / "examples" / "starter.cpp"), "\"starter\"", "\"" + stem + "\""));
  say("Wrote " + name + ". Run it with: " + as_installed("./moat run ", places) + shell_quoted(name));
}

}  // namespace moat::launcher
