#include "structures/files/matrix_market.hpp"

#include <cmath>
#include <span>
#include <string>

namespace moat {
namespace {

constexpr std::string_view banner = "%%MATRIXMARKET";

struct Layout {
  bool is_array = false, is_symmetric = false;
};

// One of two words of the banner, or a refusal with both.
bool is_second(const TextFile& file, std::string_view word, const std::string& first, const std::string& second) {
  const std::string capitals = upper_case(word);
  if (capitals != upper_case(first) && capitals != upper_case(second))
    refuse_line(file.path, 1,
                quoted(word) + " is not read here; it must be " + first + " or " + second +
                    ". Write \"%%MatrixMarket matrix coordinate real symmetric\", for example.");
  return capitals == upper_case(second);
}

Layout layout_of(const TextFile& file) {
  std::string_view line = std::string_view{file.text}.substr(0, file.text.find('\n'));
  std::vector<std::string_view> words;
  for (line = trimmed(line); !line.empty(); line = trimmed(line.substr(words.back().size())))
    words.push_back(line.substr(0, line.find_first_of(" \t")));
  if (!is_matrix_market(file) || words.size() != 5)
    refuse_line(file.path, 1, "it must be \"%%MatrixMarket matrix coordinate real symmetric\", for example.");
  is_second(file, words[1], "matrix", "matrix");
  const bool is_array = is_second(file, words[2], "coordinate", "array");
  is_second(file, words[3], "real", "integer");
  return {is_array, is_second(file, words[4], "general", "symmetric")};
}

void require_fields(const TextFile& file, const TextRow& row, std::size_t count, const char* meaning) {
  if (row.fields.size() != count)
    refuse_line(file.path, row.line_number, quoted(row.text) + " must be " + meaning + ".");
}

// A count or an index of 1 to `most`.
Eigen::Index whole_number(const TextFile& file, const TextRow& row, std::size_t field, double most) {
  const double number = number_in(file, row, field);
  if (!(number >= 1.0 && number <= most && number == std::floor(number)))
    refuse_line(file.path, row.line_number,
                quoted(row.fields[field]) + " must be a whole number from 1 to " +
                    std::to_string(static_cast<Eigen::Index>(most)) + ".");
  return static_cast<Eigen::Index>(number);
}

void require_count(const TextFile& file, std::size_t given, double wanted) {
  if (static_cast<double>(given) != wanted)
    refuse_file(file.path, "it has " + std::to_string(given) + (given == 1 ? " entry" : " entries") +
                               ", and its size asks for " + std::to_string(static_cast<std::size_t>(wanted)) + ".");
}

}  // namespace

bool is_matrix_market(const TextFile& file) {
  return upper_case(std::string_view{file.text}.substr(0, banner.size())) == banner;
}

Eigen::MatrixXd matrix_market_of(const TextFile& file, const TextRows& all) {
  constexpr double most_rows = 30'000.0;
  const Layout layout = layout_of(file);
  const TextRow& head = all.rows.front();
  require_fields(file, head, layout.is_array ? 2 : 3, layout.is_array ? "rows, columns" : "rows, columns, entries");
  const Eigen::Index size = whole_number(file, head, 0, most_rows);
  if (whole_number(file, head, 1, most_rows) != size)
    refuse_line(file.path, head.line_number, quoted(head.text) + " is no square matrix.");
  const auto n = static_cast<double>(size);
  const std::span<const TextRow> entries = std::span{all.rows}.subspan(1);
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(size, size);
  if (layout.is_array) {
    require_count(file, entries.size(), layout.is_symmetric ? 0.5 * n * (n + 1.0) : n * n);
    auto row = entries.begin();
    for (Eigen::Index j = 0; j < size; ++j)
      for (Eigen::Index i = layout.is_symmetric ? j : 0; i < size; ++i, ++row) {
        require_fields(file, *row, 1, "one number");
        values(i, j) = number_in(file, *row, 0);
        if (layout.is_symmetric) values(j, i) = values(i, j);
      }
    return values;
  }
  require_count(file, entries.size(), number_in(file, head, 2));
  Eigen::MatrixXi given = Eigen::MatrixXi::Zero(size, size);
  for (const TextRow& row : entries) {
    require_fields(file, row, 3, "row, column, value");
    const Eigen::Index i = whole_number(file, row, 0, n) - 1, j = whole_number(file, row, 1, n) - 1;
    if (given(i, j) != 0)
      refuse_line(file.path, row.line_number,
                  "entry " + row.fields[0] + " " + row.fields[1] + " stands in line " + std::to_string(given(i, j)) +
                      " too. " + (layout.is_symmetric ? "A symmetric file has one triangle." : "Give it once."));
    given(i, j) = static_cast<int>(row.line_number);
    values(i, j) = number_in(file, row, 2);
    if (!layout.is_symmetric) continue;
    given(j, i) = given(i, j);
    values(j, i) = values(i, j);
  }
  return values;
}

}  // namespace moat
