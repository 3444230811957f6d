// Errors of the compiler in a script: five sentences for the writer of the script, before the words of GCC.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace moat::launcher {

/// GCC's first error as it is, with a sentence before it where one is certain: on a wrong dimension, a missing field, a
/// field that does not exist, the order of fields, or a missing semicolon. `output` is in English, with columns in
/// bytes; `root` holds the headers of the library.
std::string explained(const std::string& output, const std::filesystem::path& root);

/// A sentence on a place in a source.
struct Mistake {
  std::size_t offset;
  std::string sentence;
};

/// The source with blanks for comments and the insides of texts; empty for raw texts, and for brackets that do not fit.
std::string code_of(const std::string& source);

/// The first field in the lists around an offset that its struct in the headers under `root` does not have, that stands
/// in the wrong place, whose value has another dimension, or that is missing. At the parenthesis of a call: in the one
/// list among its arguments, of the type `argument`. Nothing where any of this cannot be read for certain.
std::optional<Mistake> mistake_in_fields(const std::string& source, std::size_t offset, const std::string& argument,
                                         const std::filesystem::path& root);

}  // namespace moat::launcher
