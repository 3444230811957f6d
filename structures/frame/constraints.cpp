#include "structures/frame/constraints.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <unordered_map>

namespace moat {
namespace {

using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Index = Eigen::Index;

constexpr double place_tolerance = 1e-3;  // m
constexpr std::array motion_names{"x", "y", "z", "rotation about x", "rotation about y", "rotation about z"};
constexpr int turn = 5;  // rotation about z

std::string node_name(const FiniteElements& model, std::size_t node) {
  const std::string& name = model.nodes[node].name.text();
  return name.empty() ? std::to_string(node + 1) : name;
}

class NodeNumbers {
 public:
  NodeNumbers(const FiniteElements& model, const Check& check) : check_{check} {
    numbers_.reserve(model.nodes.size());
    for (std::size_t node = 0; node < model.nodes.size(); ++node) {
      const auto& [name, x, y, z] = model.nodes[node];
      const bool is_new = numbers_.emplace(node_name(model, node), node).second;
      if (!is_new) check.that(false, "node " + node_name(model, node) + " is given twice.");
      for (const Length& coordinate : {x, y, z})
        if (!std::isfinite(coordinate.si())) check.finite("a coordinate of node " + node_name(model, node), coordinate);
    }
  }
  [[nodiscard]] std::size_t of(const NodeName& name) const {
    const auto found = numbers_.find(name.text());
    if (found == numbers_.end()) check_.that(false, "there is no node " + name.text() + ".", "Give it in .nodes.");
    return found->second;
  }

 private:
  const Check& check_;
  std::unordered_map<std::string, std::size_t> numbers_;
};

// Unknowns of one motion: free, held, or weights times the motions of a level.
struct Binding {
  static constexpr int free = -2, held = -1;
  int level = free;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
};

// A motion of a node that a level, or the base, prescribes.
struct Prescribed {
  Index motion;
  int level = Binding::held;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
};

class Builder {
 public:
  Builder(const FiniteElements& model, const Check& check) : model_{model}, check_{check}, numbers_{model, check} {
    const auto motions = 6 * std::ssize(model.nodes);
    check.that(motions > 0, "it has no nodes.");
    check.that(!model.diaphragms.empty(), "it has no levels.", "Give the heights of its floors.");
    table_ = model.equations;
    if (model.equations.size() == 0) {
      table_.resize(motions, motions);
      table_.setIdentity();
    }
    table_.prune(0.0);
    check.that(table_.rows() == motions, "equations.rows()", static_cast<double>(table_.rows()), "",
               std::to_string(motions) + ", six for each of the nodes");
    level_of_.assign(model.nodes.size(), Binding::free);
    for (const FrameNode& node : model.nodes) lowest_ = std::min(lowest_, node.z.si());
  }

  Constraints build() {
    hold_plane();
    for (std::size_t level = 0; level < model_.diaphragms.size(); ++level) add_level(static_cast<int>(level));
    if (model_.feet != Feet::given) add_feet();
    name_unknowns();
    bind();
    fill_matrices();
    for (Level& level : result_.levels) level.height -= lowest_;
    return std::move(result_);
  }

 private:
  [[nodiscard]] double height_of(std::size_t node) const { return model_.nodes[node].z.si(); }
  void prescribe(std::size_t node, int motion, int level = Binding::held,
                 const Eigen::Vector3d& weights = Eigen::Vector3d::Zero()) {
    prescribed_.push_back({6 * static_cast<Index>(node) + motion, level, weights});
  }

  // On a line: the motion across it. A plane model is held in its plane at all nodes.
  void hold_plane() {
    if (model_.motion == LevelMotion::in_plan) return;
    result_.per_level = 1;
    along_ = model_.motion == LevelMotion::along_x ? 0 : 1;
    const auto place = [&](const FrameNode& node) { return along_ == 0 ? node.y.si() : node.x.si(); };
    const auto [least, most] = std::ranges::minmax(model_.nodes, {}, place);
    if (place(most) - place(least) > place_tolerance) return;
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      for (const int motion : {1 - along_, 3 + along_, turn}) prescribe(node, motion);
    result_.notes.push_back("All nodes lie in one plane: motions out of it are held.");
  }

