// Lists in braces with named fields in a script, compared with the structs in moat's headers.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace moat::launcher {

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
