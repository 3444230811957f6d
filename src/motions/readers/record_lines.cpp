#include "motions/readers/record_lines.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "base/check.hpp"

namespace moat {

std::optional<FortranFormat> fortran_format(std::string_view text) {
  const std::string capitals = upper_case(text.substr(0, 40));
  std::string_view rest = capitals;
  const bool in_brackets = take(rest, "(");
  FortranFormat found{.per_line = take_whole_number(rest).value_or(1)};
  rest = without_leading_blanks(rest);
  const std::string_view kind = rest.substr(0, 1);
  rest.remove_prefix(kind.size());
  // A blank inside is a digit that was lost.
  if (!rest.starts_with(' ')) found.width = take_whole_number(rest).value_or(0);
  const bool has_decimals = rest.starts_with('.');
  if (has_decimals) rest.remove_prefix(1);
  if ((has_decimals && !take_whole_number(rest)) || (in_brackets && !take(rest, ")"))) return std::nullopt;
  found.whole = kind == "I";
  constexpr std::size_t most_fields = 200, widest = 40;
  // A number with a fraction needs its decimals in the format: (8F10) is none.
  if (found.whole == has_decimals || std::string_view{"FEDGI"}.find(kind) == std::string_view::npos)
    return std::nullopt;
  if (found.per_line < 1 || found.per_line > most_fields || found.width < 1 || found.width > widest)
    return std::nullopt;
  return found;
}

namespace {

/// Behind a place where no number begins: all digits at once, since a million of them would be scanned from each.
void pass_over(std::string_view& text) {
  text.remove_prefix(std::max<std::size_t>(1, std::min(text.find_first_not_of("0123456789"), text.size())));
}

}  // namespace

std::optional<PrintedNumber> first_number(std::string_view text) {
  for (; !text.empty(); pass_over(text)) {
    const ScannedNumber scanned = scan_number(text);
    if (scanned.problem) continue;
    const std::string_view digits = text.substr(0, scanned.length);
    const std::size_t end = std::min(digits.find_first_of("EeDd"), digits.size()), point = digits.find('.');
    int power = point < end ? -static_cast<int>(end - point - 1) : 0;
    if (end < digits.size()) power += static_cast<int>(scan_number(digits.substr(end + 1)).value);
    return PrintedNumber{scanned.value, std::pow(10.0, power)};
  }
  return std::nullopt;
}

std::vector<double> numbers_in(std::string_view text) {
  std::vector<double> numbers;
  while (!text.empty()) {
    const ScannedNumber scanned = scan_number(text);
    if (scanned.problem || text[0] == '-' || text[0] == '+') {
      pass_over(text);
    } else {
      numbers.push_back(scanned.value);
      text.remove_prefix(scanned.length);
    }
  }
  return numbers;
}

std::optional<double> utc_seconds(const std::vector<double>& date) {
  constexpr double first_year = 1800.0, last_year = 3000.0, most = 100.0;
  const auto is_out = [](double part) { return !(part >= 0.0 && part <= most); };
  if (date.size() != 6 || !(date[0] >= first_year && date[0] <= last_year) ||
      std::any_of(date.begin() + 1, date.end(), is_out))
    return std::nullopt;
  const std::chrono::year_month_day day{std::chrono::year{static_cast<int>(date[0])},
                                        std::chrono::month{static_cast<unsigned>(date[1])},
                                        std::chrono::day{static_cast<unsigned>(date[2])}};
  if (!day.ok()) return std::nullopt;
  return 86400.0 * static_cast<double>(std::chrono::sys_days{day}.time_since_epoch().count()) + 3600.0 * date[3] +
         60.0 * date[4] + date[5];
}

std::string_view RecordLines::line(const std::string& expected) {
  std::string_view text;
  if (!lines_.next(text))
    refuse_file(file_->path, "the file ends before " + expected + ". It was cut; fetch it again.");
  return text;
}

bool RecordLines::next_filled(std::string_view& line) {
  while (lines_.next(line))
    if (!trimmed(line).empty()) return true;
  return false;
}

std::vector<std::string> RecordLines::text(std::size_t count, const std::string& what) {
  std::vector<std::string> lines;
  while (lines.size() < count) {
    const std::string_view text = line(what);
    lines.emplace_back(text.substr(0, text.find_last_not_of(" \t") + 1));
  }
  return lines;
}

void RecordLines::skip(std::size_t count, const std::string& what) {
  for (std::size_t i = 0; i < count; ++i) line(what);
}

std::vector<double> RecordLines::numbers(std::size_t count, const FortranFormat& format, const std::string& what) {
  std::vector<double> values;
  // A wrong count must not reserve more than the file can hold.
  values.reserve(std::min(count, file_->text.size()));
  while (values.size() < count) {
    const std::size_t here = std::min(format.per_line, count - values.size());
    std::string_view text = line("the last of " + std::to_string(count) + " values of " + what);
    text = text.substr(0, text.find_last_not_of(" \t\r") + 1);
    const std::size_t found = (text.size() + format.width - 1) / format.width;
    if (found != here)
      refuse("expected " + std::to_string(here) + " values of " + what + " in columns of " +
             std::to_string(format.width) + " characters, but found " + std::to_string(found) + " in " + quoted(text) +
             ". The number of values or the format in the line above them is wrong.");
    for (std::size_t i = 0; i < here; ++i) {
      const std::string_view field = trimmed(text.substr(i * format.width, format.width));
      const ScannedNumber scanned = parse_number(field);
      if (scanned.problem) refuse(quoted(field) + " " + scanned.problem + ".");
      // Fortran would put a point into the digits.
      if (!format.whole && field.find('.') == std::string_view::npos)
        refuse(quoted(field) + " has no decimal point, and the format is one of numbers with decimals.");
      values.push_back(scanned.value);
    }
  }
  return values;
}

std::string HeaderKeys::find(const std::string& key) const {
  const auto found = values_.find(key);
  return found == values_.end() ? "" : found->second;
}

std::string HeaderKeys::value(const std::string& key) const {
  std::string text = find(key);
  if (text.empty())
    refuse_file(file_->path,
                "the header does not give " + key + ". Fetch the file again, or add the line \"" + key + ": ...\".");
  return text;
}

double HeaderKeys::positive(const std::string& key, const std::string& unit) const {
  const std::string text = value(key);
  const ScannedNumber number = scan_number(text);
  const std::string_view rest = trimmed(std::string_view{text}.substr(number.length));
  if (number.problem || !(number.value > 0.0) || (!rest.empty() && upper_case(rest) != upper_case(unit)))
    refuse_file(file_->path,
                key + ": " + text + " in the header is not allowed; it must be a number > 0 " + unit + ".");
  return number.value;
}

std::size_t HeaderKeys::count(const std::string& key) const {
  const std::string text = value(key);
  std::string_view rest = text;
  const std::size_t count = take_whole_number(rest).value_or(0);
  if (!rest.empty() || count < 2)
    refuse_file(file_->path, key + ": " + text + " in the header is not allowed; it must be a whole number >= 2.");
  return count;
}

double even_step(const std::filesystem::path& path, const std::vector<PrintedTime>& times,
                 std::optional<double> stated) {
  const PrintedNumber& first = times.front().time;
  double least = stated.value_or(0.0), most = stated.value_or(std::numeric_limits<double>::infinity());
  for (std::size_t i = 1; i < times.size(); ++i) {
    const auto& [time, line] = times[i];
    const double before = times[i - 1].time.value, steps = static_cast<double>(i);
    if (time.value == before)
      refuse_line(path, line,
                  "the time " + to_text(before) +
                      " s stands twice: the times have too few digits. Give the step: --record-step \"0.005 s\".");
    if (time.value < before)
      refuse_line(path, line,
                  "the time " + to_text(time.value) + " s does not follow after " + to_text(before) +
                      " s. Times must grow from line to line.");
    const double passed = time.value - first.value;
    constexpr double half_digit = 0.51, of_a_step = 1e-6, single_precision = 6e-8;
    const double tolerance =
        std::max({half_digit * time.digit, of_a_step * passed / steps, single_precision * std::abs(time.value)}) +
        (first.value == 0.0 ? 0.0 : half_digit * first.digit);
    if ((passed - tolerance) / steps > most || (passed + tolerance) / steps < least) {
      const double step = stated ? *stated : 0.5 * (least + most), off = passed - steps * step;
      refuse_line(path, line,
                  "times are not even: " + to_text(time.value) + " s is " + to_text(std::abs(off)) + " s " +
                      (off > 0.0 ? "behind " : "before ") + std::to_string(i) + " steps of " + to_text(step) +
                      " s. Resample the record to a constant step.");
    }
    least = std::max(least, (passed - tolerance) / steps);
    most = std::min(most, (passed + tolerance) / steps);
  }
  return std::clamp((times.back().time.value - first.value) / static_cast<double>(times.size() - 1), least, most);
}

}  // namespace moat
