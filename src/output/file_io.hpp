// Writing whole files, with an error that names the file and the reason.
#pragma once

#include <filesystem>
#include <string_view>

namespace moat {

/// Creates or replaces `path` with `contents`. The file is written under another name beside it and renamed at the
/// end: a write that fails leaves the old file, and a link is replaced, not followed. Throws FileError naming the file
/// and the reason.
void write_file(const std::filesystem::path& path, std::string_view contents);

}  // namespace moat
