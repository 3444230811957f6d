#include "performance/machine.hpp"

#include <fstream>
#include <thread>

namespace moat::performance {

std::string machine() {
  std::string processor = "unknown processor";
  std::ifstream info{"/proc/cpuinfo"};
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    processor = line.substr(line.find(':') + 2);
    break;
  }
  return processor + ", " + std::to_string(std::thread::hardware_concurrency()) + " cores, GCC " __VERSION__ ", " +
         MOAT_COMPILE_FLAGS;
}

}  // namespace moat::performance
