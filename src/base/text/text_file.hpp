// Text files: their content, lines, words and numbers. Shared by all readers of files.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "base/files_read.hpp"

namespace moat {

/// The whole content of a file.
struct TextFile {
  std::filesystem::path path;
  std::string text;    ///< without a UTF-8 byte order mark; lines end with \n or \r\n
  std::string sha256;  ///< of the file as it is
};

/// Notes the file (base/files_read.hpp). Throws FileError if it cannot be read, is no regular file, has more than
/// 1 GB, or is compressed or otherwise no text.
TextFile read_text_file(const std::filesystem::path& path);

/// Returns the file as reports list it.
FileRead file_of(const TextFile& file);

/// Walks through the lines of a file. A line ends with \n or \r\n; neither is part of it.
class LineReader {
 public:
  /// The file must outlive it.
  explicit LineReader(const TextFile& file) : file_{&file}, rest_{file.text} {}

  /// Puts the next line into `line`; false at the end of the text.
  bool next(std::string_view& line);
  /// Number of the line read last, counted from 1.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }
  /// Throws as refuse_line(), for the line read last.
  [[noreturn]] void refuse(const std::string& problem) const;

 private:
  const TextFile* file_;
  std::string_view rest_;
  std::size_t line_number_ = 0;
};

/// Without blanks, tabs and carriage returns at both ends.
std::string_view trimmed(std::string_view text);
/// Without blanks and tabs at the beginning.
std::string_view without_leading_blanks(std::string_view text);
/// Moves `text` behind blanks and `word`; false where something else stands there.
bool take(std::string_view& text, std::string_view word);
/// Moves `text` behind the next `word`; false where there is none.
bool take_behind(std::string_view& text, std::string_view word);
/// Moves `text` behind blanks and a whole number; nothing where there is none.
std::optional<std::size_t> take_whole_number(std::string_view& text);
/// In capitals; only ASCII letters are changed.
std::string upper_case(std::string_view text);
/// In quotes for a message, cut to a readable length.
std::string quoted(std::string_view text);
/// Quotes likewise. Without it a std::string would go to std::quoted.
inline std::string quoted(const std::string& text) { return quoted(std::string_view{text}); }

/// A number at the beginning of a text.
struct ScannedNumber {
  double value = 0.0;
  std::size_t length = 0;         ///< characters read
  bool has_exponent = false;      ///< it ended with an exponent
  const char* problem = nullptr;  ///< why there is no number; null if there is one
};

/// Reads one decimal number from the beginning of `text`: optional sign, digits with an optional point, optional
/// exponent of up to three digits after E or D ("-.1234E-03", "0.1D-02", "12", "+5."). Never skips blanks. "nan",
/// "inf" and numbers too large or too small for a double are problems.
ScannedNumber scan_number(std::string_view text);

/// Like scan_number, but the number must be all of `text`.
ScannedNumber parse_number(std::string_view text);

/// Throws FileError with the message "path: problem".
[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& problem);
/// Throws FileError with the message "path, line 12: problem".
[[noreturn]] void refuse_line(const std::filesystem::path& path, std::size_t line_number, const std::string& problem);

}  // namespace moat
