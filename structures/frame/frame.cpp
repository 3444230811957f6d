#include "structures/frame/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "base/vector.hpp"
#include "structures/frame/member_stiffness.hpp"

namespace moat {

RectangularSection::operator MemberSection() const {
  const Check check{"RectangularSection", ""};
  check.positive("b", b);
  check.positive("h", h);
  const double width = b.si(), depth = h.si(), area = width * depth;
  const double s = std::max(width, depth), t = std::min(width, depth), ratio = t / s;
  const Area shear_area{shear_deformation ? 5.0 / 6.0 * area : 0.0};
  return {.area = Area{area},
          .I_y = SecondMoment{area * width * width / 12.0},
          .I_z = SecondMoment{area * depth * depth / 12.0},
          .torsion = SecondMoment{s * t * t * t * (1.0 / 3.0 - 0.21 * ratio * (1.0 - std::pow(ratio, 4) / 12.0))},
          .shear_area_y = shear_area,
          .shear_area_z = shear_area};
}

FiniteElements Frame::finite_elements() const {
  const Check check{"Frame", name};
  check.that(!members.empty(), "it has no members.");
  std::unordered_map<std::string, Eigen::Index> numbers;
  std::vector<Eigen::Vector3d> places;
  for (const FrameNode& node : nodes) {
    const Eigen::Index number = std::ssize(places);
    numbers.emplace(node.name.text().empty() ? std::to_string(number + 1) : node.name.text(), number);
    places.emplace_back(node.x.si(), node.y.si(), node.z.si());
  }
  const Eigen::Index size = 6 * std::ssize(nodes);
  Vector masses_of_motions = Vector::Zero(size);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const FrameMember& member = members[i];
    const std::string member_name = member.name.empty() ? "member " + std::to_string(i + 1) : member.name;
    const auto number_of = [&](const NodeName& node) {
      const auto found = numbers.find(node.text());
      if (found == numbers.end()) check.that(false, member_name + ": there is no node " + node.text() + ".");
      return found->second;
    };
    const std::array<Eigen::Index, 2> ends{number_of(member.from), number_of(member.to)};
    const auto place = [&](Eigen::Index node) { return places[static_cast<std::size_t>(node)]; };
    const PlacedMember placed = place_member(member, place(ends[0]), place(ends[1]), member_name, check);
    const auto index = [&](int local) { return 6 * ends[local < 6 ? 0 : 1] + local % 6; };
    for (int row = 0; row < 12; ++row)
      for (int column = 0; column < 12; ++column)
        if (placed.stiffness(row, column) != 0.0)
          entries.emplace_back(index(row), index(column), placed.stiffness(row, column));
    const double mass = member.material.density.si() * member.section.area.si() * placed.length;
    for (const Eigen::Index end : ends)
      for (const int direction : {0, 1}) masses_of_motions[6 * end + direction] += 0.5 * mass;
  }
  SparseMatrix stiffness(size, size), mass(size, size);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  mass = masses_of_motions.asDiagonal();
  mass.prune(0.0);
  return {.name = name,
          .nodes = nodes,
          .stiffness = stiffness,
          .mass = mass,
          .diaphragms = levels,
          .feet = feet,
          .foot_nodes = foot_nodes,
          .motion = motion,
          .masses = masses};
}

CondensedStructure Frame::condensed() const { return moat::condensed(finite_elements(), Check{"Frame", name}); }

}  // namespace moat