  [[nodiscard]] std::vector<std::size_t> nodes_of(const FrameLevel& level, const std::string& name) const {
    std::vector<std::size_t> nodes;
    for (const NodeName& node : level.nodes) nodes.push_back(numbers_.of(node));
    if (!nodes.empty()) return nodes;
    check_.that(level.height.has_value(), "diaphragm " + name + " has neither a height nor nodes.");
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t node = 0; node < model_.nodes.size(); ++node) {
      const double distance = height_of(node) - level.height->si();
      if (std::abs(distance) <= place_tolerance) nodes.push_back(node);
      if (std::abs(distance) < std::abs(nearest)) nearest = distance;
    }
    check_.that(!nodes.empty(), "diaphragm " + name + " has no nodes within 1 mm of its height of " +
                                    to_text(level.height->si()) + " m; the nearest node lies at " +
                                    to_text(level.height->si() + nearest) + " m.");
    return nodes;
  }

  void add_level(int number) {
    const FrameLevel& level = model_.diaphragms[static_cast<std::size_t>(number)];
    std::string name = level.name;
    if (name.empty()) name = "floor " + std::to_string(number + (base_is_first_ ? 0 : 1));
    const std::vector<std::size_t> nodes = nodes_of(level, name);
    const auto [least, most] = std::ranges::minmax(nodes, {}, [&](std::size_t node) { return height_of(node); });
    const double low = height_of(least), high = height_of(most);
    check_.that(high - low <= place_tolerance,
                "diaphragm " + name + ": its nodes lie between " + to_text(low) + " and " + to_text(high) + " m.",
                "Nodes of a rigid floor have one height, within 1 mm.");
    if (number == 0 && low - lowest_ <= place_tolerance) {
      base_is_first_ = true;
      if (level.name.empty()) name = "base";
    }
    if (number > 0) {
      const Level& below = result_.levels.back();
      // Towers beside each other may have floors at one height.
      check_.that(
          low > below.height + place_tolerance || (!level.nodes.empty() && low > below.height - place_tolerance),
          "heights must rise: " + below.name + " at " + to_text(below.height) + " m, " + name + " at " + to_text(low) +
              " m.");
    }
    PlanVector centre{};
    for (const std::size_t node : nodes) {
      check_.that(level_of_[node] == Binding::free, "node " + node_name(model_, node) + " belongs to two diaphragms.");
      level_of_[node] = number;
      centre += PlanVector{model_.nodes[node].x.si(), model_.nodes[node].y.si()} / static_cast<double>(nodes.size());
    }
    for (const std::size_t node : nodes) {
      const double x = model_.nodes[node].x.si() - centre.x, y = model_.nodes[node].y.si() - centre.y;
      if (result_.per_level == 1) {
        prescribe(node, along_, number, {1.0, 0.0, 0.0});
        prescribe(node, 1 - along_);
        prescribe(node, turn);
      } else {
        prescribe(node, 0, number, {1.0, 0.0, -y});
        prescribe(node, 1, number, {0.0, 1.0, x});
        prescribe(node, turn, number, {0.0, 0.0, 1.0});
      }
    }
    result_.levels.push_back({name, low, 0.0, 0.0, centre});
  }

  void add_feet() {
    std::vector<std::size_t> feet;
    for (const NodeName& name : model_.foot_nodes) feet.push_back(numbers_.of(name));
    for (std::size_t node = 0; feet.empty() || (model_.foot_nodes.empty() && node < model_.nodes.size()); ++node)
      if (height_of(node) - lowest_ <= place_tolerance) feet.push_back(node);
    for (const std::size_t node : feet) {
      prescribe(node, 2);
      if (level_of_[node] == Binding::free)
        for (const int motion : {0, 1, turn}) prescribe(node, motion);
      if (model_.feet == Feet::clamped)
        for (const int motion : {3, 4}) prescribe(node, motion);
    }
    result_.notes.push_back(std::string{"Feet are "} + (model_.feet == Feet::clamped ? "clamped to" : "pinned on") +
                            " a base that is rigid in plan; it does not move vertically.");
  }

