#include "base/text/text_file.hpp"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <ios>
#include <system_error>

#include "base/error.hpp"
#include "base/sha256.hpp"

namespace moat {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_sign(char c) { return c == '+' || c == '-'; }

std::size_t skip_digits(std::string_view text, std::size_t position) {
  while (position < text.size() && is_digit(text[position])) ++position;
  return position;
}

ScannedNumber refused(const char* problem) {
  ScannedNumber result;
  result.problem = problem;
  return result;
}

}  // namespace

TextFile read_text_file(const std::filesystem::path& path) {
  constexpr std::uintmax_t most_bytes = 1'000'000'000;
  std::error_code failure;
  const std::filesystem::file_status status = std::filesystem::status(path, failure);
  if (!std::filesystem::exists(status)) refuse_file(path, "there is no such file. Check the path.");
  if (std::filesystem::is_directory(status)) refuse_file(path, "this is a folder. Give one file in it.");
  // A device or a pipe may never end.
  if (!std::filesystem::is_regular_file(status))
    refuse_file(path, "this is a device or a pipe, not a regular file. Save its content as a file.");
  const std::uintmax_t size = std::filesystem::file_size(path, failure);
  if (!failure && size > most_bytes) refuse_file(path, "the file has more than 1 GB. Give one record, or one table.");
  std::ifstream file{path, std::ios::binary};
  if (!file) refuse_file(path, "the file cannot be opened. Check that you may read it.");
  TextFile read{path, {}, {}};
  read.text.resize(failure ? 0 : size);
  file.read(read.text.data(), static_cast<std::streamsize>(read.text.size()));
  // Files in /proc say that they are empty.
  read.text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad() || read.text.size() != size) refuse_file(path, "the file cannot be read to its end.");
  read.sha256 = sha256_of(read.text);
  note_file_read(file_of(read));
  const std::string_view beginning = std::string_view{read.text}.substr(0, 1000);
  const auto is_control = [](char c) { return (c >= 0 && c < '\t') || (c > '\r' && c < ' '); };
  // A damaged text may hold a few. Compressed data are a tenth of them; an archive of texts begins with many.
  if (std::ranges::count_if(beginning, is_control) > 2 + std::ssize(beginning) / 100)
    refuse_file(path,
                "this is no plain text: it holds many control characters. If the file is compressed or an archive, "
                "unpack it (gunzip, unzip, tar) and give the file in it; else save it as text in UTF-8.");
  constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";
  if (read.text.starts_with(byte_order_mark)) read.text.erase(0, byte_order_mark.size());
  // Old Macintosh programs end lines with a carriage return alone.
  if (read.text.find('\n') == std::string::npos) std::ranges::replace(read.text, '\r', '\n');
  return read;
}

FileRead file_of(const TextFile& file) {
  std::error_code failure;
  const std::filesystem::path absolute = std::filesystem::absolute(file.path, failure);
  return {(failure ? file.path : absolute.lexically_normal()).string(), file.sha256};
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

void LineReader::refuse(const std::string& problem) const { refuse_line(file_->path, line_number_, problem); }

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

std::string_view without_leading_blanks(std::string_view text) {
  return text.substr(std::min(text.find_first_not_of(" \t"), text.size()));
}

bool take(std::string_view& text, std::string_view word) {
  const std::string_view rest = without_leading_blanks(text);
  if (!rest.starts_with(word)) return false;
  text = rest.substr(word.size());
  return true;
}

bool take_behind(std::string_view& text, std::string_view word) {
  const std::size_t at = text.find(word);
  if (at != std::string_view::npos) text.remove_prefix(at + word.size());
  return at != std::string_view::npos;
}

std::optional<std::size_t> take_whole_number(std::string_view& text) {
  const std::string_view rest = without_leading_blanks(text);
  std::size_t number = 0;
  const auto [end, failure] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
  if (failure != std::errc{}) return std::nullopt;
  text = rest.substr(static_cast<std::size_t>(end - rest.data()));
  return number;
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

ScannedNumber scan_number(std::string_view text) {
  std::size_t position = !text.empty() && is_sign(text[0]) ? 1 : 0;
  const std::size_t mantissa = position;
  position = skip_digits(text, position);
  std::size_t digits = position - mantissa;
  if (position < text.size() && text[position] == '.') {
    const std::size_t decimals = ++position;
    position = skip_digits(text, decimals);
    digits += position - decimals;
  }
  if (digits == 0) return refused("is not a number");

  std::size_t exponent_mark = std::string_view::npos;
  if (position < text.size() && std::string_view{"EeDd"}.find(text[position]) != std::string_view::npos) {
    exponent_mark = position++;
    if (position < text.size() && is_sign(text[position])) ++position;
    const std::size_t exponent = position;
    position = skip_digits(text, exponent);
    if (position == exponent) return refused("has no digits in its exponent");
    if (position - exponent > 3) return refused("has more than three digits in its exponent");
  }

  // std::from_chars reads neither a leading plus nor the exponent D of Fortran's double precision.
  std::string plain{text.substr(mantissa, position - mantissa)};
  if (exponent_mark != std::string_view::npos) plain[exponent_mark - mantissa] = 'e';
  ScannedNumber result;
  const auto [end, failure] = std::from_chars(plain.data(), plain.data() + plain.size(), result.value);
  if (failure == std::errc::result_out_of_range) return refused("is too large or too small for a double");
  if (failure != std::errc{} || end != plain.data() + plain.size()) return refused("is not a number");
  if (text[0] == '-') result.value = -result.value;
  result.length = position;
  result.has_exponent = exponent_mark != std::string_view::npos;
  return result;
}

ScannedNumber parse_number(std::string_view text) {
  const ScannedNumber result = scan_number(text);
  if (!result.problem && result.length != text.size()) return refused("is not a number");
  return result;
}

void refuse_file(const std::filesystem::path& path, const std::string& problem) {
  throw FileError{path.string() + ": " + problem};
}

void refuse_line(const std::filesystem::path& path, std::size_t line_number, const std::string& problem) {
  throw FileError{path.string() + ", line " + std::to_string(line_number) + ": " + problem};
}

}  // namespace moat
