// Writing whole files, with an error that names the file and the reason.
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>

namespace moat {

/// Creates or replaces `path` with `contents`. The file is written under another name beside it and renamed at the
/// end: a write that fails leaves the old file, and a link is replaced, not followed. Throws FileError naming the file
/// and the reason.
void write_file(const std::filesystem::path& path, std::string_view contents);
/// The same; the contents are the pieces one after another.
void write_file(const std::filesystem::path& path, std::span<const std::string_view> pieces);
/// The same, without all pieces in memory; `more` gives one after another, and an empty one at the end.
void write_file(const std::filesystem::path& path, const std::function<std::string_view()>& more);

/// The same in half the time, for a file that nobody looks for before another file names it: it is written in its
/// place, and a file of its name is removed first. A write that fails leaves nothing.
void write_unlisted_file(const std::filesystem::path& path, std::span<const std::string_view> pieces);

}  // namespace moat