  void name_unknowns() {
    result_.names.resize(static_cast<std::size_t>(table_.cols()));
    for (Index motion = table_.rows(); motion-- > 0;)
      for (Rows::InnerIterator term{table_, motion}; term; ++term)
        result_.names[static_cast<std::size_t>(term.col())] = name_of(motion);
  }

  [[nodiscard]] std::string name_of(Index motion) const {
    return "node " + node_name(model_, static_cast<std::size_t>(motion / 6)) + ", " +
           motion_names[static_cast<std::size_t>(motion % 6)];
  }

  // A motion with one unknown that is free fixes it. One with several waits for others, as where the equations already
  // express a rigid floor.
  void bind() {
    bindings_.assign(static_cast<std::size_t>(table_.cols()), {});
    std::ranges::stable_partition(prescribed_, [](const Prescribed& each) { return each.motion % 6 == turn; });
    for (std::size_t before = prescribed_.size() + 1; prescribed_.size() < before;) {
      before = prescribed_.size();
      std::erase_if(prescribed_, [&](const Prescribed& each) { return settles(each); });
    }
    if (!prescribed_.empty())
      check_.that(false,
                  name_of(prescribed_[0].motion) + ": the floors do not determine the unknowns of its equation.");
  }

  bool settles(const Prescribed& prescribed) {
    Eigen::Vector3d rest = prescribed.weights;
    Binding* open = nullptr;
    double factor = 0.0;
    for (Rows::InnerIterator term{table_, prescribed.motion}; term; ++term) {
      Binding& unknown = bindings_[static_cast<std::size_t>(term.col())];
      if (unknown.level == Binding::free) {
        if (open != nullptr) return false;
        open = &unknown;
        factor = term.value();
      } else {
        rest -= term.value() * unknown.weights;
        if (unknown.level != Binding::held && unknown.level != prescribed.level) refuse(prescribed);
      }
    }
    if (open != nullptr)
      *open = {prescribed.level, rest / factor};
    else if (rest.lpNorm<Eigen::Infinity>() > place_tolerance)
      refuse(prescribed);
    return true;
  }

  void refuse(const Prescribed& prescribed) const {
    const std::string floor =
        prescribed.level < 0 ? "is held, but the equations of the model move it with a floor."
                             : "does not move with " + result_.levels[static_cast<std::size_t>(prescribed.level)].name +
                                   ": the equations of the model hold it, or move it otherwise.";
    check_.that(false, name_of(prescribed.motion) + ", " + floor);
  }

  void fill_matrices() {
    std::vector<Eigen::Triplet<double>> of_levels, of_others;
    for (Index unknown = 0; unknown < table_.cols(); ++unknown) {
      const auto& [level, weights] = bindings_[static_cast<std::size_t>(unknown)];
      if (level == Binding::free)
        of_others.emplace_back(unknown, std::ssize(of_others), 1.0);
      else if (level == Binding::held)
        result_.held.push_back(unknown);
      else
        for (int motion = 0; motion < result_.per_level; ++motion)
          if (weights[motion] != 0.0)
            of_levels.emplace_back(unknown, result_.per_level * level + motion, weights[motion]);
    }
    result_.of_levels.resize(table_.cols(), result_.per_level * std::ssize(result_.levels));
    result_.of_levels.setFromTriplets(of_levels.begin(), of_levels.end());
    result_.of_others.resize(table_.cols(), std::ssize(of_others));
    result_.of_others.setFromTriplets(of_others.begin(), of_others.end());
  }

  const FiniteElements& model_;
  const Check& check_;
  NodeNumbers numbers_;
  Rows table_;
  double lowest_ = std::numeric_limits<double>::infinity();
  int along_ = 0;
  bool base_is_first_ = false;
  std::vector<int> level_of_;
  std::vector<Prescribed> prescribed_;
  std::vector<Binding> bindings_;
  Constraints result_;
};

}  // namespace

Constraints constraints_of(const FiniteElements& model, const Check& check) { return Builder{model, check}.build(); }

}  // namespace moat
