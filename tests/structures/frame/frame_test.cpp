// Frames against closed forms: columns, portals, walls with offsets, beams in space.
#include "structures/frame/frame.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>
#include <numbers>

#include "base/units.hpp"
#include "message_of.hpp"
#include "plane_frames.hpp"
#include "structures/frame/member_stiffness.hpp"

namespace moat {
namespace {

using namespace units;
using testing::message_of;

constexpr ElasticMaterial steel{.E = 206 * GPa, .poisson = 0.3};
constexpr double E = 206e9, G = 206e9 / 2.6;

void expect_relative(double value, double expected, double tolerance = 1e-11) {
  EXPECT_NEAR(value / expected, 1.0, tolerance) << value << " against " << expected;
}

// One member from the origin, whose other end is the only node of a level.
Frame column(const MemberSection& section) {
  return {.nodes = {{}, {.z = 3 * m}},
          .members = {{.from = 1, .to = 2, .section = section, .material = steel}},
          .levels = {{.height = 3 * m}}};
}

TEST(Frame, ColumnHasTheStiffnessOfACantilever) {
  MemberSection section{.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 1.6e-3 * m_4, .torsion = 1.2e-3 * m_4};
  const Eigen::MatrixXd slender = column(section).condensed().stiffness;
  expect_relative(slender(0, 0), 3 * E * 1.6e-3 / 27);
  expect_relative(slender(1, 1), 3 * E * 8e-4 / 27);
  expect_relative(slender(2, 2), G * 1.2e-3 / 3);
  EXPECT_NEAR(slender(0, 1), 0.0, 1e-6);
  section.shear_area_y = section.shear_area_z = 0.012 * m_2;
  const Eigen::MatrixXd stocky = column(section).condensed().stiffness;
  expect_relative(stocky(0, 0), 1 / (27 / (3 * E * 1.6e-3) + 3 / (G * 0.012)));
  expect_relative(stocky(1, 1), 1 / (27 / (3 * E * 8e-4) + 3 / (G * 0.012)));
  EXPECT_NEAR(stocky(0, 0), 32828685.259, 1e-3);
}

TEST(Frame, ReferenceTurnsTheSection) {
  Frame turned = column({.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 1.6e-3 * m_4, .torsion = 1.2e-3 * m_4});
  turned.members[0].reference = {std::cos(0.3), std::sin(0.3), 0.0};
  const Eigen::MatrixXd k = turned.condensed().stiffness;
  const double k_1 = 3 * E * 1.6e-3 / 27, k_2 = 3 * E * 8e-4 / 27;
  expect_relative(k(0, 0), k_1 * std::pow(std::cos(0.3), 2) + k_2 * std::pow(std::sin(0.3), 2));
  expect_relative(k(0, 1), (k_1 - k_2) * std::cos(0.3) * std::sin(0.3));
}

TEST(Frame, ReleasedEndsCarryNoMoment) {
  // A column between a clamped foot and a cap that does not turn: 12 EI/h^3; 3 EI/h^3 with a hinge; none with two.
  const auto stiffness = [](EndReleases bottom, EndReleases top) {
    const PlacedMember placed =
        place_member({.from = 1,
                      .to = 2,
                      .section = {.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 1.6e-3 * m_4, .torsion = 1.2e-3 * m_4},
                      .material = steel,
                      .releases_from = bottom,
                      .releases_to = top},
                     Eigen::Vector3d::Zero(), {0.0, 0.0, 3.0}, "member 1", Check{"Frame", ""});
    return placed.stiffness;
  };
  const double k = E * 1.6e-3 / 27;
  expect_relative(stiffness({}, {})(6, 6), 12 * k);
  expect_relative(stiffness({.rz = true}, {})(6, 6), 3 * k);
  expect_relative(stiffness({}, {.rz = true})(6, 6), 3 * k);
  EXPECT_NEAR(stiffness({.rz = true}, {.rz = true})(6, 6), 0.0, 1e-6 * k);
  EXPECT_EQ(stiffness({.x = true}, {})(8, 8), 0.0);
  EXPECT_EQ(stiffness({.rx = true}, {})(11, 11), 0.0);
  expect_relative(stiffness({.rz = true}, {.rz = true})(7, 7), 12 * E * 8e-4 / 27);
}

TEST(Frame, PortalHasItsStiffnessInClosedForm) {
  const double h = 4, l = 4, A_c = 0.02, I_c = 8e-4, A_b = 0.015, I_b = 4.5e-4;
  const double S = 4 * E * I_c / h + 3 * E * I_b / l -
                   std::pow(3 * E * I_b / (l * l), 2) / (E * A_c / h + 3 * E * I_b / (l * l * l));
  const double k = 2 * (12 * E * I_c / (h * h * h) - std::pow(6 * E * I_c / (h * h), 2) / S);
  EXPECT_NEAR(k, 29161515.284, 1e-3);
  const MemberSection column{.area = A_c * m_2, .I_z = I_c * m_4}, beam{.area = A_b * m_2, .I_z = I_b * m_4};
  const CondensedStructure portal =
      testing::plane_frame({.storeys = {4 * m}, .bay = 8 * m, .bays = 1, .columns = {column}, .beam = beam})
          .condensed();
  ASSERT_EQ(portal.stiffness.size(), 1);
  EXPECT_FALSE(portal.in_plan);
  expect_relative(portal.stiffness(0, 0), k);
}

TEST(Frame, BentBeamInSpaceHasItsFlexibility) {
  // Clamped at the origin, 3 m along x, 2 m along y; 1e4 N up at the tip.
  const double a = 3, b = 2, P = 1e4, I = 5e-4, J = 4e-4;
  const MemberSection section{.area = 0.02 * m_2, .I_y = 3e-4 * m_4, .I_z = I * m_4, .torsion = J * m_4};
  const Frame beam{.nodes = {{}, {.x = 3 * m}, {.x = 3 * m, .y = 2 * m}},
                   .members = {{.from = 1, .to = 2, .section = section, .material = steel},
                               {.from = 2, .to = 3, .section = section, .material = steel}}};
  const Eigen::MatrixXd k = Eigen::MatrixXd{beam.finite_elements().stiffness}.bottomRightCorner(12, 12);
  Eigen::VectorXd load = Eigen::VectorXd::Zero(12);
  load[8] = P;
  const Eigen::VectorXd u = k.fullPivLu().solve(load);
  expect_relative(u[8], P * a * a * a / (3 * E * I) + P * b * b * b / (3 * E * I) + P * b * b * a / (G * J), 1e-10);
  expect_relative(u[9], P * b * b / (2 * E * I) + P * b * a / (G * J), 1e-10);
  expect_relative(u[10], -P * a * a / (2 * E * I), 1e-10);
}

TEST(Frame, CoupledWallsActThroughTheOffsetsOfTheirBeam) {
  const double h = 3.5, d = 2, l = 1, modulus = 30e9, shear = modulus / 2.4, A = 1.2, I = 0.3 * 64 / 12, A_s = A / 1.2;
  const double I_b = 0.3 * 0.216 / 12, A_sb = 0.15, phi = 12 * modulus * I / (shear * A_s * h * h);
  const double k11 = 12 * modulus * I / (h * h * h * (1 + phi)),
               kb = 1 / (l * l * l / (3 * modulus * I_b) + l / (shear * A_sb));
  const Eigen::Vector2d c{0.0, 6 * modulus * I / (h * h * (1 + phi))};
  Eigen::Matrix2d S;
  S << modulus * A / h + kb, kb * (l + d), kb * (l + d),
      (4 + phi) * modulus * I / (h * (1 + phi)) + kb * (l + d) * (l + d);
  const double k = 2 * (k11 - c.dot(S.inverse() * c));
  EXPECT_NEAR(k, 3745843372.84, 1e-2);
  const ElasticMaterial concrete{.E = 30 * GPa};
  const RectangularSection wall{.b = 0.3 * m, .h = 4 * m}, beam{.b = 0.3 * m, .h = 0.6 * m};
  Frame frame{.nodes = {{}, {.x = 6 * m}, {.z = 3.5 * m}, {.x = 6 * m, .z = 3.5 * m}},
              .members = {{.from = 1, .to = 3, .section = wall, .material = concrete},
                          {.from = 2, .to = 4, .section = wall, .material = concrete},
                          {.from = 3,
                           .to = 4,
                           .section = beam,
                           .material = concrete,
                           .offset_from = {.x = 2 * m},
                           .offset_to = {.x = -2 * m}}},
              .levels = {{.height = 3.5 * m}},
              .motion = LevelMotion::along_x};
  expect_relative(frame.condensed().stiffness(0, 0), k);
  frame.members.pop_back();
  expect_relative(frame.condensed().stiffness(0, 0), 3461746499.2, 1e-10);
}

TEST(Frame, LevelOnTheFeetIsCondensedToo) {
  // Three storeys, two bays, feet that turn freely; levels 0 to 3 of an independent program, MN/m.
  const CondensedStructure frame = testing::plane_frame({.storeys = {3.6 * m, 3.6 * m, 3.6 * m},
                                                         .bay = 6 * m,
                                                         .bays = 2,
                                                         .columns = {{.area = 0.02 * m_2, .I_z = 8e-4 * m_4}},
                                                         .beam = {.area = 0.015 * m_2, .I_z = 4.5e-4 * m_4},
                                                         .feet = Feet::pinned,
                                                         .base_is_level = true})
                                       .condensed();
  Eigen::Matrix4d expected;
  expected << 21.3804767, -37.9628117, 19.4322272, -2.8498923, -37.9628117, 116.8950943, -103.6743055, 24.7420229,
      19.4322272, -103.6743055, 155.4695352, -71.2274569, -2.8498923, 24.7420229, -71.2274569, 49.3353263;
  ASSERT_EQ(frame.stiffness.rows(), 4);
  EXPECT_LT((frame.stiffness / 1e6 - expected).cwiseAbs().maxCoeff(), 0.6e-7);
  EXPECT_LT(frame.stiffness.rowwise().sum().cwiseAbs().maxCoeff(), 1e-13 * frame.stiffness.norm());
  EXPECT_EQ(frame.levels[0].name, "base");
  EXPECT_EQ(frame.levels[3].name, "floor 3");
  EXPECT_DOUBLE_EQ(frame.levels[3].height, 10.8);
}

TEST(Frame, MembersWithDensityGiveHalfOfTheirMassToEachNode) {
  // Beams of a rectangle 6 m by 4 m, 0.3 m x 0.5 m, 2500 kg/m^3; columns without mass; a slab of 10 t at (1, 0).
  const RectangularSection beam{.b = 0.3 * m, .h = 0.5 * m};
  const ElasticMaterial light{.E = 30 * GPa}, heavy{.E = 30 * GPa, .density = 2500 * kg / m_3};
  Frame frame{.levels = {{.height = 3 * m,
                          .mass = 10 * tonne,
                          .rotary_inertia = 40 * tonne * m_2,
                          .centre_of_mass = PlanPosition{1 * m, 0 * m}}}};
  for (const Length z : {0 * m, 3 * m})
    for (const auto& [x, y] : {std::pair{0.0, 0.0}, {6.0, 0.0}, {6.0, 4.0}, {0.0, 4.0}})
      frame.nodes.push_back({.x = x * m, .y = y * m, .z = z});
  for (int i = 1; i <= 4; ++i) {
    frame.members.push_back({.from = i, .to = i + 4, .section = beam, .material = light});
    frame.members.push_back({.from = i + 4, .to = i % 4 + 5, .section = beam, .material = heavy});
  }
  const CondensedStructure condensed = frame.condensed();
  const double beams = 2500 * 0.15 * 20, x = (10e3 + beams * 3) / (10e3 + beams), y = beams * 2 / (10e3 + beams);
  EXPECT_NEAR(condensed.levels[0].mass, 10e3 + beams, 1e-9);
  EXPECT_NEAR(condensed.levels[0].centre_of_mass.x, x, 1e-12);
  EXPECT_NEAR(condensed.levels[0].centre_of_mass.y, y, 1e-12);
  const double J = 40e3 + 10e3 * (std::pow(1 - x, 2) + y * y) + beams * (13 + std::pow(3 - x, 2) + std::pow(2 - y, 2));
  EXPECT_NEAR(condensed.levels[0].rotary_inertia, J, 1e-9 * J);
  EXPECT_TRUE(
      condensed.mass.isApprox(Eigen::Vector3d{10e3 + beams, 10e3 + beams, J}.asDiagonal().toDenseMatrix(), 1e-12));
}

TEST(RectangularSection, HasItsProperties) {
  const MemberSection section = RectangularSection{.b = 0.2 * m, .h = 0.6 * m};
  EXPECT_DOUBLE_EQ(section.area.si(), 0.12);
  EXPECT_DOUBLE_EQ(section.I_z.si(), 0.2 * 0.216 / 12);
  EXPECT_DOUBLE_EQ(section.I_y.si(), 0.6 * 0.008 / 12);
  EXPECT_DOUBLE_EQ(section.shear_area_y.si(), 0.1);
  const MemberSection rigid = RectangularSection{.b = 0.2 * m, .h = 0.6 * m, .shear_deformation = false};
  EXPECT_EQ(rigid.shear_area_z.si(), 0.0);
  // Saint-Venant: J = s t^3/3 (1 - 192/pi^5 t/s sum tanh(n pi s/(2t))/n^5), n odd.
  for (const auto& [b, h] : {std::pair{1.0, 1.0}, {0.2, 0.6}, {2.0, 0.5}}) {
    const double s = std::max(b, h), t = std::min(b, h);
    double sum = 0.0;
    for (int n = 1; n < 40; n += 2) sum += std::tanh(n * pi * s / (2 * t)) / std::pow(n, 5);
    const double J = s * t * t * t / 3 * (1 - 192 / std::pow(pi, 5) * t / s * sum);
    const MemberSection rectangle = RectangularSection{.b = b * m, .h = h * m};
    expect_relative(rectangle.torsion.si(), J, 5e-3);
  }
}

TEST(Frame, BadInputIsRefused) {
  const auto message = [](auto change) {
    Frame frame = column({.area = 0.02 * m_2, .I_y = 8e-4 * m_4, .I_z = 8e-4 * m_4, .torsion = 1e-3 * m_4});
    frame.name = "shed";
    change(frame);
    return message_of([&] { return frame.condensed(); });
  };
  EXPECT_EQ(message([](Frame&) {}), "nothing was thrown");
  EXPECT_EQ(message([](Frame& f) { f.nodes[1].z = 0 * m; }),
            "Frame \"shed\": member 1: nodes 1 and 2 are at the same place. "
            "Give one of them another place, or the member other ends.");
  EXPECT_EQ(message([](Frame& f) {
              f.members[0].offset_from = {.z = 2.1 * m};
              f.members[0].offset_to = {.z = -1 * m};
            }),
            "Frame \"shed\": member 1: its offsets (3.1 m) are longer than it is (3 m). Offsets lead from its nodes "
            "inwards.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].releases_from.rx = f.members[0].releases_to.rx = true; }),
            "Frame \"shed\": member 1: all rotations about its axis are released. Release rx at one end.");
  EXPECT_EQ(message([](Frame& f) {
              f.members[0].releases_from = {.ry = true};
              f.members[0].releases_to = {.z = true, .ry = true};
            }),
            "Frame \"shed\": member 1: its releases make a mechanism of it. Leave out the last of them.");
  EXPECT_EQ(message([](Frame& f) {
              f.members[0].reference = {0.0, 0.0, 2.0};
            }),
            "Frame \"shed\": member 1: its reference direction is parallel to it. Give a direction across the member.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].to = 3; }),
            "Frame \"shed\": member 1: there is no node 3. Give it in .nodes.");
  EXPECT_EQ(message([](Frame& f) { f.nodes[1].name = 1; }),
            "Frame \"shed\": node 1 is given twice. Give every node a name of its own.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].to = 1; }),
            "Frame \"shed\": member 1: nodes 1 and 1 are at the same place. "
            "Give one of them another place, or the member other ends.");
  EXPECT_EQ(message([](Frame& f) { f.members.clear(); }), "Frame \"shed\": it has no members. Give them in .members.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].section.area = Area{}; }),
            "Frame \"shed\": member 1 section.area = 0 m^2 is not allowed; it must be > 0 m^2 and finite. Check its "
            "sign and its unit.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].section.I_y = -1.0 * m_4; }),
            "Frame \"shed\": member 1 section.I_y = -1 m^4 is not allowed; it must be >= 0 m^4 and finite. Check its "
            "sign and its unit.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].material.E = Modulus{}; }),
            "Frame \"shed\": member 1 material.E = 0 Pa is not allowed; it must be > 0 Pa and finite. Check its sign "
            "and its unit.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].material.poisson = 0.6; }),
            "Frame \"shed\": member 1 material.poisson = 0.6 is not allowed; it must be > -1 and <= 0.5. Give a number "
            "in this range.");
  EXPECT_EQ(message([](Frame& f) { f.members[0].material.density = -1.0 * kg / m_3; }),
            "Frame \"shed\": member 1 material.density = -1 kg/m^3 is not allowed; it must be >= 0 kg/m^3 and finite. "
            "Check its sign and its unit.");
  EXPECT_EQ(message_of([] { return static_cast<MemberSection>(RectangularSection{.b = 0 * m, .h = 1 * m}); }),
            "RectangularSection: b = 0 m is not allowed; it must be > 0 m and finite. Check its sign and its unit.");
}

}  // namespace
}  // namespace moat
