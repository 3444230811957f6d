// Errors for which the compiler gives no reason: the reason is looked up in the list of named fields in the source.
#pragma once

#include <filesystem>
#include <optional>

#include "launcher/compiler_output.hpp"
#include "launcher/explanation.hpp"

namespace moat::launcher {

/// `Moat{...}` with a field that it does not have, or in the wrong place: "class template argument deduction failed".
std::optional<Explanation> wrong_field_of_template(const ErrorGroup& group, const std::filesystem::path& root);

/// `.sides = Moat::right` for `Sides::right`: "missing template arguments before '{' token".
std::optional<Explanation> name_of_a_template(const ErrorGroup& group, const std::filesystem::path& root);

/// `near_fault_pulse({.pulse_period = 1.3})`: the compiler says that the braces fit no NearFaultPulse, and no more.
std::optional<Explanation> list_in_a_call(const ErrorGroup& group, const std::filesystem::path& root);

}  // namespace moat::launcher
