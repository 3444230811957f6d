// Small tools for text and text files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <regex>
#include <string>
#include <vector>

namespace moat::launcher {

/// The file's text; empty where it cannot be read.
std::string text_of(const std::filesystem::path& file);

/// Throws Stop with the file's name where it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

std::vector<std::string> lines_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator = " ");

std::string replaced(const std::string& text, const std::string& from, const std::string& to);

/// For a screen and for std::regex, which calls itself for every letter and exhausts the stack on a long line.
inline constexpr std::size_t longest_line = 1000;

/// Lines above longest_line without their middle, which " ... " replaces.
std::string with_short_lines(std::string text);

/// Whether the whole text matches; never above longest_line. The arguments are those of std::regex_match.
template <class... Arguments>
bool matches(const std::string& text, Arguments&... arguments) {
  return text.size() <= longest_line && std::regex_match(text, arguments...);
}

/// With every match replaced; above longest_line the text as it is.
std::string replaced(const std::string& text, const std::regex& pattern, const char* to);

std::string lower_case(std::string text);

/// Whether the text holds this word as a whole.
bool has_word(const std::string& text, const std::string& word);

/// As a word of a shell command: in quotes where it needs some.
std::string shell_quoted(const std::string& word);

/// As a regular expression that matches this text only.
std::string regex_quoted(const std::string& text);

}  // namespace moat::launcher
