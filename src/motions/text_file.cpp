#include "motions/text_file.hpp"

#include <fstream>
#include <ios>
#include <iterator>
#include <system_error>

#include "base/error.hpp"

namespace moat {

std::string read_text_file(const std::filesystem::path& path) {
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) refuse_file(path, "there is no such file. Check the path.");
  if (std::filesystem::is_directory(status)) refuse_file(path, "this is a folder. Give one file in it.");
  std::ifstream file{path, std::ios::binary};
  if (!file) refuse_file(path, "the file cannot be opened. Check that you may read it.");
  std::string content{std::istreambuf_iterator<char>{file}, std::istreambuf_iterator<char>{}};
  if (file.bad()) refuse_file(path, "the file cannot be read to its end.");
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (content.starts_with(byte_order_mark)) content.erase(0, byte_order_mark.size());
  return content;
}

bool LineReader::next(std::string_view& line) {
  if (rest_.empty()) return false;
  const std::size_t end = rest_.find('\n');
  line = rest_.substr(0, end);
  rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
  if (line.ends_with('\r')) line.remove_suffix(1);
  ++line_number_;
  return true;
}

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string upper_case(std::string_view text) {
  std::string result{text};
  for (char& letter : result)
    if (letter >= 'a' && letter <= 'z') letter = static_cast<char>(letter - 'a' + 'A');
  return result;
}

std::string quoted(std::string_view text) {
  constexpr std::size_t longest = 80;
  std::string result{"\""};
  for (const char letter : text.substr(0, longest)) result += letter >= ' ' && letter != '\x7F' ? letter : '?';
  return result + (text.size() > longest ? "...\"" : "\"");
}

void refuse_file(const std::filesystem::path& path, const std::string& problem) {
  throw FileError{path.string() + ": " + problem};
}

void refuse_line(const std::filesystem::path& path, std::size_t line_number, const std::string& problem) {
  throw FileError{path.string() + ", line " + std::to_string(line_number) + ": " + problem};
}

}  // namespace moat
