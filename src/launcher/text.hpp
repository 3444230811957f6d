// Small tools for text and text files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace moat::launcher {

/// The file's text; empty where it cannot be read.
std::string text_of(const std::filesystem::path& file);

/// Throws Stop with the file's name where it cannot be written.
void write_text(const std::filesystem::path& file, const std::string& text);

std::vector<std::string> lines_of(const std::string& text);

std::string joined(const std::vector<std::string>& words, const std::string& separator = " ");

std::string replaced(std::string text, const std::string& from, const std::string& to);

std::string lower_case(std::string text);

/// Whether the text holds this word as a whole.
bool has_word(const std::string& text, const std::string& word);

/// As a word of a shell command: in quotes where it needs some.
std::string shell_quoted(const std::string& word);

/// As a regular expression that matches this text only.
std::string regex_quoted(const std::string& text);

}  // namespace moat::launcher
