#include "materials/contact/equivalent_stiffness.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/check.hpp"
#include "base/root.hpp"
#include "materials/contact/restitution_formulas.hpp"

namespace moat {
namespace {

// m v^2, J.
double check_approach(const Check& check, const Approach& approach) {
  check.positive("mass", approach.mass);
  check.positive("speed", approach.speed,
                 "The equivalent of a Hertz stiffness depends on the speed; take that of the table of impacts.");
  return approach.mass.si() * approach.speed.si() * approach.speed.si();
}

double factor_of(Equal equal) {
  if (equal == Equal::force) return std::pow(1.25, 1.2);
  if (equal == Equal::indentation) return std::pow(0.8, 0.8);
  // Where k, m, v are 1, a linear contact lasts pi.
  const double ratio = std::numbers::pi / elastic_hertz_duration(1.0, 1.0, 1.0);
  return ratio * ratio;
}

}  // namespace

Stiffness linear_stiffness(HertzStiffness stiffness, const Approach& approach, Equal equal) {
  const Check check{"linear_stiffness", ""};
  check.positive("stiffness", stiffness);
  const double energy = check_approach(check, approach);
  return Stiffness{factor_of(equal) * std::pow(stiffness.si(), 0.8) * std::pow(energy, 0.2)};
}

HertzStiffness hertz_stiffness(Stiffness stiffness, const Approach& approach, Equal equal) {
  const Check check{"hertz_stiffness", ""};
  check.positive("stiffness", stiffness);
  const double energy = check_approach(check, approach);
  return HertzStiffness{std::pow(stiffness.si() / (factor_of(equal) * std::pow(energy, 0.2)), 1.25)};
}

HertzStiffness in_series(HertzStiffness local, Stiffness behind, const Approach& approach) {
  const Check check{"in_series", ""};
  check.positive("local", local);
  check.positive("behind", behind);
  const double energy = check_approach(check, approach), k_h = local.si(), k = behind.si();
  const double of_local = std::pow(k_h, 0.4) * std::pow(1.25 * energy, 0.6), of_behind = std::sqrt(k * energy);
  const double force = root_between(
      [&](double f) {
        return 0.4 * std::pow(f, 5.0 / 3.0) / std::pow(k_h, 2.0 / 3.0) + 0.5 * f * f / k - 0.5 * energy;
      },
      0.0, 1.001 * std::min(of_local, of_behind));
  return HertzStiffness{std::pow(force, 2.5) / std::pow(1.25 * energy, 1.5)};
}

Time duration_of_free_impact(HertzStiffness stiffness, const Approach& approach) {
  const Check check{"duration_of_free_impact", ""};
  check.positive("stiffness", stiffness);
  check_approach(check, approach);
  return Time{elastic_hertz_duration(stiffness.si(), approach.mass.si(), approach.speed.si())};
}

}  // namespace moat
