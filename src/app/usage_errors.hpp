// Mistakes in a command line, explained.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace moat {

/// Lines for standard error that name the mistake in a line that this parser refused. An unknown option is answered
/// with the one that it resembles; `program` names the owner of the options.
std::string usage_error(const CLI::App& parser, const std::string& program, const CLI::ParseError& error);

}  // namespace moat
