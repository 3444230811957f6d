// moat completion
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace moat::launcher {

/// Words that the help of a command knows and the parser does not.
struct CompletionWords {
  std::string command;
  std::vector<std::string> words;
  bool files = false;  ///< names of files fit too
};

/// A script for bash that completes the commands of the program `moat`, their options, and the words given here. With
/// the option and sub-command names of the parser, so that a new one needs no line.
std::string bash_completion(const CLI::App& app, const std::vector<CompletionWords>& more);

}  // namespace moat::launcher
