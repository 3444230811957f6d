#include "base/text/terminal.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <new>

namespace moat {
namespace {

// Before main(): files that a program opens would take the places of closed standard streams, and their texts.
[[maybe_unused]] const bool standard_streams_are_open = [] {
  int file = 0;
  while (file >= 0 && file <= STDERR_FILENO) file = open("/dev/null", O_RDWR);
  return close(file) == 0;
}();

}  // namespace

std::string printable(std::string_view text) {
  constexpr std::string_view digits = "0123456789abcdef";
  std::string shown;
  unsigned before = 0;
  for (const char byte : text) {
    const unsigned code = static_cast<unsigned char>(byte);
    // U+0080 to U+009F are the bytes C2 80 to C2 9F. Some terminals obey the second byte alone, too.
    const bool is_second = code >= 0x80 && code < 0xA0 && (before < 0x80 || before == 0xC2);
    if (is_second && before == 0xC2) shown.pop_back();
    if (is_second || code == 0x7F || (code < 0x20 && byte != '\n'))
      shown.append("\\u00").append({digits[code / 16], digits[code % 16]});
    else
      shown += byte;
    before = code;
    // Three bytes that turn the direction of all text behind them: U+202A to U+202E, U+2066 to U+2069.
    const std::string_view last = std::string_view{shown}.substr(shown.size() < 3 ? 0 : shown.size() - 3);
    const bool overrides = last.starts_with("\xE2\x80") && code >= 0xAA && code <= 0xAE;
    if (!overrides && !(last.starts_with("\xE2\x81") && code >= 0xA6 && code <= 0xA9)) continue;
    shown.resize(shown.size() - 3);
    shown.append(overrides ? "\\u202" : "\\u206") += digits[code % 16];
  }
  return shown;
}

std::ostream& print_text(std::ostream& to, std::string_view text) { return to << printable(text) << std::flush; }

std::string shell_word(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:/@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? std::string{"'\\''"} : std::string{c};
  return text + "'";
}

const char* reason_of(const std::exception& error) {
  if (dynamic_cast<const std::bad_alloc*>(&error) == nullptr) return error.what();
  return "There is not enough memory. Free some, or compute a smaller model or a shorter time.";
}

}  // namespace moat
