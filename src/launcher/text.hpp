// Small tools for text and files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

/// The file's text; empty where it cannot be read.
std::string text_of(const std::filesystem::path& file);

/// Throws Stop with the file's name where it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

/// When the contents or the name of a file changed, in ns; 0 where there is none. Unlike the time of writing it cannot
/// be set back: a file that was copied, moved or unpacked with an old date counts as new. A folder changes with every
/// file that is made, renamed or removed in it.
std::int64_t time_of_change(const std::filesystem::path& file);

std::vector<std::string> lines_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator = " ");

std::string replaced(const std::string& text, const std::string& from, const std::string& to);

/// Without blanks at both ends.
std::string trimmed(const std::string& text);

/// For a screen and for std::regex, which calls itself for every letter and exhausts the stack on a long line.
inline constexpr std::size_t longest_line = 1000;

/// Lines above longest_line without their middle, which " ... " replaces.
std::string with_short_lines(std::string text);

}  // namespace moat::launcher
