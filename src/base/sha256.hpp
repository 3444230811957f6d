// SHA-256, by which a file is known again.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace moat {

/// 64 lower-case hexadecimal digits.
std::string sha256_of(std::string_view bytes);

/// Returns this hash in base64, as pages name the scripts that may run.
std::string sha256_in_base64(std::string_view bytes);

/// Returns the hash of a file's content; nothing if it cannot be read.
std::optional<std::string> sha256_of_file(const std::filesystem::path& path);

}  // namespace moat
