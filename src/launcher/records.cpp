#include "launcher/records.hpp"

#include <cstdlib>
#include <filesystem>

#include "launcher/stop.hpp"

namespace moat::launcher {

bool find_records(const std::string& command) {
  const char* folder = std::getenv("MOAT_RECORDS");
  if (folder == nullptr || *folder == '\0') return false;
  if (!std::filesystem::is_directory(folder))
    throw Stop{exit_usage, "MOAT_RECORDS is " + std::string{folder} + ", which is not a folder.\nSee ./moat " +
                               command + " --help."};
  ::setenv("MOAT_RECORDS", std::filesystem::canonical(folder).c_str(), 1);
  return true;
}

}  // namespace moat::launcher
