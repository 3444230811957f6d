#include "structures/frame/constraints.hpp"

#include <algorithm>
#include <array>

namespace moat {
namespace {

using SparseRows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Index = Eigen::Index;

constexpr double place_tolerance = 1e-3;  // m
constexpr int turn = 5;                   // rotation about z

// An unknown, or a motion of a node: free, held, or weights times the motions of a level.
struct Binding {
  static constexpr int free = -2, held = -1;
  int level = held;
  Eigen::Vector3d weights = Eigen::Vector3d::Zero();
  Index motion = 0;  // of a node
};

class Builder {
 public:
  Builder(const FiniteElements& model, const NodeNumbers& numbers, const Check& check)
      : model_{model}, check_{check}, numbers_{numbers} {
    const auto motions = 6 * std::ssize(model.nodes);
    check.that(motions > 0, "it has no nodes.", "Give them in .nodes.");
    check.that(!model.diaphragms.empty(), "it has no levels.", "Give the heights of its floors.");
    table_ = model.equations;
    if (model.equations.size() == 0) {
      table_.resize(motions, motions);
      table_.setIdentity();
    }
    table_.prune(0.0);
    check.that(table_.rows() == motions, "equations.rows()", static_cast<double>(table_.rows()), "",
               std::to_string(motions) + ", six for each of the nodes");
    result_.equations = table_;
    result_.level_of_node.assign(model.nodes.size(), -1);
    result_.lowest = std::ranges::min(model.nodes, {}, &FrameNode::z).z.si();
  }

  Constraints build() {
    hold_plane();
    for (const FrameLevel& level : model_.diaphragms) add_level(level);
    if (model_.feet != Feet::given) add_feet();
    result_.motions.assign(static_cast<std::size_t>(table_.cols()), 0);
    for (Index motion = table_.rows(); motion-- > 0;)
      for (SparseRows::InnerIterator term{table_, motion}; term; ++term)
        result_.motions[static_cast<std::size_t>(term.col())] = motion;
    bind();
    sort_unknowns();
    return std::move(result_);
  }

 private:
  [[nodiscard]] double height_of(std::size_t node) const { return model_.nodes[node].z.si() - result_.lowest; }
  void prescribe(std::size_t node, int motion, Binding binding = {}) {
    binding.motion = 6 * static_cast<Index>(node) + motion;
    prescribed_.push_back(binding);
  }

  // On a line: the motion across it. A plane model is held in its plane at all nodes.
  void hold_plane() {
    if (model_.motion == LevelMotion::in_plan) return;
    result_.per_level = 1;
    along_ = model_.motion == LevelMotion::along_x ? 0 : 1;
    const auto [least, most] = std::ranges::minmax(model_.nodes, {}, along_ == 0 ? &FrameNode::y : &FrameNode::x);
    if ((along_ == 0 ? most.y - least.y : most.x - least.x).si() > place_tolerance) return;
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      for (const int motion : {1 - along_, 3 + along_, turn}) prescribe(node, motion);
    result_.notes.push_back("All nodes lie in one plane: motions out of it are held.");
  }

  [[nodiscard]] std::vector<std::size_t> nodes_of(const FrameLevel& level, const std::string& name) const {
    std::vector<std::size_t> nodes;
    for (const NodeName& node : level.nodes) nodes.push_back(numbers_.of(node));
    if (!nodes.empty()) return nodes;
    check_.that(level.height.has_value(), "diaphragm " + name + " has neither a height nor nodes.");
    const auto distance = [&](const FrameNode& node) { return std::abs((node.z - *level.height).si()); };
    for (std::size_t node = 0; node < model_.nodes.size(); ++node)
      if (distance(model_.nodes[node]) <= place_tolerance) nodes.push_back(node);
    check_.that(!nodes.empty(),
                "diaphragm " + name + " has no nodes within 1 mm of its height of " + to_text(level.height->si()) +
                    " m; the nearest node lies at " + to_text(std::ranges::min(model_.nodes, {}, distance).z.si()) +
                    " m.",
                "Give the height of its nodes, or the nodes themselves.");
    return nodes;
  }

