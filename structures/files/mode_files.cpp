#include "structures/files/mode_files.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/check.hpp"
#include "structures/files/input_table.hpp"

namespace moat {
namespace {

void read_eigenvalues(const std::filesystem::path& file, ModesFromFile& modes) {
  const InputTable table{read_text_file(file), {"mode"}, {"period [s]", "eigenvalue [1/s2]", "ratio"}};
  if (table.has("period") == table.has("eigenvalue"))
    refuse_file(file, "give period [s] or eigenvalue [1/s2], one of them.");
  modes.eigenvalues.resize(static_cast<Eigen::Index>(table.size()));
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table.at<Dimensionless>(row, "mode").si() != static_cast<double>(row + 1))
      table.refuse(row, "mode is " + table.text(row, "mode") + "; modes are numbered 1, 2, 3 from row to row.");
    modes.eigenvalues[static_cast<Eigen::Index>(row)] =
        table.has("period") ? std::pow(2.0 * std::numbers::pi / table.positive<Time>(row, "period").si(), 2)
                            : table.positive<Quantity<0, 0, -2>>(row, "eigenvalue").si();
    if (!std::isfinite(modes.eigenvalues[static_cast<Eigen::Index>(row)]))
      table.refuse(row, "period is " + table.text(row, "period") + "; it is too small. Check its unit.");
    if (!table.has("ratio")) continue;
    modes.ratios.push_back(table.at<Dimensionless>(row, "ratio"));
    if (!(modes.ratios.back() >= 0.0 && modes.ratios.back() < 1.0))
      table.refuse(row, "ratio of mode " + table.text(row, "mode") + " is " + to_text(modes.ratios.back()) +
                            "; it must be >= 0 and < 1. 5 % is 0.05.");
  }
  modes.notes = table.notes();
}

// "floor 3" for 3, "floor 3" and the third of `floors`.
std::string name_of_floor(const InputTable& table, std::size_t row, const std::vector<std::string>& floors) {
  const std::string word = table.word(row, "floor");
  if (const auto given = std::ranges::find(floors, word); given != floors.end())
    return "floor " + std::to_string(given - floors.begin() + 1);
  if (floors.empty() && word.find_first_not_of("0123456789") == std::string::npos) return "floor " + word;
  if (floors.empty() && word.starts_with("floor ")) return word;
  table.refuse(row, "floor " + quoted(word) + " is unknown. Give the names of the floors from the lowest up: " +
                        "read_modes(modes, shapes, {\"Story1\", \"Story2\"}).");
}

void read_table_of_shapes(const Rows& rows, const std::vector<std::string>& floors, ModesFromFile& modes) {
  const InputTable table{rows, {"mode", "floor", "x [m]"}, {"y [m]", "rotation [rad]"}};
  std::vector<std::string> directions{"x"};
  if (table.has("y") || table.has("rotation")) directions = {"x", "y", "rotation"};
  const auto count = static_cast<std::size_t>(modes.eigenvalues.size()), rows_of_mode = table.size() / count;
  if (table.size() % count != 0)
    rows.refuse(counted(table.size(), "row") + " for " + counted(count, "mode") + ". Every mode must have all floors.");
  std::vector<double> values;
  for (std::size_t row = 0; row < table.size(); ++row) {
    const std::size_t mode = row / rows_of_mode, floor = row % rows_of_mode;
    if (table.at<Dimensionless>(row, "mode").si() != static_cast<double>(mode + 1))
      table.refuse(row, "mode is " + table.text(row, "mode") + ", where mode " + std::to_string(mode + 1) + " has " +
                            counted(rows_of_mode, "floor") + ". Every mode must have all floors.");
    const std::string name = name_of_floor(table, row, floors);
    for (const std::string& direction : directions) {
      const double value = direction == "rotation" ? table.at<Dimensionless>(row, direction).si()
                                                   : table.at<Length>(row, direction).si();
      const std::string freedom = name + " " + direction;
      if (mode == 0 && std::ranges::count(modes.names, freedom) > 0)
        table.refuse(row, name + " stands twice in mode 1.");
      if (mode == 0) modes.names.push_back(freedom);
      if (modes.names[values.size() % modes.names.size()] != freedom)
        table.refuse(row, name + " stands in place " + std::to_string(floor + 1) +
                              ", in mode 1 another floor does. Give the floors in one order.");
      values.push_back(value);
    }
  }
  modes.shapes = Eigen::MatrixXd::Map(values.data(), std::ssize(modes.names), modes.eigenvalues.size());
  std::ranges::copy(table.notes(), std::back_inserter(modes.notes));
}

}  // namespace

ModesFromFile read_modes(const std::filesystem::path& modes_file, const std::filesystem::path& shapes_file,
                         const std::vector<std::string>& floors) {
  ModesFromFile modes;
  read_eigenvalues(modes_file, modes);
  const Rows rows{read_text_file(shapes_file)};
  const auto is_floor = [](const std::string& field) { return upper_case(field) == "FLOOR"; };
  if (std::ranges::any_of(rows.list.front().fields, is_floor)) {
    read_table_of_shapes(rows, floors, modes);
    return modes;
  }
  const NumberRows numbers = numbers_of(rows);
  if (numbers.values.cols() != modes.eigenvalues.size())
    rows.refuse(counted(numbers.values.cols(), "column") + " for " + counted(modes.eigenvalues.size(), "mode") +
                " of " + modes_file.string() + ".");
  modes.shapes = numbers.values;
  modes.names = numbers.row_names;
  return modes;
}

}  // namespace moat
