#include "structures/files/matrix_market.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <span>
#include <sstream>
#include <utility>

namespace moat {
namespace {

constexpr std::string_view banner = "%%MATRIXMARKET";

// Whether a word of the banner is the second of two.
bool is_second(const Rows& rows, const std::string& word, const std::string& first, const std::string& second) {
  const std::string capitals = upper_case(word);
  if (capitals != upper_case(first) && capitals != upper_case(second))
    refuse_line(rows.file.path, 1,
                quoted(word) + " is not read here; it must be " + first + " or " + second +
                    ". Write \"%%MatrixMarket matrix coordinate real symmetric\", for example.");
  return capitals == upper_case(second);
}

void require_fields(const Rows& rows, const Row& row, std::size_t count, const char* meaning) {
  if (row.fields.size() != count) rows.refuse(row, quoted(row.text) + " must be " + meaning + ".");
}

// A count or an index of 1 to `most`.
Eigen::Index whole_number(const Rows& rows, const Row& row, std::size_t field, Eigen::Index most) {
  const double number = rows.number(row, field);
  if (!(number >= 1.0 && number <= static_cast<double>(most) && number == std::floor(number)))
    rows.refuse(row, quoted(row.fields[field]) + " must be a whole number from 1 to " + std::to_string(most) + ".");
  return static_cast<Eigen::Index>(number);
}

}  // namespace

bool is_matrix_market(const TextFile& file) {
  return upper_case(std::string_view{file.text}.substr(0, banner.size())) == banner;
}

Eigen::MatrixXd matrix_market_of(const Rows& rows) {
  constexpr Eigen::Index most_rows = 10'000;  // 800 MB
  std::istringstream first_line{rows.file.text.substr(0, rows.file.text.find('\n'))};
  const std::vector<std::string> words{std::istream_iterator<std::string>{first_line}, {}};
  if (!is_matrix_market(rows.file) || words.size() != 5)
    refuse_line(rows.file.path, 1, "it must be \"%%MatrixMarket matrix coordinate real symmetric\", for example.");
  is_second(rows, words[1], "matrix", "matrix");
  const bool is_array = is_second(rows, words[2], "coordinate", "array");
  is_second(rows, words[3], "real", "integer");
  const bool is_symmetric = is_second(rows, words[4], "general", "symmetric");
  const Row& head = rows.list.front();
  require_fields(rows, head, is_array ? 2 : 3, is_array ? "rows, columns" : "rows, columns, entries");
  const Eigen::Index n = whole_number(rows, head, 0, most_rows);
  if (whole_number(rows, head, 1, most_rows) != n) rows.refuse(head, quoted(head.text) + " is no square matrix.");
  const std::span<const Row> entries = std::span{rows.list}.subspan(1);
  const Eigen::Index asked = !is_array      ? whole_number(rows, head, 2, most_rows * most_rows)
                             : is_symmetric ? n * (n + 1) / 2
                                            : n * n;
  if (std::ssize(entries) != asked)
    rows.refuse("it has " + std::to_string(entries.size()) + (entries.size() == 1 ? " entry" : " entries") +
                ", and its size asks for " + std::to_string(asked) + ".");
  Eigen::MatrixXd values = Eigen::MatrixXd::Zero(n, n);
  std::map<std::pair<Eigen::Index, Eigen::Index>, std::size_t> lines;  // where an entry is given
  Eigen::Index i = 0, j = 0;
  for (const Row& row : entries) {
    if (is_array) {
      require_fields(rows, row, 1, "one number");
    } else {
      require_fields(rows, row, 3, "row, column, value");
      i = whole_number(rows, row, 0, n) - 1;
      j = whole_number(rows, row, 1, n) - 1;
      const auto place = is_symmetric ? std::pair{std::max(i, j), std::min(i, j)} : std::pair{i, j};
      const auto [given, is_new] = lines.emplace(place, row.line_number);
      if (!is_new)
        rows.refuse(row, "entry " + row.fields[0] + " " + row.fields[1] + " stands in line " +
                             std::to_string(given->second) + " too. " +
                             (is_symmetric ? "A symmetric file has one triangle." : "Give it once."));
    }
    values(i, j) = rows.number(row, is_array ? 0 : 2);
    if (is_symmetric) values(j, i) = values(i, j);
    // An array is written column by column, from the diagonal down where it is symmetric.
    if (!is_array || ++i < n) continue;
    ++j;
    i = is_symmetric ? j : 0;
  }
  return values;
}

}  // namespace moat
