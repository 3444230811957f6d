#include "structures/files/number_rows.hpp"

#include <algorithm>
#include <span>

namespace moat {
namespace {

// Names may hold numbers: "floor 1" cut at the blank.
bool is_heading(const TextRows& all) {
  const std::vector<std::string>& fields = all.rows.front().fields;
  return all.separator == ' ' ? !is_number(fields.front()) : std::ranges::none_of(fields, is_number);
}

}  // namespace

std::string counted(std::size_t count, const std::string& one) {
  return std::to_string(count) + " " + one + (count == 1 ? "" : "s");
}

std::vector<std::string> NumberRows::column_names() const {
  if (!heading) return {};
  const bool has_corner = !row_names.empty() && heading->fields.size() == static_cast<std::size_t>(values.cols()) + 1;
  return {heading->fields.begin() + (has_corner ? 1 : 0), heading->fields.end()};
}

bool NumberRows::is_heading_of_words() const { return heading && (separator == ' ' || heading->fields.size() == 1); }

NumberRows number_rows_of(const TextFile& file, const TextRows& all) {
  NumberRows numbers{.separator = all.separator};
  if (is_heading(all)) numbers.heading = all.rows.front();
  const std::span<const TextRow> rows = std::span{all.rows}.subspan(numbers.heading ? 1 : 0);
  if (rows.empty()) refuse_file(file.path, "there are no numbers in it.");
  const std::size_t begin = std::ranges::none_of(rows, [](const TextRow& row) { return is_number(row.fields[0]); });
  const std::size_t columns = rows.front().fields.size() - begin;
  numbers.values.resize(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(columns));
  for (Eigen::Index i = 0; i < numbers.values.rows(); ++i) {
    const TextRow& row = rows[static_cast<std::size_t>(i)];
    const std::size_t count = row.fields.size() - begin;
    // A bad number, such as one with a decimal comma, may be the reason of a wrong count.
    Eigen::RowVectorXd values(static_cast<Eigen::Index>(count));
    for (std::size_t j = 0; j < count; ++j) values[static_cast<Eigen::Index>(j)] = number_in(file, row, begin + j);
    if (count != columns)
      refuse_line(file.path, row.line_number,
                  "it has " + counted(count, "number") + ", line " + std::to_string(rows.front().line_number) +
                      " has " + std::to_string(columns) + ".");
    numbers.values.row(i) = values;
    if (begin == 1) numbers.row_names.push_back(row.fields[0]);
  }
  return numbers;
}

}  // namespace moat
