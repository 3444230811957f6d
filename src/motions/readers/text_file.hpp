// Text files: their content and their lines. Shared by the readers of ground motions.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "motions/ground_motion.hpp"

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

/// As a GroundMotion remembers it.
MotionFile file_of(const TextFile& file);

/// Walks through the lines of a text. A line ends with \n or \r\n; neither is part of it.
class LineReader {
 public:
  explicit LineReader(std::string_view text) : rest_{text} {}

  /// Puts the next line into `line`; false at the end of the text.
  bool next(std::string_view& line);
  /// Number of the line read last, counted from 1.
  [[nodiscard]] std::size_t line_number() const { return line_number_; }

 private:
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

/// Throws FileError with the message "path: problem".
[[noreturn]] void refuse_file(const std::filesystem::path& path, const std::string& problem);
/// Throws FileError with the message "path, line 12: problem".
[[noreturn]] void refuse_line(const std::filesystem::path& path, std::size_t line_number, const std::string& problem);

}  // namespace moat