  void add_level(const FrameLevel& level) {
    const bool on_base = level.tower.empty() && !result_.levels.empty() && result_.levels[0].height <= place_tolerance;
    const auto number = std::ranges::count(result_.levels, level.tower, &Level::tower) + (on_base ? 0 : 1);
    std::string name = level.name;
    if (name.empty()) name = (level.tower.empty() ? "" : level.tower + " ") + "floor " + std::to_string(number);
    const std::vector<std::size_t> nodes = nodes_of(level, name);
    const auto [least, most] = std::ranges::minmax(nodes, {}, [&](std::size_t node) { return height_of(node); });
    const double low = height_of(least), high = height_of(most);
    const auto level_text = [&](double height) { return to_text(height + result_.lowest); };
    check_.that(high - low <= place_tolerance,
                "diaphragm " + name + ": its nodes lie between " + level_text(low) + " and " + level_text(high) + " m.",
                "Nodes of a rigid floor have one height, within 1 mm.");
    if (result_.levels.empty() && low <= place_tolerance && level.name.empty()) name = "base";
    result_.levels.push_back({.name = name, .tower = level.tower, .height = low});
    const auto number_of_level = static_cast<int>(result_.levels.size()) - 1;
    PlanVector& centre = result_.levels.back().centre_of_mass;
    for (const std::size_t node : nodes) {
      int& its_level = result_.level_of_node[node];
      check_.that(its_level < 0, "node " + numbers_.name(node) + " belongs to two diaphragms.");
      its_level = number_of_level;
      centre += PlanVector{model_.nodes[node].x.si(), model_.nodes[node].y.si()} / static_cast<double>(nodes.size());
    }
    if (const int below = level_below(result_.levels, result_.levels.size() - 1); below >= 0) {
      const Level& lower = result_.levels[static_cast<std::size_t>(below)];
      check_.that(low > lower.height + place_tolerance,
                  "heights must rise: " + lower.name + " at " + level_text(lower.height) + " m, " + name + " at " +
                      level_text(low) + " m.",
                  "Towers beside each other have levels of their own: give .tower.");
    }
    for (const std::size_t node : nodes) {
      const double x = model_.nodes[node].x.si() - centre.x, y = model_.nodes[node].y.si() - centre.y;
      if (result_.per_level == 1) {
        prescribe(node, along_, {number_of_level, {1.0, 0.0, 0.0}});
        for (const int motion : {1 - along_, turn}) prescribe(node, motion);
      } else {
        prescribe(node, 0, {number_of_level, {1.0, 0.0, -y}});
        prescribe(node, 1, {number_of_level, {0.0, 1.0, x}});
        prescribe(node, turn, {number_of_level, {0.0, 0.0, 1.0}});
      }
    }
  }

  void add_feet() {
    const FrameLevel feet{.height = Length{result_.lowest}, .nodes = model_.foot_nodes};
    for (const std::size_t node : nodes_of(feet, "of feet"))
      for (const int motion : {0, 1, 2, 3, 4, turn}) {
        const bool bends = motion == 3 || motion == 4, of_level = motion != 2 && result_.level_of_node[node] >= 0;
        if (bends ? model_.feet == Feet::clamped : !of_level) prescribe(node, motion);
      }
    result_.notes.push_back(std::string{"Feet are "} + (model_.feet == Feet::clamped ? "clamped to" : "pinned on") +
                            " a base that is rigid in plan; it does not move vertically.");
  }

