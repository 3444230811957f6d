// Every law of AllPlanarLaws as the battery tries it.
#pragma once

#include <vector>

#include "base/units.hpp"
#include "materials/plan/planar_laws.hpp"
#include "planar_battery.hpp"
#include "random_draws.hpp"
#include "random_spring.hpp"

namespace moat::testing {

template <PlanarLaw Law>
struct PlanarCase {
  Law law;
  PlanarTrial trial{};
};

/// A law with the parameters and sizes at which the battery tries it. The tests of all laws do not compile for a law of
/// AllPlanarLaws that has none here.
template <PlanarLaw Law>
std::vector<PlanarCase<Law>> planar_cases() = delete;

template <>
inline std::vector<PlanarCase<BiaxialBilinear>> planar_cases() {
  using namespace units;
  const PlanarTrial trial{.force = 2e5};
  return {{{.yield_force = 215 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m}, trial},
          {{.yield_force = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0 * N / m}, trial}};
}

template <>
inline std::vector<PlanarCase<BiaxialBoucWen>> planar_cases() {
  using namespace units;
  const PlanarTrial trial{.force = 2e5};
  return {
      {{.characteristic_strength = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 1.5 * MN / m},
       trial},
      {{.characteristic_strength = 200 * kN, .yield_displacement = 1 * cm, .post_yield_stiffness = 0 * N / m}, trial}};
}

template <>
inline std::vector<PlanarCase<BiaxialFrictionPendulum>> planar_cases() {
  using namespace units;
  std::vector<PlanarCase<BiaxialFrictionPendulum>> cases;
  for (const Friction& friction :
       {Friction{0.06}, Friction{VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 5 * s / m}}})
    cases.push_back({{FrictionPendulum{.radius = 3 * m, .friction = friction, .weight = 1 * MN}},
                     {.move = 0.05, .force = 6e4, .energy = 1e-4}});
  return cases;
}

template <>
inline std::vector<PlanarCase<BiaxialLinear>> planar_cases() {
  return {{{.stiffness = 2 * units::MN / units::m}, {.force = 4e4, .dissipates = false}}};
}

template <>
inline std::vector<PlanarCase<BiaxialGrantRubber>> planar_cases() {
  const PlanarTrial trial{.move = 0.04, .force = 1e4};
  std::vector<PlanarCase<BiaxialGrantRubber>> cases{{{GrantRubber::typical()}, trial}};
  RandomDraws draws{20261122};
  for (int i = 0; i < 4; ++i) cases.push_back({{random_spring<GrantRubber>(draws)}, trial});
  return cases;
}

}  // namespace moat::testing
