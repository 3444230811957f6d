#include "performance/command_output.hpp"

#include <cstdio>
#include <memory>

#include "base/error.hpp"

namespace moat::performance {

std::string output_of(const std::string& command) {
  const auto close = [](std::FILE* stream) { pclose(stream); };
  const std::unique_ptr<std::FILE, decltype(close)> stream{popen(command.c_str(), "r"), close};
  if (!stream) throw Error{"This command cannot be run: " + command};
  std::string output;
  char buffer[256];
  while (std::fgets(buffer, sizeof buffer, stream.get()) != nullptr) output += buffer;
  return output;
}

}  // namespace moat::performance
