#include "launcher/library_program.hpp"

#include "launcher/library.hpp"
#include "launcher/process.hpp"
#include "launcher/stop.hpp"

namespace moat::launcher {

void become_library_program(const Places& places, const std::string& command, const std::vector<std::string>& words) {
  const std::string target = "moat_" + command;
  bring_up_to_date(places, {.what = "the library", .targets = {target}});
  const std::filesystem::path program = places.build / "bin" / target;
  become(program, "moat " + command, words);
  throw Stop{exit_failed, program.string() + " cannot be started."};
}

}  // namespace moat::launcher
