// Writing whole files, with an error that names the file and the reason.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace moat {

/// Creates or replaces `path` with `contents`. The file is written under another name beside it and renamed at the
/// end: a write that fails leaves the old file, and a link is replaced, not followed. Throws FileError naming the file
/// and the reason.
void write_file(const std::filesystem::path& path, std::string_view contents);
/// Writes in the same way, without all contents in memory; `more` gives one piece after another, and an empty one at
/// the end.
void write_file(const std::filesystem::path& path, const std::function<std::string_view()>& more);
/// Writes in the same way; `write` writes the file of the name that it is given, and returns the errno where it fails,
/// else 0.
void write_file(const std::filesystem::path& path, const std::function<int(const std::string& unfinished)>& write);

}  // namespace moat
