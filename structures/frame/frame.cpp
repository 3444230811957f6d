#include "structures/frame/frame.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/vector.hpp"
#include "structures/frame/constraints.hpp"
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
  check.that(!members.empty(), "it has no members.", "Give them in .members.");
  const NodeNumbers numbers{nodes, check};
  const Eigen::Index size = 6 * std::ssize(nodes);
  Vector masses_of_motions = Vector::Zero(size);
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(144 * members.size());
  for (std::size_t i = 0; i < members.size(); ++i) {
    const FrameMember& member = members[i];
    const std::string member_name = member.name.empty() ? "member " + std::to_string(i + 1) : member.name;
    const auto number_of = [&](const NodeName& node) {
      return static_cast<Eigen::Index>(numbers.of(node, member_name + ": "));
    };
    const std::array ends{number_of(member.from), number_of(member.to)};
    const auto place = [&](Eigen::Index number) {
      const FrameNode& node = nodes[static_cast<std::size_t>(number)];
      return Eigen::Vector3d{node.x.si(), node.y.si(), node.z.si()};
    };
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

CondensedStructure Frame::condensed() const { return moat::condensed(finite_elements(), "Frame"); }

}  // namespace moat
