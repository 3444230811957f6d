// The energy accounts of a block of links.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "elements/block/link_step.hpp"
#include "model/element_states.hpp"

namespace moat {

/// The places inside a step of Lobatto's rule with four points: (1 -+ 1/sqrt(5))/2.
inline constexpr std::array lobatto_inside{0.27639320225002103, 0.72360679774997897};

/// Work and dissipation of every link of a block, added up step by step.
///
///     work = integral of F d' dt        dissipated = integral of dissipation_rate dt
///
/// By WorkRule::mean_force the work of a step is the mean of the forces at its ends times the change of deformation,
/// and the dissipation follows Simpson's rule. By WorkRule::quadrature both follow Lobatto's rule with four points:
///
///     integral over h = h/12 (f(0) + 5 f(x1) + 5 f(1 - x1) + f(h)),   x1 = (1 - 1/sqrt(5))/2
///
/// with the law evaluated on the interpolated deformation. A law with dissipated_energy(from, to) gives its dissipation
/// exactly instead.
template <class Law>
class LinkEnergies {
 public:
  using State = typename Law::State;  ///< History of one element.
  using Vector = VectorOf<Law>;       ///< Deformations and forces.

  /// Whether the law computes its dissipation from its states: it slides, independent of the rate.
  static constexpr bool hysteretic = requires(const Law& law, const State& state) {
    law.dissipated_energy(state, state);
  };

  /// Whether start() was called.
  [[nodiscard]] bool kept() const { return kept_; }

  /// Starts all accounts at zero, in the state and motion of the committed instant.
  void start(const std::vector<Law>& laws, const std::vector<State>& committed, const LinkMotion<Vector>& now,
             const std::vector<Vector>& forces) {
    kept_ = true;
    accounts_.resize(laws.size());
    loads_.resize(laws.size());
    for (std::size_t i = 0; i < laws.size(); ++i) {
      accounts_[i] = {.stored_at_start = laws[i].stored_energy(committed[i], now.deformations[i])};
      loads_[i] = {forces[i], power(laws[i], committed[i], now.deformations[i], now.rates[i])};
    }
  }

  /// Adds work and dissipation of a step to every account.
  void add_step(const LinkStep<Law>& step, WorkRule rule) {
    const std::array places{HermiteQuinticsAt{lobatto_inside[0], step.length},
                            HermiteQuinticsAt{lobatto_inside[1], step.length}};
    for (std::size_t i = 0; i < accounts_.size(); ++i) {
      const Load end{step.forces[i], power(step.laws[i], step.trial[i], step.end.deformations[i], step.end.rates[i])};
      if (step.length > 0.0) {
        if (rule == WorkRule::mean_force)
          add_by_mean_force(i, step, end);
        else
          add_by_quadrature(i, step, end, places);
        if constexpr (hysteretic)
          accounts_[i].dissipated += step.laws[i].dissipated_energy(step.committed[i], step.trial[i]);
      }
      loads_[i] = end;
    }
  }

  /// A change of regime released stored energy, J.
  void release(std::size_t link, double energy) {
    if (kept_) accounts_[link].dissipated += energy;
  }
  /// Writes or reads all accounts.
  void archive(auto& archive) { archive(kept_, accounts_, loads_); }
  /// `stored` J is the link's energy now.
  [[nodiscard]] ElementEnergy energy(std::size_t link, double stored) const {
    const Account& account = accounts_[link];
    return {account.work, stored - account.stored_at_start, account.dissipated, hysteretic, 0.0, account.weight_work};
  }

 private:
  struct Account {
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0, weight_work = 0.0;
  };
  struct Load {
    Vector force{};      // N
    double power = 0.0;  // W
  };

  static constexpr bool under_axial_force = LinkStep<Law>::takes_axial_force;

