#include "structures/files/matrix_file.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "structures/files/matrix_market.hpp"
#include "structures/files/number_rows.hpp"

namespace moat {
namespace {

MatrixInUnits with_units(const Check& check, const MatrixUnits& units) {
  constexpr const char* advice = "Give the units of its entries: {.force = kN, .length = m}.";
  check.positive("length", units.length, advice);
  check.not_negative("force", units.force, advice);
  check.not_negative("mass", units.mass, advice);
  check.that(units.force.si() > 0.0 || units.mass.si() > 0.0, "neither force nor mass is given.",
             "Give the units of its entries: {.force = kN, .length = m}, or {.length = m, .mass = tonne} for masses.");
  MatrixInUnits matrix;
  matrix.force = units.force.si();
  matrix.length = units.length.si();
  matrix.mass = units.mass.si() > 0.0 ? units.mass.si() : units.force.si() / units.length.si();
  return matrix;
}

void check_names(const TextFile& file, const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (name.empty()) refuse_file(file.path, "a row or a column has no name. Give all names, or none.");
    if (!known.insert(name).second) refuse_file(file.path, "two rows or columns have the name " + quoted(name) + ".");
  }
}

// Names of the columns from the first line, or a heading of words, which becomes a note.
std::vector<std::string> column_names(const TextFile& file, const NumberRows& numbers, MatrixInUnits& matrix) {
  if (!numbers.heading) return {};
  const auto size = static_cast<std::size_t>(matrix.values.rows());
  const TextRow& heading = *numbers.heading;
  const std::vector<std::string> names = numbers.column_names();
  if (names.size() == size) return names;
  if (!numbers.is_heading_of_words())
    refuse_line(file.path, heading.line_number,
                counted(names.size(), "name") + " for " + counted(size, "column") + ". Begin remarks with #.");
  matrix.notes.push_back("heading: " + std::string{trimmed(heading.text)});
  return {};
}

void read_rows(const TextFile& file, const TextRows& rows, MatrixInUnits& matrix) {
  const NumberRows numbers = number_rows_of(file, rows);
  matrix.values = numbers.values;
  if (matrix.values.rows() != matrix.values.cols())
    refuse_file(file.path, counted(static_cast<std::size_t>(matrix.values.rows()), "line") + " of " +
                               counted(static_cast<std::size_t>(matrix.values.cols()), "number") +
                               ". A square matrix has as many lines as numbers in each.");
  const std::vector<std::string> names = column_names(file, numbers, matrix);
  if (!names.empty() && !numbers.row_names.empty() && names != numbers.row_names) {
    const auto [row, column] = std::ranges::mismatch(numbers.row_names, names);
    const std::string number = std::to_string(row - numbers.row_names.begin() + 1);
    refuse_file(file.path, "row " + number + " is " + quoted(*row) + ", column " + number + " is " + quoted(*column) +
                               ". Rows and columns must have one order.");
  }
  matrix.names = names.empty() ? numbers.row_names : names;
  check_names(file, matrix.names);
}

// Counts digits without leading and trailing zeros: 2 in 0.00120e3; none in a word.
int significant_digits(std::string_view number) {
  if (parse_number(number).problem) return 0;
  std::string digits;
  for (const char c : number.substr(0, number.find_first_of("eEdD")))
    if (c >= '0' && c <= '9') digits += c;
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? 0 : static_cast<int>(digits.find_last_not_of('0') - first + 1);
}

void note_few_digits(const TextFile& file, const TextRows& all, MatrixInUnits& matrix) {
  constexpr int few = 6;
  int most = 0;
  for (const TextRow& row : all.rows)
    for (const std::string& field : row.fields) most = std::max(most, significant_digits(field));
  if (most > few) return;
  matrix.notes.push_back("no number of " + file.path.filename().string() + " has more than " + std::to_string(few) +
                         " digits. Long periods are differences of large entries and lose digits: write 17.");
}

}  // namespace

MatrixInUnits in_units(Eigen::MatrixXd values, const MatrixUnits& units) {
  const Check check{"in_units", ""};
  MatrixInUnits matrix = with_units(check, units);
  check.that(values.size() > 0 && values.rows() == values.cols(),
             "the matrix is " + std::to_string(values.rows()) + " x " + std::to_string(values.cols()) + ".",
             "Give a square one.");
  check.that(values.allFinite(), "the matrix has entries that are not finite.", "Give numbers.");
  matrix.values = std::move(values);
  return matrix;
}

MatrixInUnits read_matrix(const std::filesystem::path& path, const MatrixUnits& units) {
  MatrixInUnits matrix = with_units(Check{"read_matrix", path.native()}, units);
  const TextFile file = read_text_file(path);
  matrix.source = file_of(file).path;
  const bool is_market =
      units.format == MatrixFormat::matrix_market || (units.format == MatrixFormat::detect && is_matrix_market(file));
  const TextRows rows = is_market || units.format == MatrixFormat::text ? rows_of(file, ' ') : rows_of(file);
  if (is_market)
    matrix.values = matrix_market_of(file, rows);
  else
    read_rows(file, rows, matrix);
  note_few_digits(file, rows, matrix);
  return matrix;
}

}  // namespace moat
