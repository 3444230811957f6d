// Writing whole files, with an error that names the file and the reason, and names of files made of titles.
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>

namespace moat {

/// Follows the name of a file that is not written completely; the number of the process follows it.
inline constexpr const char* unfinished_ending = ".unfinished-";

/// Creates or replaces `path` with `contents`. The file is written under another name beside it and renamed at the
/// end: a write that fails leaves the old file, and a link is replaced, not followed. Throws FileError naming the file
/// and the reason.
void write_file(const std::filesystem::path& path, std::string_view contents);
/// Writes in the same way, without all contents in memory.
void write_file(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);
/// Writes in the same way; `write` writes the file of the name that it is given, and returns the errno where it fails,
/// else 0.
void write_file(const std::filesystem::path& path, const std::function<int(const std::string& unfinished)>& write);

/// A title with small letters, digits and underscores alone, at most 100: "Impacts over gap" -> "impacts_over_gap".
/// "chart" for a title without a letter or digit of ASCII.
std::string file_name_of(std::string_view title);

}  // namespace moat
