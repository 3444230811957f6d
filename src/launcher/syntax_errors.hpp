// Errors of the compiler that another error causes: a missing bracket, or an unknown name in braces.
#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "launcher/compiler_output.hpp"
#include "launcher/explanation.hpp"

namespace moat::launcher {

/// A bracket that is missing makes the compiler complain about sound lines before it.
std::optional<Explanation> missing_bracket(const std::vector<ErrorGroup>& groups);

/// The errors without those that another error causes.
std::vector<ErrorGroup> causes(std::vector<ErrorGroup> groups, bool bracket_is_missing,
                               const std::filesystem::path& root);

}  // namespace moat::launcher
