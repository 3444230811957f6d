#include "output/provenance.hpp"

#include <array>
#include <ctime>

#include "git_commit.hpp"

namespace moat {

Provenance provenance_of_library() {
  const std::time_t now = std::time(nullptr);
  std::tm utc{};
  gmtime_r(&now, &utc);
  std::array<char, 32> date;
  const std::size_t length = std::strftime(date.data(), date.size(), "%Y-%m-%dT%H:%M:%SZ", &utc);
  return {.moat_version = MOAT_VERSION, .git_commit = git_commit, .date = {date.data(), length}};
}

}  // namespace moat
