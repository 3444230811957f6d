// What another program prints.
#pragma once

#include <string>

namespace moat::performance {

/// Standard output of a command of the shell, whether it succeeds or not. Throws Error if there is no shell.
std::string output_of(const std::string& command);

}  // namespace moat::performance
