// Errors for which the compiler gives no reason: the reason is looked up in the list of named fields in the source.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "launcher/compiler_output.hpp"
#include "launcher/explanation.hpp"

namespace moat::launcher {

/// `Moat{...}` with a field that it does not have, or in the wrong place: "class template argument deduction failed".
std::optional<Explanation> wrong_field_of_template(const ErrorGroup& group, const std::filesystem::path& root);

/// `.sides = Moat::right` for `Sides::right`: "missing template arguments before '{' token".
std::optional<Explanation> name_of_a_template(const ErrorGroup& group, const std::filesystem::path& root);

/// `near_fault_pulse({.pulse_period = 1.3})`: the compiler says that the braces fit no NearFaultPulse, and no more.
std::optional<Explanation> list_in_a_call(const ErrorGroup& group, const std::filesystem::path& root);

/// The template parameter that the compiler cannot deduce for a type, in small letters as its field: "law". Empty where
/// it says no such thing.
std::string field_not_deduced(const ErrorGroup& group);

/// Whether the innermost list around a place has this field.
bool names_field(const Diagnostic& place, const std::string& field);

/// `grid(3, 2, {.stifness = 1 * MN / m})`: "no matching function for call", with a note for each overload.
std::optional<Explanation> list_in_overloaded_call(const ErrorGroup& group, const std::filesystem::path& root);

/// `.isolation = {.yield_force = 1 * MN}`: "designated initializers cannot be used with a non-aggregate type". Also
/// `Moat{.law = {.stiffness = ...}}`, where the compiler cannot deduce the type of the law.
std::optional<Explanation> list_without_type(const ErrorGroup& group, const std::filesystem::path& root);

/// `.floor_mass = {500 * tonne, 500 * kN}`: the compiler says that the braces fit no PerStorey<Mass>, and points at the
/// end of the struct.
std::optional<Explanation> list_for_storeys(const ErrorGroup& group, const std::filesystem::path& root);

}  // namespace moat::launcher
