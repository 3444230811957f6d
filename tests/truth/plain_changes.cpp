#include "plain_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <ostream>
#include <utility>

#include "moat_model.hpp"
#include "random_draws.hpp"
#include "random_model.hpp"

namespace moat::testing {
namespace {

// Returns the problem without the nodes for which `goes` holds, and without the elements at them.
template <class Goes>
PlainModel without_nodes(const PlainModel& plain, Goes goes) {
  std::vector<int> number;
  PlainModel left = plain;
  left.nodes.clear();
  for (const PlainNode& node : plain.nodes) {
    number.push_back(goes(node) ? plain_ground - 1 : static_cast<int>(left.nodes.size()));
    if (number.back() >= 0) left.nodes.push_back(node);
  }
  const auto renumber = [&](int& node) {
    if (node != plain_ground) node = number[static_cast<std::size_t>(node)];
    return node >= plain_ground;
  };
  const auto at_point = [&](PlainPoint& point) {
    const bool stays = renumber(point.node);
    return renumber(point.other) && stays;
  };
  const auto keep = [](auto& elements, auto stays) {
    std::erase_if(elements, [&](auto& each) { return !stays(each); });
  };
  const auto link = [&](auto& each) {
    const bool stays = renumber(each.lower);
    return renumber(each.upper) && stays;
  };
  keep(left.springs, link);
  keep(left.dashpots, link);
  keep(left.bearings, link);
  keep(left.gaps, [&](PlainGap& gap) {
    const bool stays = at_point(gap.left);
    return at_point(gap.right) && stays;
  });
  return left;
}

// Whether the ground holds every node.
bool is_held(const PlainModel& plain) {
  try {
    Transient{moat_model(plain), moat_motion(plain.motion)};
    return true;
  } catch (const InputError&) {
    return false;
  }
}

std::vector<DrawnPlain> smaller(const DrawnPlain& drawn) {
  const PlainModel& plain = drawn.model;
  std::vector<DrawnPlain> list;
  const auto add = [&](PlainModel model) {
    if (is_held(model)) list.push_back({drawn.seed, std::move(model)});
  };
  for (const char first : {'A', 'B', 'C', 'b', 'e'}) {
    PlainModel rest = without_nodes(plain, [&](const PlainNode& node) { return node.name[0] == first; });
    if (!rest.nodes.empty() && rest.nodes.size() < plain.nodes.size()) add(std::move(rest));
  }
  if (plain.gaps.size() > 1) add(without_gaps(plain));
  for (std::size_t i = 0; i < plain.gaps.size(); ++i) {
    PlainModel fewer = plain;
    fewer.gaps.erase(fewer.gaps.begin() + static_cast<std::ptrdiff_t>(i));
    add(std::move(fewer));
  }
  if (!plain.dashpots.empty()) {
    PlainModel undamped = plain;
    undamped.dashpots.clear();
    add(std::move(undamped));
  }
  if (plain.motion.samples.size() > 20) {
    PlainModel shorter = plain;
    shorter.motion.samples.resize(plain.motion.samples.size() / 2 + 1);
    shorter.end = static_cast<double>(shorter.motion.samples.size() - 1) * plain.motion.time_step;
    add(std::move(shorter));
  }
  return list;
}

template <class Item>
std::vector<std::size_t> shuffle(std::vector<Item>& items, RandomDraws& draws) {
  std::vector<std::size_t> order(items.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = items.size(); i > 1; --i)
    std::swap(order[i - 1], order[static_cast<std::size_t>(draws.integer(0, static_cast<int>(i) - 1))]);
  std::vector<Item> moved;
  for (const std::size_t from : order) moved.push_back(items[from]);
  items = std::move(moved);
  return order;
}

template <class Each>
void for_each_node(PlainModel& plain, Each each) {
  const auto links = [&](auto& elements) {
    for (auto& element : elements) {
      each(element.lower);
      each(element.upper);
    }
  };
  links(plain.springs);
  links(plain.dashpots);
  links(plain.bearings);
  for (PlainGap& gap : plain.gaps)
    for (int* node : {&gap.left.node, &gap.left.other, &gap.right.node, &gap.right.other}) each(*node);
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const DrawnPlain& drawn) {
  const PlainModel& plain = drawn.model;
  out << "random_model(" << drawn.seed << "), " << plain.motion.samples.size() << " samples every "
      << plain.motion.time_step << " s, end " << plain.end << " s\n";
  const auto name = [&](int node) { return node < 0 ? "ground" : plain.nodes[static_cast<std::size_t>(node)].name; };
  const auto ends = [&](const auto& element) { return name(element.lower) + " - " + name(element.upper); };
  for (const PlainNode& node : plain.nodes) out << "  " << node.name << ": " << node.mass << " kg\n";
  for (const PlainSpring& each : plain.springs)
    out << "  " << each.name << ", " << ends(each) << ": " << each.stiffness << " N/m, " << each.damping << " N s/m\n";
  for (const PlainDashpot& each : plain.dashpots)
    out << "  " << each.name << ", " << ends(each) << ": " << each.damping << " N s/m\n";
  for (const PlainBearing& each : plain.bearings)
    out << "  " << each.name << ", " << ends(each) << ": " << each.yield_force << " N, " << each.yield_displacement
        << " m, " << each.post_yield_stiffness << " N/m\n";
  for (const PlainGap& each : plain.gaps)
    out << "  " << each.name << ", " << name(each.left.node) << " - " << name(each.right.node) << ": " << each.clearance
        << " m, " << moat_law_name(each.law.kind) << " " << each.law.stiffness << ", e " << each.law.restitution
        << "\n";
  return out;
}

rc::Gen<DrawnPlain> plain_problems() {
  return drawn_by([](std::uint64_t seed) { return DrawnPlain{seed, random_model(seed)}; }, smaller);
}

Problem problem_of(const PlainModel& plain) {
  return {moat_model(plain), moat_motion(plain.motion), plain.end * units::s};
}

PlainModel mirrored(PlainModel plain) {
  for (double& sample : plain.motion.samples) sample = -sample;
  for (PlainNode& node : plain.nodes) {
    node.displacement = -node.displacement;
    node.velocity = -node.velocity;
  }
  for (PlainGap& gap : plain.gaps) std::swap(gap.left, gap.right);
  return plain;
}

PlainModel in_other_units(PlainModel plain, double mass, double time) {
  const double stiffness = mass / (time * time), damping = mass / time;
  for (PlainNode& node : plain.nodes) {
    node.mass *= mass;
    node.velocity /= time;
  }
  for (PlainSpring& spring : plain.springs) {
    spring.stiffness *= stiffness;
    spring.damping *= damping;
  }
  for (PlainDashpot& dashpot : plain.dashpots) dashpot.damping *= damping;
  for (PlainBearing& bearing : plain.bearings) {
    bearing.yield_force *= stiffness;
    bearing.post_yield_stiffness *= stiffness;
  }
  for (PlainGap& gap : plain.gaps) gap.law.stiffness *= stiffness;
  plain.motion.time_step *= time;
  plain.end *= time;
  for (double& sample : plain.motion.samples) sample /= time * time;
  return plain;
}

PlainModel in_another_order(const PlainModel& plain, std::uint64_t seed) {
  RandomDraws draws{seed};
  const auto is_wall = [&](std::size_t node) {
    return std::ranges::any_of(plain.springs, [&](const PlainSpring& spring) {
      return spring.kind == PlainSpring::Kind::wall && spring.upper == static_cast<int>(node);
    });
  };
  PlainModel other;
  std::vector<std::size_t> order;
  // A wall is drawn beside a node that exists.
  do {
    other = plain;
    order = shuffle(other.nodes, draws);
  } while (is_wall(order.front()));
  for_each_node(other, [&](int& node) {
    if (node == plain_ground) return;
    node = static_cast<int>(std::ranges::find(order, static_cast<std::size_t>(node)) - order.begin());
  });
  shuffle(other.springs, draws);
  shuffle(other.dashpots, draws);
  shuffle(other.bearings, draws);
  shuffle(other.gaps, draws);
  return other;
}

PlainModel without_gaps(PlainModel plain) {
  plain.gaps.clear();
  return plain;
}

PlainModel linear(PlainModel plain) {
  for (const PlainBearing& bearing : plain.bearings)
    plain.springs.push_back({bearing.name, PlainSpring::Kind::storey, bearing.lower, bearing.upper,
                             bearing.yield_force / bearing.yield_displacement, 0.0});
  plain.bearings.clear();
  return without_gaps(std::move(plain));
}

}  // namespace moat::testing
