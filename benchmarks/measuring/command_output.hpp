// The output of another program.
#pragma once

#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "base/error.hpp"

namespace moat::performance {

/// A word for a shell command. It may have any characters.
inline std::string shell_quoted(const std::string& word) {
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return quoted + "'";
}

/// The standard output of a shell command. Throws Error where it cannot be run or does not exit with 0.
inline std::string output_of(const std::string& command) {
  std::FILE* stream = popen(command.c_str(), "r");
  if (stream == nullptr) throw Error{"This command cannot be run: " + command};
  std::string output;
  std::array<char, 4096> buffer;
  for (std::size_t count; (count = std::fread(buffer.data(), 1, buffer.size(), stream)) > 0;)
    output.append(buffer.data(), count);
  if (pclose(stream) != 0) throw Error{"This command failed: " + command};
  return output;
}

/// The standard output of this program with other arguments, in a process of its own. Throws as output_of() does.
inline std::string output_of_this_program(const std::string& arguments) {
  return output_of(shell_quoted(std::filesystem::read_symlink("/proc/self/exe").string()) + " " + arguments);
}

}  // namespace moat::performance
