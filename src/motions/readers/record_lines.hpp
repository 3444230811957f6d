// Lines, columns and numbers of record files. Shared by the readers of all layouts.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "base/text/text_file.hpp"

namespace moat {

/// Equal fields, such as (8F10.5) or (10I8).
struct FortranFormat {
  std::size_t per_line = 1;
  std::size_t width = 0;  ///< of one field, characters
  bool whole = false;     ///< I: whole numbers
};

/// The format at the beginning of a text, "(8F10.5)" or "4F10.3", in capitals or small letters; nothing for others than
/// F, E, D, G and I with a width of 1 to 40 and 1 to 200 fields on a line.
std::optional<FortranFormat> fortran_format(std::string_view text);

/// A number and one unit of the last digit with which it is printed.
struct PrintedNumber {
  double value = 0.0, digit = 0.0;  ///< Both, in the unit of the text.
};

/// The first number in a text; nothing where there is none.
std::optional<PrintedNumber> first_number(std::string_view text);
/// All numbers in a text such as a date, where "-" and "/" separate.
std::vector<double> numbers_in(std::string_view text);
/// Seconds since 1970 of year, month, day, hour, minute and second, in this order; nothing for another number of them.
std::optional<double> utc_seconds(const std::vector<double>& date);

/// The lines of a file one after the other; each part of a layout takes its own.
class RecordLines {
 public:
  /// The file must outlive it.
  explicit RecordLines(const TextFile& file) : file_{&file}, lines_{file} {}

  /// Throws FileError at the end of the file, where `expected` is missing.
  std::string_view line(const std::string& expected);
  /// The next line that is not blank; false at the end.
  bool next_filled(std::string_view& line);
  /// The next `count` lines, without blanks at their ends.
  std::vector<std::string> text(std::size_t count, const std::string& what);
  void skip(std::size_t count, const std::string& what);  ///< Passes over lines.
  /// `count` numbers in the columns of a format.
  std::vector<double> numbers(std::size_t count, const FortranFormat& format, const std::string& what);
  /// Throws FileError naming the line read last.
  [[noreturn]] void refuse(const std::string& problem) const { lines_.refuse(problem); }
  [[nodiscard]] std::size_t line_number() const {
    return lines_.line_number();
  }  ///< Counts from 1; the line read last.

 private:
  const TextFile* file_;
  LineReader lines_;
};

/// Values of a header by their keys, in capitals.
class HeaderKeys {
 public:
  /// The file must outlive it.
  explicit HeaderKeys(const TextFile& file) : file_{&file} {}

  /// Keeps the value of a key.
  void set(std::string_view key, std::string_view value) {
    values_.insert_or_assign(upper_case(key), std::string{value});
  }
  /// Empty where there is none.
  [[nodiscard]] std::string find(const std::string& key) const;
  /// These throw FileError where the value is missing or not allowed.
  [[nodiscard]] std::string value(const std::string& key) const;
  /// A number > 0, with or without the unit behind it.
  [[nodiscard]] double positive(const std::string& key, const std::string& unit) const;
  [[nodiscard]] std::size_t count(const std::string& key) const;  ///< A whole number >= 2.

 private:
  const TextFile* file_;
  std::map<std::string, std::string> values_{};
};

/// A time in a line of a file, s.
struct PrintedTime {
  PrintedNumber time{};  ///< s
  std::size_t line = 0;  ///< From 1.
};

/// The step of at least two times that grow evenly, s: `stated`, or the one at which all times are printed, each within
/// half a unit of its last digit, 1e-6 of a step, or the accuracy of single precision. Throws FileError naming the
/// first line that deviates, and by how much.
double even_step(const std::filesystem::path& path, const std::vector<PrintedTime>& times,
                 std::optional<double> stated);

}  // namespace moat
