#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.hpp"
#include "base/text/text_file.hpp"
#include "base/units.hpp"
#include "motions/readers/record_formats.hpp"

namespace moat {
namespace {

constexpr double unknown = -999.0;
// Numbers of values in the headers, from 1.
constexpr std::size_t quantity_value = 2, unit_value = 3, interval_value = 62, length_value = 63;
constexpr double acceleration_quantity = 1.0;
constexpr std::string_view first_words = "(FORMAT V";

struct Unit {
  std::size_t number;  // in the format's table of units
  double si;           // m/s^2
};
constexpr std::array units_of_acceleration{Unit{2, standard_gravity}, Unit{4, 0.01}, Unit{10, 0.01},
                                           Unit{11, 1e-3 * standard_gravity}};
constexpr const char* known_units = "02 (g), 04 (cm/s^2), 10 (gal) and 11 (mg)";

/// A format of equal fields, such as (8F10.5) or (10I8).
struct FortranFormat {
  std::size_t per_line = 1;
  std::size_t width = 0;  ///< of one field, characters
  bool whole = false;     ///< I: whole numbers
};

/// The format in "... Format= (8F10.5)", in capitals or small letters; nothing where there is none that is known. Known
/// are F, E, D, G and I with a width of 1 to 40 and 1 to 200 fields on a line.
std::optional<FortranFormat> find_fortran_format(std::string_view line) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  rest.remove_prefix(std::min(rest.rfind("FORMAT"), rest.size()));
  if (!take(rest, "FORMAT") || !take(rest, "=") || !take(rest, "(")) return std::nullopt;
  FortranFormat found{.per_line = take_whole_number(rest).value_or(1)};
  rest = without_leading_blanks(rest);
  const std::string_view kind = rest.substr(0, 1);
  rest.remove_prefix(kind.size());
  // A blank inside is a digit that was lost.
  if (!rest.starts_with(' ')) found.width = take_whole_number(rest).value_or(0);
  const bool has_decimals = rest.starts_with('.');
  if (has_decimals) rest.remove_prefix(1);
  if ((has_decimals && !take_whole_number(rest)) || !take(rest, ")")) return std::nullopt;
  found.whole = kind == "I";
  constexpr std::size_t most_fields = 200, widest = 40;
  // A number with a fraction needs its decimals in the format: (8F10) is none.
  if (found.whole == has_decimals || std::string_view{"FEDGI"}.find(kind) == std::string_view::npos)
    return std::nullopt;
  if (found.per_line < 1 || found.per_line > most_fields || found.width < 1 || found.width > widest)
    return std::nullopt;
  return found;
}

/// The fields of a line, without blanks around them: as many as the line has columns for, up to `most`.
std::vector<std::string_view> fields_of(std::string_view line, const FortranFormat& format, std::size_t most) {
  line = line.substr(0, line.find_last_not_of(" \t\r") + 1);
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin < line.size() && fields.size() < most; begin += format.width)
    fields.push_back(trimmed(line.substr(begin, format.width)));
  return fields;
}

/// The lines of the file one after the other; each part of the format takes its own.
class CosmosFile {
 public:
  explicit CosmosFile(const TextFile& file) : file_{&file}, lines_{file} {}

  /// Throws FileError at the end of the file, where `expected` is missing.
  std::string_view line(const std::string& expected) {
    std::string_view text;
    if (!lines_.next(text))
      refuse_file(file_->path, "the file ends before " + expected + ". It was cut; fetch it again.");
    return text;
  }
  bool next(std::string_view& text) { return lines_.next(text); }
  [[noreturn]] void refuse(const std::string& problem) const { lines_.refuse(problem); }

