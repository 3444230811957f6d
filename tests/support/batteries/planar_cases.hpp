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

// Moves without time do not heat: the test of the law has its temperature.
template <>
inline std::vector<PlanarCase<Carrying<PlanarHeatedPendulum>>> planar_cases() {
  HeatedFrictionPendulum design = HeatedFrictionPendulum::typical();
  design.friction = PressureTemperatureVelocity{.reference_coefficient = 0.06,
                                                .reference_pressure = 20e6 * units::N / (units::m * units::m),
                                                .slider_radius = 10 * units::cm,
                                                .weakening = PressureTemperatureVelocity::Weakening::none};
  return {{in_plan(design, 1 * units::MN), {.move = 0.05, .force = 1e5}}};
}

// The sliders of a straight move turn one after another: pieces change their paths.
template <>
inline std::vector<PlanarCase<Carrying<PlanarSeriesOfSliders>>> planar_cases() {
  using namespace units;
  const PlanarTrial trial{.move = 0.02, .force = 1e5, .pieces = 0.0, .pieces_of_work = 200};
  TriplePendulum unequal = TriplePendulum::typical();
  unequal.lower_radius = 5 * m;
  unequal.upper_radius = 2.5 * m;
  return {{in_plan(DoublePendulum::typical(), 1 * MN), trial},
          {in_plan(TriplePendulum::typical(), 1 * MN), trial},
          {in_plan(unequal, 1 * MN), {.move = 0.3, .rate = 2.0, .force = 1e5, .energy = 1e-3, .pieces = 0.0}}};
}

template <>
inline std::vector<PlanarCase<Carrying<PlanarSliderUnderWeight>>> planar_cases() {
  using namespace units;
  std::vector<PlanarCase<Carrying<PlanarSliderUnderWeight>>> cases;
  for (const Friction& friction :
       {Friction{0.06}, Friction{VelocityDependent{.slow = 0.03, .fast = 0.06, .rate = 5 * s / m}}})
    cases.push_back({in_plan(FlatSlider{.friction = friction, .restoring_stiffness = 0.3 * MN / m}, 1 * MN),
                     {.move = 0.05, .force = 6e4, .energy = 1e-4}});
  return cases;
}

}  // namespace moat::testing
