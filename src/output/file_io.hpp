// Writing whole files, with an error that says which file and why.
#pragma once

#include <filesystem>
#include <string_view>

namespace moat {

/// Creates or replaces `path` with `contents`. Throws FileError naming the file and the reason.
void write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace moat