  // A motion with one unknown that is free fixes it. One with several waits for others, as where the equations already
  // express a rigid floor.
  void bind() {
    bindings_.assign(static_cast<std::size_t>(table_.cols()), {Binding::free});
    std::ranges::stable_partition(prescribed_, [](const Binding& each) { return each.motion % 6 == turn; });
    while (std::erase_if(prescribed_, [&](const Binding& each) { return settles(each); }) > 0) continue;
    if (!prescribed_.empty())
      check_.that(false, numbers_.motion_name(prescribed_[0].motion) +
                             ": the floors do not determine the unknowns of its equation.");
  }

  bool settles(const Binding& prescribed) {
    const int level = prescribed.level;
    Eigen::Vector3d rest = prescribed.weights;
    Binding* open = nullptr;
    double factor = 0.0;
    bool follows = true;
    for (SparseRows::InnerIterator term{table_, prescribed.motion}; term; ++term) {
      Binding& unknown = bindings_[static_cast<std::size_t>(term.col())];
      if (unknown.level != Binding::free) {
        rest -= term.value() * unknown.weights;
        follows = follows && (unknown.level == Binding::held || unknown.level == level);
      } else if (open != nullptr) {
        return false;
      } else {
        open = &unknown;
        factor = term.value();
      }
    }
    if (open != nullptr)
      *open = {level, rest / factor};
    else
      follows = follows && rest.lpNorm<Eigen::Infinity>() <= place_tolerance;
    check_.that(follows, numbers_.motion_name(prescribed.motion) + ", does not move with " +
                             (level < 0 ? "the base" : result_.levels[static_cast<std::size_t>(level)].name) +
                             ": the equations of the model hold it, or move it otherwise.");
    return true;
  }

  void sort_unknowns() {
    std::vector<Eigen::Triplet<double>> of_levels;
    for (Index unknown = 0; const Binding& binding : bindings_) {
      if (binding.level < 0) (binding.level == Binding::free ? result_.others : result_.held).push_back(unknown);
      for (int motion = 0; binding.level >= 0 && motion < result_.per_level; ++motion)
        if (const double weight = binding.weights[motion]; weight != 0.0)
          of_levels.emplace_back(unknown, result_.per_level * binding.level + motion, weight);
      ++unknown;
    }
    result_.of_levels.resize(table_.cols(), result_.per_level * std::ssize(result_.levels));
    result_.of_levels.setFromTriplets(of_levels.begin(), of_levels.end());
  }

  const FiniteElements& model_;
  const Check& check_;
  const NodeNumbers& numbers_;
  SparseRows table_;
  int along_ = 0;
  std::vector<Binding> prescribed_, bindings_;
  Constraints result_;
};

}  // namespace

NodeNumbers::NodeNumbers(const std::vector<FrameNode>& nodes, const Check& check) : nodes_{nodes}, check_{check} {
  numbers_.reserve(nodes.size());
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    check.that(numbers_.emplace(name(node), node).second, "node " + name(node) + " is given twice.",
               "Give every node a name of its own.");
    for (const Length& coordinate : {nodes[node].x, nodes[node].y, nodes[node].z})
      check.finite("a coordinate of node " + name(node), coordinate);
  }
}

std::string NodeNumbers::name(std::size_t node) const {
  const std::string& name = nodes_[node].name.text();
  return name.empty() ? std::to_string(node + 1) : name;
}

std::size_t NodeNumbers::of(const NodeName& name, const std::string& whose) const {
  const auto found = numbers_.find(name.text());
  check_.that(found != numbers_.end(), whose + "there is no node " + name.text() + ".", "Give it in .nodes.");
  return found->second;
}

std::string NodeNumbers::motion_name(Eigen::Index motion) const {
  constexpr std::array names{"x", "y", "z", "rotation about x", "rotation about y", "rotation about z"};
  return "node " + name(static_cast<std::size_t>(motion / 6)) + ", " + names[static_cast<std::size_t>(motion % 6)];
}

Constraints constraints_of(const FiniteElements& model, const NodeNumbers& nodes, const Check& check) {
  return Builder{model, nodes, check}.build();
}

}  // namespace moat
