#include "structures/frame/sap2000.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <unordered_map>

#include "base/parse_quantity.hpp"
#include "base/text/text_file.hpp"
#include "structures/files/text_rows.hpp"

namespace moat {
namespace {

using Index = Eigen::Index;

// A file without its heading.
class Table {
 public:
  Table(const std::filesystem::path& path, char separator, std::size_t columns, bool continues = false)
      : file_{read_text_file(path)} {
    for (TextRow& row : rows_of(file_, separator).rows) {
      while (!row.fields.empty() && row.fields.back().empty()) row.fields.pop_back();
      if (continues && row.fields.size() == 1 && !rows_.empty())
        rows_.back().fields.push_back(row.fields[0]);
      else
        rows_.push_back(std::move(row));
    }
    heading_ = rows_.front();
    rows_.erase(rows_.begin());
    for (const TextRow& row : rows_)
      if (row.fields.size() != columns)
        refuse(row, "has " + std::to_string(row.fields.size()) + " fields, not " + std::to_string(columns) + ".");
  }

  [[nodiscard]] const TextRow& heading() const { return heading_; }
  [[nodiscard]] const std::vector<TextRow>& rows() const { return rows_; }
  [[nodiscard]] double number(const TextRow& row, std::size_t field) const { return number_in(file_, row, field); }
  [[nodiscard]] int whole(const TextRow& row, std::size_t field) const {
    const double value = number(row, field);
    if (std::trunc(value) != value || std::abs(value) > 1e9) refuse(row, row.fields[field] + " is no whole number.");
    return static_cast<int>(value);
  }
  [[noreturn]] void refuse(const TextRow& row, const std::string& problem) const {
    refuse_line(file_.path, row.line_number, problem);
  }

 private:
  TextFile file_;
  TextRow heading_;
  std::vector<TextRow> rows_;
};

std::vector<FrameNode> nodes_of(const std::filesystem::path& joints) {
  const Table table{joints, ',', 4};
  const std::array<std::string, 4> names{"joint", "x [", "y [", "z ["};
  std::array<Length, 4> units{};
  for (std::size_t i = 0; i < 4; ++i) {
    const std::string field = i < table.heading().fields.size() ? table.heading().fields[i] : "";
    if (!field.starts_with(names[i]) || (i > 0 && !field.ends_with(']')))
      table.refuse(table.heading(), "the heading must be joint,x [m],y [m],z [m].");
    if (i > 0) units[i] = parse<Length>("1 " + field.substr(3, field.size() - 4), field);
  }
  std::vector<FrameNode> nodes;
  for (const TextRow& row : table.rows())
    nodes.push_back({row.fields[0], table.number(row, 1) * units[1], table.number(row, 2) * units[2],
                     table.number(row, 3) * units[3]});
  return nodes;
}

class Reader {
 public:
  Reader(const std::filesystem::path& path, const std::filesystem::path& joints, const MatrixUnits& units)
      : path_{path}, units_{in_units(Eigen::MatrixXd::Ones(1, 1), units)} {
    model_.name = path.filename().string();
    model_.nodes = nodes_of(joints);
    model_.feet = Feet::given;
  }

  FiniteElements read() {
    read_equations();
    model_.stiffness = matrix(".TXK", units_.force / units_.length);
    if (std::filesystem::exists(file(".TXM"))) model_.mass = matrix(".TXM", units_.mass);
    return std::move(model_);
  }

 private:
  struct Term {
    int equation;
    double coefficient;
  };

  [[nodiscard]] std::filesystem::path file(const char* ending) const { return path_.string() + ending; }

