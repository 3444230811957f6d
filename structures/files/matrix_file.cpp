#include "structures/files/matrix_file.hpp"

#include <algorithm>
#include <set>
#include <string_view>
#include <utility>

#include "base/check.hpp"
#include "structures/files/matrix_market.hpp"

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

void check_names(const Rows& rows, const std::vector<std::string>& names) {
  std::set<std::string> known;
  for (const std::string& name : names) {
    if (name.empty()) rows.refuse("a row or a column has no name. Give all names, or none.");
    if (!known.insert(name).second) rows.refuse("two rows or columns have the name " + quoted(name) + ".");
  }
}

void read_rows(const Rows& rows, MatrixInUnits& matrix) {
  const auto [values, row_names, heading] = numbers_of(rows);
  if (values.rows() != values.cols())
    rows.refuse(counted(values.rows(), "line") + " of " + counted(values.cols(), "number") +
                ". A square matrix has as many lines as numbers in each.");
  matrix.values = values;
  matrix.names = row_names;
  if (heading) {
    // A corner stands above names of rows.
    const bool has_corner = !row_names.empty() && std::ssize(heading->fields) == values.rows() + 1;
    const std::vector<std::string> names{heading->fields.begin() + (has_corner ? 1 : 0), heading->fields.end()};
    if (std::ssize(names) == values.rows()) {
      const auto [row, column] = std::ranges::mismatch(row_names, names);
      if (const std::string number = std::to_string(column - names.begin() + 1); row != row_names.end())
        rows.refuse("row " + number + " is " + quoted(*row) + ", column " + number + " is " + quoted(*column) +
                    ". Rows and columns must have one order.");
      matrix.names = names;
    } else if (rows.separator == ' ' || heading->fields.size() == 1) {
      matrix.notes.push_back("heading: " + std::string{trimmed(heading->text)});
    } else {
      rows.refuse(*heading, counted(names.size(), "name") + " for " + counted(values.rows(), "column") +
                                ". Begin remarks with #.");
    }
  }
  check_names(rows, matrix.names);
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

void note_few_digits(const Rows& rows, MatrixInUnits& matrix) {
  constexpr int few = 6;
  for (const Row& row : rows.list)
    for (const std::string& field : row.fields)
      if (significant_digits(field) > few) return;
  matrix.notes.push_back("no number of " + rows.file.path.filename().string() + " has more than " +
                         std::to_string(few) +
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
  TextFile file = read_text_file(path);
  matrix.source = file_of(file).path;
  const bool is_market =
      units.format == MatrixFormat::matrix_market || (units.format == MatrixFormat::detect && is_matrix_market(file));
  const bool has_blanks = is_market || units.format == MatrixFormat::text;
  const Rows rows{std::move(file), has_blanks ? std::optional{' '} : std::nullopt};
  if (is_market)
    matrix.values = matrix_market_of(rows);
  else
    read_rows(rows, matrix);
  note_few_digits(rows, matrix);
  return matrix;
}

}  // namespace moat
