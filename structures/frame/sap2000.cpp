#include "structures/frame/sap2000.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/parse_quantity.hpp"
#include "base/text/rows.hpp"

namespace moat {
namespace {

using Index = Eigen::Index;

// A file and its heading. Empty fields at the end of a line do not count.
struct Sheet : Rows {
  Sheet(const std::filesystem::path& path, char cut, std::size_t columns, bool continues = false)
      : Rows{read_text_file(path), cut} {
    std::vector<Row> records;
    for (Row& row : list) {
      while (!row.fields.empty() && row.fields.back().empty()) row.fields.pop_back();
      if (continues && row.fields.size() == 1 && !records.empty())
        records.back().fields.push_back(row.fields[0]);
      else
        records.push_back(std::move(row));
    }
    list = std::move(records);
    heading = take_heading();
    for (const Row& row : list)
      if (row.fields.size() != columns)
        refuse(row, "has " + std::to_string(row.fields.size()) + " fields, not " + std::to_string(columns) + ".");
  }

  [[nodiscard]] int whole(const Row& row, std::size_t field) const {
    const double value = number(row, field);
    if (std::trunc(value) != value || std::abs(value) > 1e9) refuse(row, row.fields[field] + " is no whole number.");
    return static_cast<int>(value);
  }

  Row heading;
};

std::vector<FrameNode> nodes_of(const std::filesystem::path& joints) {
  const Sheet sheet{joints, ',', 4};
  std::vector<std::string> names = sheet.heading.fields;
  names.resize(4);
  std::array<Length, 4> units{};
  for (std::size_t i = 0; const char* begin : {"joint", "x [", "y [", "z ["}) {
    if (!names[i].starts_with(begin) || (i > 0 && !names[i].ends_with(']')))
      sheet.refuse(sheet.heading, "the heading must be joint,x [m],y [m],z [m].");
    if (i > 0) units[i] = parse<Length>("1 " + names[i].substr(3, names[i].size() - 4), names[i]);
    ++i;
  }
  std::vector<FrameNode> nodes;
  for (const Row& row : sheet.list)
    nodes.push_back({row.fields[0], sheet.number(row, 1) * units[1], sheet.number(row, 2) * units[2],
                     sheet.number(row, 3) * units[3]});
  return nodes;
}

// The equations of the model: 1 for those of rotations, else 0.
using Equations = std::map<int, int>;

int equation(const Equations& equations, const Sheet& sheet, const Row& row, std::size_t field) {
  const int number = sheet.whole(row, field);
  if (!equations.contains(number))
    sheet.refuse(row, "TXE has no equation " + std::to_string(number) + ", " +
                          sheet.file.path.extension().string().substr(1) + " has.");
  return number;
}

// Reads TXE and TXC: the motions of the nodes from the unknowns.
Equations read_equations(const std::filesystem::path& path, double length, FiniteElements& model) {
  const Sheet sheet{path.string() + ".TXE", '\t', 7, true};
  std::unordered_map<std::string, Index> joints;
  for (const FrameNode& node : model.nodes) joints.emplace(node.name.text(), std::ssize(joints));
  std::size_t joints_found = 0;
  Equations equations;
  std::vector<std::pair<Index, int>> motions;
  for (const Row& row : sheet.list) {
    const auto joint = joints.find(row.fields[0]);
    if (joint == joints.end() && !row.fields[0].starts_with('C'))
      sheet.refuse(row, "joint " + row.fields[0] + " has no coordinates. Add it to the file of joints.");
    joints_found += joint != joints.end() ? 1 : 0;
    for (int motion = 0; motion < 6; ++motion) {
      const int number = sheet.whole(row, static_cast<std::size_t>(motion + 1));
      if (number > 0) equations[number] = motion < 3 ? 0 : 1;
      if (joint != joints.end() && number != 0) motions.emplace_back(6 * joint->second + motion, number);
    }
  }
  if (joints_found != model.nodes.size())
    sheet.refuse("it has " + std::to_string(joints_found) + " joints, the file of joints has " +
                 std::to_string(model.nodes.size()) + ".");
  if (equations.empty()) sheet.refuse("it has no equations.");
  if (const int last = equations.rbegin()->first; std::ssize(equations) != last)
    sheet.refuse("it has " + counted(equations.size(), "equation") + ", and the last has the number " +
                 std::to_string(last) + ". They must be numbered 1, 2, 3 and so on.");
  std::map<int, std::vector<std::pair<int, double>>> terms;  // equations and coefficients of all numbers in TXE
  if (std::ranges::any_of(motions, [](const auto& motion) { return motion.second < 0; })) {
    const Sheet constraints{path.string() + ".TXC", '\t', 3};
    for (const Row& row : constraints.list)
      terms[constraints.whole(row, 0)].push_back(
          {equation(equations, constraints, row, 1), constraints.number(row, 2)});
  }
  for (const auto& [number, is_rotation] : equations) terms[number] = {{number, 1.0}};
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& [motion, number] : motions) {
    if (!terms.contains(number)) sheet.refuse("TXC has no constraint " + std::to_string(number) + ", TXE has.");
    for (const auto& [unknown, coefficient] : terms[number])
      entries.emplace_back(motion, unknown - 1,
                           coefficient * std::pow(length, equations[unknown] - (motion % 6 < 3 ? 0 : 1)));
  }
  model.equations.resize(6 * std::ssize(model.nodes), equations.rbegin()->first);
  model.equations.setFromTriplets(entries.begin(), entries.end());
  return equations;
}

// Reads TXK or TXM.
SparseMatrix matrix_of(const std::filesystem::path& path, const Equations& equations, double unit, double length) {
  const Sheet sheet{path, '\t', 3};
  std::vector<Eigen::Triplet<double>> entries;
  std::map<std::pair<int, int>, std::size_t> lines;
  for (const Row& row : sheet.list) {
    const int i = equation(equations, sheet, row, 0), j = equation(equations, sheet, row, 1);
    const auto [line, is_new] = lines.emplace(std::minmax(i, j), row.line_number);
    if (!is_new)
      sheet.refuse(row, "entry (" + std::to_string(i) + ", " + std::to_string(j) + ") stands in line " +
                            std::to_string(line->second) + " already. One triangle is expected.");
    const double value = sheet.number(row, 2) * unit * std::pow(length, equations.at(i) + equations.at(j));
    entries.emplace_back(i - 1, j - 1, value);
    if (i != j) entries.emplace_back(j - 1, i - 1, value);
  }
  const int size = equations.rbegin()->first;
  SparseMatrix result(size, size);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

FiniteElements read_sap2000(const std::filesystem::path& path, const std::filesystem::path& joints,
                            const MatrixUnits& units_of_model) {
  const MatrixInUnits units = in_units(Eigen::MatrixXd::Ones(1, 1), units_of_model);
  FiniteElements model{.name = path.filename().string(), .nodes = nodes_of(joints), .feet = Feet::given};
  const Equations equations = read_equations(path, units.length, model);
  model.stiffness = matrix_of(path.string() + ".TXK", equations, units.force / units.length, units.length);
  if (const std::string masses = path.string() + ".TXM"; std::filesystem::exists(masses))
    model.mass = matrix_of(masses, equations, units.mass, units.length);
  return model;
}

}  // namespace moat
