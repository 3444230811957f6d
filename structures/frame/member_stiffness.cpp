#include "structures/frame/member_stiffness.hpp"

#include <Eigen/Geometry>
#include <cmath>

namespace moat {
namespace {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Matrix12 = Eigen::Matrix<double, 12, 12>;

void check_parameters(const FrameMember& member, const std::string& name, const Check& check) {
  const auto& [area, I_y, I_z, torsion, shear_area_y, shear_area_z] = member.section;
  const auto& [E, poisson, G, density] = member.material;
  const auto field = [&](const char* what) { return name + " " + what; };
  if (!(area.si() > 0.0 && std::isfinite(area.si()))) check.positive(field("section.area"), area);
  for (const auto& [what, value] : {std::pair{"I_y", I_y}, {"I_z", I_z}, {"torsion", torsion}})
    check.not_negative(name + " section." + what, value);
  check.not_negative(field("section.shear_area_y"), shear_area_y);
  check.not_negative(field("section.shear_area_z"), shear_area_z);
  check.positive(field("material.E"), E);
  check.above_up_to(field("material.poisson"), poisson, -1.0, 0.5, "");
  if (G) check.positive(field("material.G"), *G);
  check.not_negative(field("material.density"), density);
}

// Rows are the local axes.
Matrix3 local_axes(const FrameMember& member, const Vector3& x, const std::string& name, const Check& check) {
  Vector3 reference{member.reference[0], member.reference[1], member.reference[2]};
  if (reference.isZero(0.0)) reference = std::abs(x.z()) > 0.999999 ? Vector3::UnitX() : Vector3::UnitZ();
  const Vector3 z = x.cross(reference);
  check.that(z.norm() > 1e-6 * reference.norm(), name + ": its reference direction is parallel to it.",
             "Give a direction across the member.");
  Matrix3 axes;
  axes << x.transpose(), z.cross(x).normalized().transpose(), z.normalized().transpose();
  return axes;
}

// Adds the bending on (deflection, rotation) of both ends. Rotations count positive as the slope, times `sign`.
void add_bending(Matrix12& k, int deflection, int rotation, double sign, double EI, double GA, double L) {
  const double phi = GA > 0.0 ? 12.0 * EI / (GA * L * L) : 0.0, r = sign * L;
  Eigen::Matrix4d bending;
  bending << 12.0, 6.0 * r, -12.0, 6.0 * r, 6.0 * r, (4.0 + phi) * L * L, -6.0 * r, (2.0 - phi) * L * L, -12.0,
      -6.0 * r, 12.0, -6.0 * r, 6.0 * r, (2.0 - phi) * L * L, -6.0 * r, (4.0 + phi) * L * L;
  bending *= EI / (L * L * L * (1.0 + phi));
  const Eigen::Vector4i at{deflection, rotation, 6 + deflection, 6 + rotation};
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) k(at[i], at[j]) += bending(i, j);
}

Matrix12 local_stiffness(const FrameMember& member, double L) {
  const MemberSection& section = member.section;
  const double E = member.material.E.si();
  const double G = member.material.G ? member.material.G->si() : E / (2.0 * (1.0 + member.material.poisson));
  Matrix12 k = Matrix12::Zero();
  for (const auto& [motion, stiffness] : {std::pair{0, E * section.area.si() / L}, {3, G * section.torsion.si() / L}}) {
    k(motion, motion) = k(motion + 6, motion + 6) = stiffness;
    k(motion, motion + 6) = k(motion + 6, motion) = -stiffness;
  }
  add_bending(k, 1, 5, 1.0, E * section.I_z.si(), G * section.shear_area_y.si(), L);
  // About y a positive rotation lowers the slope of z.
  add_bending(k, 2, 4, -1.0, E * section.I_y.si(), G * section.shear_area_z.si(), L);
  return k;
}

// Condenses the motions that are released, one after the other.
void release(Matrix12& k, const FrameMember& member, const std::string& name, const Check& check) {
  int motion = 0;
  const Eigen::Matrix<double, 12, 1> whole = k.diagonal();
  for (const EndReleases& end : {member.releases_from, member.releases_to})
    for (const bool released : {end.x, end.y, end.z, end.rx, end.ry, end.rz}) {
      const int i = motion++;
      if (!released || whole[i] == 0.0) continue;
      check.that(i % 6 != 3 || k(i, i) > 1e-9 * whole[i], name + ": all rotations about its axis are released.",
                 "Release rx at one end.");
      check.that(k(i, i) > 1e-9 * whole[i], name + ": its releases make a mechanism of it.",
                 "Leave out the last of them.");
      const Eigen::Matrix<double, 12, 1> column = k.col(i);
      k -= column * column.transpose() / column[i];
      k.row(i).setZero();
      k.col(i).setZero();
    }
}

}  // namespace

PlacedMember place_member(const FrameMember& member, const Vector3& from, const Vector3& to, const std::string& name,
                          const Check& check) {
  check_parameters(member, name, check);
  const auto vector = [](const RigidOffset& offset) { return Vector3{offset.x.si(), offset.y.si(), offset.z.si()}; };
  const Vector3 offset_from = vector(member.offset_from), offset_to = vector(member.offset_to);
  const Vector3 whole = to - from, flexible = whole + offset_to - offset_from;
  const double distance = whole.norm();
  if (distance <= 1e-6)
    check.that(
        false,
        name + ": nodes " + member.from.value().text() + " and " + member.to.value().text() + " are at the same place.",
        "Give one of them another place, or the member other ends.");
  const double inwards = (offset_from - offset_to).dot(whole) / distance;
  if (!(inwards < (1.0 - 1e-9) * distance))
    check.that(false,
               name + ": its offsets (" + to_text(inwards) + " m) are longer than it is (" + to_text(distance) + " m).",
               "Offsets lead from its nodes inwards.");
  PlacedMember placed;
  placed.length = flexible.norm();
  Matrix12 local = local_stiffness(member, placed.length);
  release(local, member, name, check);
  // Local motions of both ends from those of the nodes: u_end = u + rotation x offset.
  const Matrix3 axes = local_axes(member, flexible / placed.length, name, check);
  Matrix12 ends = Matrix12::Zero();
  for (const int end : {0, 6}) {
    const Vector3& d = end == 0 ? offset_from : offset_to;
    Matrix3 lever;
    lever << 0.0, d.z(), -d.y(), -d.z(), 0.0, d.x(), d.y(), -d.x(), 0.0;
    ends.block<3, 3>(end, end) = axes;
    ends.block<3, 3>(end, end + 3) = axes * lever;
    ends.block<3, 3>(end + 3, end + 3) = axes;
  }
  placed.stiffness = ends.transpose() * local * ends;
  return placed;
}

}  // namespace moat
