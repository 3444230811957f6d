#include "structures/rayleigh_damping.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include "base/check.hpp"
#include "solvers/dense.hpp"

namespace moat {
namespace {

void check_ratio(const Check& check, const char* name, double ratio) {
  check.that(ratio >= 0.0 && ratio < 1.0, name, ratio, "1", ">= 0 and < 1", "5 % of critical is 0.05.");
}

// A factor below zero damps negatively on one side of the period at which a0/(2 w) + a1 w/2 vanishes.
void refuse_negative(const Check& check, const RayleighFactors& factors) {
  const double period = 2.0 * std::numbers::pi * std::sqrt(-factors.stiffness_factor / factors.mass_factor);
  check.that(factors.stiffness_factor >= 0.0,
             "these ratios at these periods mean negative damping between the periods 0 and " + to_text(period) + " s.",
             "Give a larger ratio at the shorter period.");
  check.that(factors.mass_factor >= 0.0,
             "these ratios at these periods mean negative damping of all periods above " + to_text(period) + " s.",
             "Give a larger ratio at the longer period.");
}

}  // namespace

RayleighFactors rayleigh_factors(double ratio, double first_angular_frequency, double second_angular_frequency) {
  const Check check{"RayleighDamping", ""};
  check_ratio(check, "ratio", ratio);
  check.positive("first angular frequency", first_angular_frequency, "1/s");
  check.positive("second angular frequency", second_angular_frequency, "1/s");
  const double sum = first_angular_frequency + second_angular_frequency;
  return {2.0 * ratio * first_angular_frequency * second_angular_frequency / sum, 2.0 * ratio / sum};
}

std::optional<RayleighFactors> given_factors(const RayleighDamping& damping) {
  const Check check{"RayleighDamping", ""};
  const auto& [ratio, ratios, periods, a0, a1] = damping;
  const bool has_ratios = ratios != std::array<double, 2>{}, has_periods = periods != std::array<Time, 2>{},
             has_factors = a0 != Frequency{} || a1 != Time{};
  check_ratio(check, "ratio", ratio);
  if (has_factors) {
    check.that(ratio == 0.0 && !has_ratios && !has_periods, "a0 or a1 is given together with ratios or periods.",
               "Give a0 and a1 alone.");
    check.not_negative("a0", a0);
    check.not_negative("a1", a1);
    return RayleighFactors{a0.si(), a1.si()};
  }
  check.that(!has_ratios || (has_periods && ratio == 0.0), "ratios are given without periods, or together with ratio.",
             "Give .ratios = {0.05, 0.03} with .periods = {T1, T2}, or one .ratio.");
  if (!has_periods) return std::nullopt;
  check.positive("periods[0]", periods[0]);
  check.positive("periods[1]", periods[1]);
  check.that(periods[0] != periods[1], "both periods are " + to_text(periods[0].si()) + " s.",
             "Give two different ones, usually those of the first two modes.");
  const double w1 = 2.0 * std::numbers::pi / periods[0].si(), w2 = 2.0 * std::numbers::pi / periods[1].si();
  if (!has_ratios) return rayleigh_factors(ratio, w1, w2);
  check_ratio(check, "ratios[0]", ratios[0]);
  check_ratio(check, "ratios[1]", ratios[1]);
  const double stiffness_factor = 2.0 * (ratios[0] * w1 - ratios[1] * w2) / ((w1 - w2) * (w1 + w2));
  // 2 z1 w1 - a1 w1^2 without the difference of large numbers.
  const double mass_factor = 2.0 * w1 * w2 * (ratios[1] * w1 - ratios[0] * w2) / ((w1 - w2) * (w1 + w2));
  const RayleighFactors factors{mass_factor, stiffness_factor};
  refuse_negative(check, factors);
  return factors;
}

RayleighFactors rayleigh_factors_of_chain(double ratio, std::span<const Mass> masses,
                                          std::span<const Stiffness> stiffnesses) {
  const Check check{"RayleighDamping", ""};
  check.that(!masses.empty() && masses.size() == stiffnesses.size(),
             "a chain needs at least one storey and one stiffness per mass.");
  check_ratio(check, "ratio", ratio);
  const auto count = static_cast<Eigen::Index>(masses.size());
  // M^-1/2 K M^-1/2 of a chain is tridiagonal.
  Eigen::VectorXd diagonal{count}, beside{count - 1};
  for (Eigen::Index i = 0; i < count; ++i) {
    const auto storey = static_cast<std::size_t>(i);
    const bool top = i + 1 == count;
    diagonal[i] = (stiffnesses[storey].si() + (top ? 0.0 : stiffnesses[storey + 1].si())) / masses[storey].si();
    if (!top) beside[i] = -stiffnesses[storey + 1].si() / std::sqrt(masses[storey].si() * masses[storey + 1].si());
  }
  const Eigen::VectorXd squared = eigenvalues_of_tridiagonal(diagonal, beside);
  const double first = std::sqrt(squared[0]);
  if (count == 1) return {0.0, 2.0 * ratio / first};
  return rayleigh_factors(ratio, first, std::sqrt(squared[1]));
}

}  // namespace moat
