// Mistakes in a command line, explained.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <string>

namespace moat {

/// Lines for standard error that name the mistake in a line that this parser refused. An unknown option is answered
/// with the one that it resembles; `program` names the owner of the options.
std::string usage_error(const CLI::App& parser, const std::string& program, const CLI::ParseError& error);

/// The main() of the program behind `name`, such as "moat report": reads the line, and returns the exit code of `work`,
/// or 1 with its error printed.
int run_command(CLI::App& parser, const std::string& name, int argc, char** argv, const std::function<int()>& work);

}  // namespace moat
