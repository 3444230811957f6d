// The sentence about an error of the compiler, and its parts.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "launcher/compiler_output.hpp"
#include "launcher/designated_list.hpp"

namespace moat::launcher {

/// A sentence, and the line of the source that it is about.
struct Explanation {
  std::string sentence, file;
  int line;
  std::string snippet;
};

/// The line of the source and its underlining, as the compiler gives them.
std::string snippet_of(const Diagnostic& place);

/// At the place of the compiler.
Explanation at(const Diagnostic& place, const std::string& sentence);

/// At the field, where the source names it: the compiler points at the end of the braces.
Explanation at_field(const Diagnostic& place, const std::string& field, const std::string& sentence);
Explanation at_field(const Diagnostic& place, const std::string& source, const NamedField& field,
                     const std::string& sentence);

/// At an offset of the source of `place`, with `length` marks.
Explanation at_offset(const Diagnostic& place, const std::string& source, std::size_t offset, std::size_t length,
                      const std::string& sentence);

/// "moat::Moat<moat::Hertz>" -> "Moat"
std::string plain_name(const std::string& type, const std::filesystem::path& root);

/// "'moat::Stiffness' {aka 'moat::Quantity<1, 0, -2>'}" -> "'moat::Stiffness'"
std::string without_second_names(const std::string& text);

/// "a mass [kg]" for "moat::Required<moat::Mass>", "a whole number" for "int": the value that a type needs.
std::string needed_in_words(const std::string& type);

/// "; give it a unit, as in 1.3 * s", for a value that must be `needed`: "a time [s]".
std::string unit_hint(const std::string& needed, const std::string& value);

/// "; write 5" for "5.0"; empty where the value is not whole.
std::string whole_number_hint(const std::string& value);

/// "Moat has no field clearence; did you mean clearance?" `fields` are those of the type.
std::string no_such_field(const std::string& type, const std::string& field, const std::vector<std::string>& fields);

/// "field name of Node stands in the wrong place; the order is name, mass"
std::string wrong_place(const std::string& type, const std::string& field, const std::vector<std::string>& fields);

}  // namespace moat::launcher
