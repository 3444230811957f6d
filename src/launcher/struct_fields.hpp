// The fields of a struct, read from moat's headers.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

/// `Required<Length> clearance;`
struct Field {
  std::string type, name;
};

/// The fields of `name` in their order; empty if no header under the checkout declares such a struct. `name` may also
/// be declared by `using NAME = TEMPLATE<...>;`.
std::vector<Field> declared_fields(const std::string& name, const std::filesystem::path& root);

/// Their names.
std::vector<std::string> fields_of(const std::string& name, const std::filesystem::path& root);

/// The name that scripts use for a type. "Moat" for "Moat<Hertz>"; "HertzDamp" for "ViscousHertzLaw<HertzDampFactor>",
/// if a header has the line `using HertzDamp = ViscousHertzLaw<HertzDampFactor>;`.
std::string name_in_scripts(const std::string& type, const std::filesystem::path& root);

/// The structs, classes and other names of types in the headers.
std::vector<std::string> names_of_types(const std::filesystem::path& root);

/// "ImpactLaw" for "Moat", with `template <ImpactLaw Law>` in front of its struct; empty where there is none.
std::string concept_of(const std::string& type, const std::filesystem::path& root);

/// Whether a header has this word.
bool is_in_headers(const std::string& word, const std::filesystem::path& root);

}  // namespace moat::launcher
