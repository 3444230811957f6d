#include "launcher/study.hpp"

#include <algorithm>
#include <array>

#include "launcher/library.hpp"
#include "launcher/process.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

void read_study(const Places& places, const std::vector<std::string>& words) {
  constexpr std::array names{"show", "export", "merge"};
  if (words.empty() || std::find(names.begin(), names.end(), words.front()) == names.end())
    throw Stop{exit_usage, "study needs one of show, export and merge.\nSee ./moat study --help."};
  bring_up_to_date(places, {.what = "the library", .targets = {"moat_study"}});
  const std::filesystem::path program = places.build / "bin" / "moat_study";
  become(program, "moat study", words);
  throw Stop{exit_failed, program.string() + " cannot be started."};
}

}  // namespace moat::launcher
