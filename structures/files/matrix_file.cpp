#include "structures/files/matrix_file.hpp"

#include <algorithm>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "structures/files/matrix_market.hpp"
#include "structures/files/text_rows.hpp"

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

bool is_heading(const TextRows& all) {
  const std::vector<std::string>& fields = all.rows.front().fields;
  return all.separator == ' ' ? !is_number(fields.front()) : std::ranges::none_of(fields, is_number);
}

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

// Puts the names of rows and columns, which must agree, and a heading.
void put_names(const TextFile& file, const TextRow& heading, char separator, const std::vector<std::string>& row_names,
               MatrixInUnits& matrix) {
  const auto size = static_cast<std::size_t>(matrix.values.rows());
  const bool has_corner = !row_names.empty() && heading.fields.size() == size + 1;
  const std::vector<std::string> names(heading.fields.begin() + (has_corner ? 1 : 0), heading.fields.end());
  if (names.size() != size && (separator == ' ' || names.size() == 1)) {
    matrix.notes.push_back("heading: " + heading.text);
    return;
  }
  if (names.size() != size)
    refuse_line(file.path, heading.line_number,
                counted(names.size(), "name") + " for " + counted(size, "column") + ". Begin remarks with #.");
  for (std::size_t i = 0; i < row_names.size(); ++i)
    if (row_names[i] != names[i])
      refuse_file(file.path, "row " + std::to_string(i + 1) + " is " + quoted(row_names[i]) + ", column " +
                                 std::to_string(i + 1) + " is " + quoted(names[i]) +
                                 ". Rows and columns must have one order.");
  matrix.names = names;
}

void check_names(const TextFile& file, const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (name.empty()) refuse_file(file.path, "a row or a column has no name. Give all names, or none.");
    if (!known.insert(name).second) refuse_file(file.path, "two rows or columns have the name " + quoted(name) + ".");
  }
}

void read_rows(const TextFile& file, const TextRows& all, MatrixInUnits& matrix) {
  const bool has_heading = is_heading(all);
  const std::span<const TextRow> rows = std::span{all.rows}.subspan(has_heading ? 1 : 0);
  if (rows.empty()) refuse_file(file.path, "there are no numbers in it.");
  const std::size_t begin = std::ranges::none_of(rows, [](const TextRow& row) { return is_number(row.fields[0]); });
  const std::size_t columns = rows.front().fields.size() - begin;
  std::vector<std::string> row_names;
  matrix.values.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < matrix.values.rows(); ++i) {
    const TextRow& row = rows[static_cast<std::size_t>(i)];
    for (std::size_t field = begin; field < row.fields.size(); ++field) number_in(file, row, field);
    if (const std::size_t count = row.fields.size() - begin; count != columns)
      refuse_line(file.path, row.line_number,
                  "it has " + counted(count, "number") + ", line " + std::to_string(rows.front().line_number) +
                      " has " + std::to_string(columns) + ".");
    for (Eigen::Index j = 0; j < matrix.values.cols(); ++j)
      matrix.values(i, j) = number_in(file, row, begin + static_cast<std::size_t>(j));
    if (begin == 1) row_names.push_back(row.fields[0]);
  }
  if (rows.size() != columns)
    refuse_file(file.path, counted(rows.size(), "line") + " of " + counted(columns, "number") +
                               ". A square matrix has as many lines as numbers in each.");
  if (has_heading) put_names(file, all.rows.front(), all.separator, row_names, matrix);
  if (matrix.names.empty()) matrix.names = row_names;
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
