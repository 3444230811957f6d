#include "launcher/study.hpp"

#include <algorithm>
#include <array>

#include "launcher/library_program.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

void read_study(const Places& places, const std::vector<std::string>& words) {
  constexpr std::array names{"show", "export", "merge"};
  if (words.empty() || std::find(names.begin(), names.end(), words.front()) == names.end())
    throw Stop{exit_usage, "study needs one of show, export and merge.\nSee ./moat study --help."};
  become_library_program(places, "study", words);
}

}  // namespace moat::launcher
