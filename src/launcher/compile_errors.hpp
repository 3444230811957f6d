// Errors of the compiler in a script: five sentences for the writer of the script, before the words of GCC.
#pragma once

#include <filesystem>
#include <string>

namespace moat::launcher {

/// GCC's first error as it is, with a sentence before it where one is certain: on a wrong dimension, a missing field, a
/// field that does not exist, the order of fields, or a missing semicolon. `output` is in English, with columns in
/// bytes; `root` holds the headers of the library.
std::string explained(const std::string& output, const std::filesystem::path& root);

}  // namespace moat::launcher
