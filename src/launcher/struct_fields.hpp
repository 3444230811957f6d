// The fields of a struct, read from moat's headers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

/// Names of the fields of `name` in their order; empty if no header under the checkout declares such a struct. `name`
/// may also be declared by `using NAME = TEMPLATE<...>;`.
std::vector<std::string> fields_of(const std::string& name, const std::filesystem::path& root);

/// The name that scripts use for a type. "Moat" for "Moat<Hertz>"; "HertzDamp" for "ViscousHertzLaw<HertzDampFactor>",
/// if a header has the line `using HertzDamp = ViscousHertzLaw<HertzDampFactor>;`.
std::string name_in_scripts(const std::string& type, const std::filesystem::path& root);

}  // namespace moat::launcher