  /// `count` numbers in the columns of a format.
  std::vector<double> numbers(std::size_t count, const FortranFormat& format, const std::string& what) {
    std::vector<double> values;
    // A wrong count must not reserve more than the file can hold.
    values.reserve(std::min(count, file_->text.size()));
    while (values.size() < count) {
      const std::size_t here = std::min(format.per_line, count - values.size());
      const std::string_view text = line("the last of " + std::to_string(count) + " values of " + what);
      const std::vector<std::string_view> fields = fields_of(text, format, format.per_line + 1);
      if (fields.size() != here)
        refuse("expected " + std::to_string(here) + " values of " + what + " in columns of " +
               std::to_string(format.width) + " characters, but found " + std::to_string(fields.size()) + " in " +
               quoted(text) + ". The number of values or the format in the line above them is wrong.");
      for (const std::string_view field : fields) values.push_back(number(field, format));
    }
    return values;
  }

 private:
  double number(std::string_view field, const FortranFormat& format) const {
    const ScannedNumber scanned = parse_number(field);
    if (scanned.problem) refuse(quoted(field) + " " + scanned.problem + ".");
    // Fortran would put a point into the digits.
    if (!format.whole && field.find('.') == std::string_view::npos)
      refuse(quoted(field) + " has no decimal point, and the format is one of numbers with decimals.");
    return scanned.value;
  }

  const TextFile* file_;
  LineReader lines_;
};

/// The count in front of a line such as " 100 Integer-header values follow on  10 lines, Format= (10I8)". `words` are
/// in capitals; letters of `between` may stand before them.
std::optional<std::size_t> count_before(std::string_view line, std::string_view words, std::string_view between = " ") {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  const std::optional<std::size_t> count = take_whole_number(rest);
  const std::size_t place = rest.find(words);
  const bool fits = rest.starts_with(' ') && place < rest.size() && rest.find_first_not_of(between) >= place;
  return fits ? count : std::nullopt;
}

FortranFormat format_in(CosmosFile& file, std::string_view line) {
  const std::optional<FortranFormat> format = find_fortran_format(line);
  if (!format)
    file.refuse("expected a Fortran format such as Format=(8F10.5) at the end of this line, but found " +
                quoted(trimmed(line)) + ".");
  return *format;
}

std::vector<double> header(CosmosFile& file, const std::string& kind, std::size_t needed) {
  const std::string what = "the " + kind + " header";
  const std::string_view line = file.line(what);
  const std::optional<std::size_t> count = count_before(line, upper_case(kind) + "-HEADER VALUES");
  if (!count)
    file.refuse("expected the line \" 100 " + kind + "-header values follow on ...\", but found " +
                quoted(trimmed(line)) + ". The number of text lines in the first line may be wrong.");
  if (*count < needed)
    file.refuse(what + " has " + std::to_string(*count) + " values; " + std::to_string(needed) + " are needed.");
  return file.numbers(*count, format_in(file, line), what);
}

std::vector<std::string> text_lines(CosmosFile& file) {
  const std::string_view line = file.line("the lines of text");
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  std::optional<std::size_t> count;
  if (take_behind(rest, first_words) && rest.find_first_not_of(" .0123456789") == rest.find("WITH ") &&
      take_behind(rest, "WITH "))
    count = take_whole_number(rest);
  if (!count || !take(rest, "TEXT LINES)"))
    file.refuse("expected \"(Format v01.20 with 13 text lines)\", but found " + quoted(trimmed(line)) + ".");
  std::vector<std::string> lines{std::string{trimmed(line)}};
  while (lines.size() < *count) lines.emplace_back(trimmed(file.line("the last of its lines of text")));
  return lines;
}

void skip_comments(CosmosFile& file) {
  const std::string_view line = file.line("the comments");
  const std::optional<std::size_t> count = count_before(line, "COMMENT");
  if (!count)
    file.refuse("expected the line \"  2 Comment line(s) follow ...\", but found " + quoted(trimmed(line)) + ".");
  for (std::size_t i = 0; i < *count; ++i)
    if (!trimmed(file.line("the last comment")).starts_with('|'))
      file.refuse("expected " + std::to_string(*count) + " lines of comment, each with \"|\" in front.");
}