  // A lifted bearing carries nothing, N.
  static double pressing(double compression) { return std::max(compression, 0.0); }
  // The power of a changing axial force, W.
  static double weight_power([[maybe_unused]] const Law& law, [[maybe_unused]] const State& state,
                             [[maybe_unused]] Vector deformation, [[maybe_unused]] Vector rate,
                             [[maybe_unused]] double compression_rate) {
    if constexpr (GivesWeightWork<Law, Vector>)
      return law.weight_power(state, deformation, rate, compression_rate);
    else if constexpr (under_axial_force)
      return state.compression > 0.0 ? compression_rate * law.weight_lever(state, deformation, state, deformation)
                                     : 0.0;
    else
      return 0.0;
  }

  static double power(const Law& law, const State& state, Vector deformation, Vector rate) {
    if constexpr (hysteretic)
      return 0.0;
    else
      return law.dissipation_rate(state, deformation, rate);
  }

  void add_by_mean_force(std::size_t i, const LinkStep<Law>& step, const Load& end) {
    accounts_[i].work +=
        dot(0.5 * (loads_[i].force + end.force), step.end.deformations[i] - step.start.deformations[i]);
    if constexpr (GivesWeightWork<Law, Vector>)
      accounts_[i].weight_work += step.laws[i].weight_work(step.committed[i], step.start.deformations[i], step.trial[i],
                                                           step.end.deformations[i]);
    else if constexpr (under_axial_force)
      accounts_[i].weight_work += (pressing(step.end_axial.values[i]) - pressing(step.start_axial.values[i])) *
                                  step.laws[i].weight_lever(step.committed[i], step.start.deformations[i],
                                                            step.trial[i], step.end.deformations[i]);
    if constexpr (!hysteretic) {
      const HermiteCubic path = cubic_between(step.start, step.end, i, step.length);
      const double middle = power(step.laws[i], step.committed[i], path.value(0.5), path.rate(0.5));
      accounts_[i].dissipated += step.length / 6.0 * (loads_[i].power + 4.0 * middle + end.power);
    }
  }

  void add_by_quadrature(std::size_t i, const LinkStep<Law>& step, const Load& end,
                         const std::array<HermiteQuinticsAt, 2>& places) {
    const double h = step.length;
    const Vector d0 = step.start.deformations[i], v0 = step.start.rates[i], a0 = step.start.second_rates[i],
                 d1 = step.end.deformations[i], v1 = step.end.rates[i], a1 = step.end.second_rates[i];
    double work = dot(loads_[i].force, v0) + dot(end.force, v1), dissipated = loads_[i].power + end.power,
           start_rate = 0.0;
    if constexpr (under_axial_force) start_rate = step.start_axial.rates[i];
    double weight_work = weight_power(step.laws[i], step.committed[i], d0, v0, start_rate) +
                         weight_power(step.laws[i], step.trial[i], d1, v1, step.compression_rate_at_end(i));
    for (std::size_t k = 0; k < places.size(); ++k) {
      const Vector deformation = places[k].value(d0, v0, a0, d1, v1, a1), rate = places[k].rate(d0, v0, a0, d1, v1, a1);
      State after;
      double compression_rate = 0.0;
      if constexpr (under_axial_force)
        compression_rate = compression_between(step.start_axial, step.end_axial, i, h).rate(lobatto_inside[k]);
      const ResponseOf<Law> response = step.respond(i, lobatto_inside[k], {deformation, rate}, after);
      weight_work += 5.0 * weight_power(step.laws[i], after, deformation, rate, compression_rate);
      work += 5.0 * dot(response.force, rate);
      dissipated += 5.0 * power(step.laws[i], step.committed[i], deformation, rate);
    }
    accounts_[i].work += h / 12.0 * work;
    accounts_[i].weight_work += h / 12.0 * weight_work;
    if constexpr (!hysteretic) accounts_[i].dissipated += h / 12.0 * dissipated;
  }

  bool kept_ = false;
  std::vector<Account> accounts_;
  std::vector<Load> loads_;  // at the last commit
};

}  // namespace moat