  void read_equations() {
    const Table table{file(".TXE"), '\t', 7, true};
    std::unordered_map<std::string, Index> joints;
    for (const FrameNode& node : model_.nodes) joints.emplace(node.name.text(), std::ssize(joints));
    std::size_t joints_found = 0;
    std::vector<std::pair<Index, int>> motions;
    for (const TextRow& row : table.rows()) {
      const auto joint = joints.find(row.fields[0]);
      if (joint == joints.end() && !row.fields[0].starts_with('C'))
        table.refuse(row, "joint " + row.fields[0] + " has no coordinates. Add it to the file of joints.");
      joints_found += joint != joints.end() ? 1 : 0;
      for (int motion = 0; motion < 6; ++motion) {
        const int equation = table.whole(row, static_cast<std::size_t>(motion + 1));
        if (equation > 0) is_rotation_[equation] = motion >= 3;
        if (joint != joints.end() && equation != 0) motions.emplace_back(6 * joint->second + motion, equation);
      }
    }
    if (joints_found != model_.nodes.size())
      refuse_file(file(".TXE"), "it has " + std::to_string(joints_found) + " joints, the file of joints has " +
                                    std::to_string(model_.nodes.size()) + ".");
    if (is_rotation_.empty()) refuse_file(file(".TXE"), "it has no equations.");
    const std::map<int, std::vector<Term>> constraints = read_constraints(motions);
    std::vector<Eigen::Triplet<double>> entries;
    for (const auto& [motion, equation] : motions) {
      const auto add = [&, row = motion](const Term& term) {
        const int power = static_cast<int>(is_rotation_.at(term.equation)) - static_cast<int>(row % 6 >= 3);
        entries.emplace_back(row, term.equation - 1, term.coefficient * std::pow(units_.length, power));
      };
      if (equation > 0) {
        add({equation, 1.0});
        continue;
      }
      const auto found = constraints.find(equation);
      if (found == constraints.end())
        refuse_file(file(".TXE"), "TXC has no constraint " + std::to_string(equation) + ", TXE has.");
      std::ranges::for_each(found->second, add);
    }
    model_.equations.resize(6 * std::ssize(model_.nodes), size());
    model_.equations.setFromTriplets(entries.begin(), entries.end());
  }

  [[nodiscard]] std::map<int, std::vector<Term>> read_constraints(
      const std::vector<std::pair<Index, int>>& motions) const {
    std::map<int, std::vector<Term>> constraints;
    if (std::ranges::none_of(motions, [](const auto& motion) { return motion.second < 0; })) return constraints;
    const Table table{file(".TXC"), '\t', 3};
    for (const TextRow& row : table.rows())
      constraints[table.whole(row, 0)].push_back({equation(table, row, 1, "TXC"), table.number(row, 2)});
    return constraints;
  }

  // Equations are numbered from 1.
  [[nodiscard]] Index size() const { return is_rotation_.rbegin()->first; }

  [[nodiscard]] int equation(const Table& table, const TextRow& row, std::size_t field, const std::string& kind) const {
    const int number = table.whole(row, field);
    if (!is_rotation_.contains(number))
      table.refuse(row, "TXE has no equation " + std::to_string(number) + ", " + kind + " has.");
    return number;
  }

  [[nodiscard]] SparseMatrix matrix(const char* ending, double unit) const {
    const Table table{file(ending), '\t', 3};
    std::vector<Eigen::Triplet<double>> entries;
    std::map<std::pair<int, int>, std::size_t> lines;
    for (const TextRow& row : table.rows()) {
      const int i = equation(table, row, 0, ending + 1), j = equation(table, row, 1, ending + 1);
      const auto [line, is_new] = lines.emplace(std::minmax(i, j), row.line_number);
      if (!is_new)
        table.refuse(row, "entry (" + std::to_string(i) + ", " + std::to_string(j) + ") stands in line " +
                              std::to_string(line->second) + " already. One triangle is expected.");
      const double value =
          table.number(row, 2) * unit *
          std::pow(units_.length, static_cast<int>(is_rotation_.at(i)) + static_cast<int>(is_rotation_.at(j)));
      entries.emplace_back(i - 1, j - 1, value);
      if (i != j) entries.emplace_back(j - 1, i - 1, value);
    }
    SparseMatrix result(size(), size());
    result.setFromTriplets(entries.begin(), entries.end());
    return result;
  }

  std::filesystem::path path_;
  MatrixInUnits units_;
  FiniteElements model_;
  std::map<int, bool> is_rotation_;  // of the equations
};

}  // namespace

FiniteElements read_sap2000(const std::filesystem::path& path, const std::filesystem::path& joints,
                            const MatrixUnits& units) {
  return Reader{path, joints, units}.read();
}

}  // namespace moat
