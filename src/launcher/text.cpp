#include "launcher/text.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <sstream>
#include <string_view>
#include <utility>

#include "launcher/stop.hpp"

namespace moat::launcher {

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream{file, std::ios::binary}.rdbuf();
  return std::move(text).str();
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream{file, std::ios::binary};
  stream << text << std::flush;
  if (!stream) throw Stop{exit_failed, file.string() + " cannot be written: " + std::strerror(errno)};
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream{text};
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string joined(const std::vector<std::string>& words, const std::string& separator) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

std::string replaced(const std::string& text, const std::string& from, const std::string& to) {
  std::string result;
  std::size_t begin = 0;
  for (std::size_t at = 0; (at = text.find(from, begin)) != std::string::npos; begin = at + from.size())
    result.append(text, begin, at - begin).append(to);
  return result.append(text, begin);
}

std::string with_short_lines(std::string text) {
  constexpr std::string_view gap = " ... ";
  constexpr std::size_t kept = (longest_line - gap.size()) / 2;
  for (std::size_t begin = 0, end = 0; begin < text.size(); begin = end + 1) {
    end = std::min(text.find('\n', begin), text.size());
    if (end - begin <= longest_line) continue;
    text.replace(begin + kept, end - begin - 2 * kept, gap);
    end = begin + 2 * kept + gap.size();
  }
  return text;
}

std::string replaced(const std::string& text, const std::regex& pattern, const char* to) {
  return text.size() <= longest_line ? std::regex_replace(text, pattern, to) : text;
}

std::string lower_case(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool has_word(const std::string& text, const std::string& word) {
  const auto in_word = [&](std::size_t at) {
    return at < text.size() && (std::isalnum(static_cast<unsigned char>(text[at])) != 0 || text[at] == '_');
  };
  for (std::size_t at = 0; !word.empty() && (at = text.find(word, at)) != std::string::npos; ++at)
    if ((at == 0 || !in_word(at - 1)) && !in_word(at + word.size())) return true;
  return false;
}

std::string shell_quoted(const std::string& word) {
  const bool plain = !word.empty() && word.find_first_not_of(
                                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                          "0123456789_-+=.,/:@%") == std::string::npos;
  return plain ? word : "'" + replaced(word, "'", "'\\''") + "'";
}

std::string regex_quoted(const std::string& text) {
  std::string quoted;
  for (const char letter : text) {
    if (std::string_view{R"(\^$.|?*+()[]{})"}.find(letter) != std::string_view::npos) quoted += '\\';
    quoted += letter;
  }
  return quoted;
}

}  // namespace moat::launcher