/// Returns the unit of "units=cm/sec2(04)" or "units=cm/sec2 (04)", m/s^2.
double unit_in(CosmosFile& file, std::string_view line, double number_in_header) {
  const std::string capitals = upper_case(line);
  std::string_view rest = capitals;
  std::optional<std::size_t> number;
  if (take_behind(rest, "UNITS") && take(rest, "=") && take_behind(rest, "(")) number = take_whole_number(rest);
  if (!number || !take(rest, ")"))
    file.refuse("expected the unit with its number, as \"units=cm/sec2(04)\", but found " + quoted(trimmed(line)) +
                ".");
  if (number_in_header != unknown && number_in_header != static_cast<double>(*number))
    file.refuse("the unit is number " + std::to_string(*number) + " here, but value 3 of the integer header is " +
                to_text(number_in_header) + ".");
  for (const Unit& unit : units_of_acceleration)
    if (unit.number == *number) return unit.si;
  file.refuse("unit number " + std::to_string(*number) + " is not one of acceleration; known are " + known_units +
              ". Take the file with processed acceleration.");
}

double checked_interval(CosmosFile& file, const std::vector<double>& real_header, std::size_t count) {
  const double milliseconds = real_header[interval_value - 1], length = real_header[length_value - 1];
  if (!(milliseconds > 0.0))
    file.refuse("value 62 of the real header, the interval of the samples, is " + to_text(milliseconds) +
                " ms; it must be > 0 ms.");
  const double interval = 1e-3 * milliseconds;
  const double by_count = interval * static_cast<double>(count);
  // Files count their length with and without the interval behind the last sample.
  if (length != unknown && std::abs(length - by_count) > 0.01 * by_count + interval)
    file.refuse(std::to_string(count) + " values at intervals of " + to_text(milliseconds) + " ms last " +
                to_text(by_count) + " s, but value 63 of the real header, the length, is " + to_text(length) + " s.");
  return interval;
}

void check_end(CosmosFile& file) {
  std::string_view line;
  bool ended = false;
  while (file.next(line)) {
    if (trimmed(line).empty()) continue;
    if (ended)
      file.refuse(
          "text follows the end of the data. A file with several channels must be split: one file per channel.");
    if (!upper_case(trimmed(line)).starts_with("END-OF-DATA"))
      file.refuse("expected \"End-of-data\" behind the last value, but found " + quoted(trimmed(line)) +
                  ". The number of values in the line above the data may be wrong.");
    ended = true;
  }
  if (!ended) file.refuse("expected \"End-of-data\" behind the last value. The file was cut; fetch it again.");
}

}  // namespace

bool is_cosmos(const TextFile& file) {
  LineReader lines{file};
  std::string_view first;
  return lines.next(first) && upper_case(first).find(first_words) != std::string::npos;
}

GroundMotion parse_cosmos(const TextFile& text) {
  CosmosFile file{text};
  std::vector<std::string> notes = text_lines(file);
  const std::vector<double> integers = header(file, "Integer", unit_value);
  const std::vector<double> reals = header(file, "Real", length_value);
  skip_comments(file);
  const std::string_view line = file.line("the data");
  const std::optional<std::size_t> count = count_before(line, " PTS", "ABCDEFGHIJKLMNOPQRSTUVWXYZ. ");
  if (!count)
    file.refuse("expected the line \" 4000 acceleration pts, approx  80 secs, units=...\", but found " +
                quoted(trimmed(line)) + ".");
  if (*count < 2) file.refuse(std::to_string(*count) + " values are not enough; there must be >= 2.");
  if (integers[quantity_value - 1] != acceleration_quantity)
    file.refuse("value 2 of the integer header is " + to_text(integers[quantity_value - 1]) +
                "; only 1, acceleration, is read.");
  const double unit = unit_in(file, line, integers[unit_value - 1]);
  const double interval = checked_interval(file, reals, *count);
  std::vector<double> samples = file.numbers(*count, format_in(file, line), "acceleration");
  for (double& sample : samples) sample *= unit;
  check_end(file);
  return GroundMotion{text.path.stem().string(), interval, std::move(samples), std::move(notes), file_of(text)};
}

GroundMotion read_cosmos(const std::filesystem::path& path) { return parse_cosmos(read_text_file(path)); }

}  // namespace moat
