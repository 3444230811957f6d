// The energy accounts of a block of links.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "elements/line/link_motion.hpp"
#include "materials/response.hpp"
#include "model/energy_accounts.hpp"

namespace moat {

/// Work and dissipation of one link, J.
struct TotalWork {
  double work = 0.0, dissipated = 0.0;  ///< J
};

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
template <ForceLaw Law>
class LinkEnergies {
 public:
  /// History of one element.
  using State = typename Law::State;

  /// Whether the law computes its dissipation from its states: it slides, independent of the rate.
  static constexpr bool hysteretic = requires(const Law& law, const State& state) {
    law.dissipated_energy(state, state);
  };

  /// Laws, states and motion at both ends of a step of `length` s; the states at its end are the trial ones.
  struct Step {
    const std::vector<Law>& laws;         ///< of all elements
    const std::vector<State>& committed;  ///< at the start
    const std::vector<State>& trial;      ///< at the end
    const LinkMotion& start;              ///< at the start
    const LinkMotion& end;                ///< at the end
    const std::vector<double>& forces;    ///< at the end, N
    double length;                        ///< s, >= 0
  };

  /// Whether start() was called.
  [[nodiscard]] bool kept() const { return kept_; }

  /// Makes room for more elements.
  void resize(std::size_t count) {
    if (!kept_) return;
    accounts_.resize(count);
    if constexpr (!is_linear) loads_.resize(count);
  }

  /// Starts all accounts at zero, in the state and motion of the committed instant.
  void start(const std::vector<Law>& laws, const std::vector<State>& committed, const LinkMotion& now,
             const std::vector<double>& forces) {
    kept_ = true;
    resize(laws.size());
    for (std::size_t i = 0; i < laws.size(); ++i) {
      accounts_[i] = {.stored_at_start = laws[i].stored_energy(committed[i], now.deformations[i])};
      if constexpr (!is_linear)
        loads_[i] = {forces[i], laws[i].dissipation_rate(committed[i], now.deformations[i], now.rates[i])};
    }
  }

  /// Adds work and dissipation of a step to every account.
  void add_step(const Step& step, WorkRule rule) {
    if (step.length > 0.0) {
      if (rule == WorkRule::mean_force)
        add_by_mean_force(step);
      else
        add_by_quadrature(step);
    }
    if constexpr (!is_linear)
      for (std::size_t i = 0; i < loads_.size(); ++i) loads_[i] = end_of(step, i);
  }

  /// A change of regime released stored energy, J.
  void release(std::size_t link, double energy) {
    if (kept_) accounts_[link].dissipated += energy;
  }

  /// Up to the last step.
  [[nodiscard]] TotalWork total_work(std::size_t link) const {
    return {accounts_[link].work, accounts_[link].dissipated};
  }
  /// Sets the total after a step that was integrated elsewhere.
  void set_total_work(std::size_t link, const TotalWork& total) {
    accounts_[link].work = total.work;
    accounts_[link].dissipated = total.dissipated;
  }
  /// `stored` J is the link's energy now.
  [[nodiscard]] ElementEnergy energy(std::size_t link, double stored) const {
    const Account& account = accounts_[link];
    return {account.work, stored - account.stored_at_start, account.dissipated, hysteretic};
  }

 private:
  static constexpr bool is_linear = LawWithConstantTangents<Law>;

  struct Account {
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0;
  };
  struct Load {
    double force = 0.0, power = 0.0;  // N, W
  };

  static double power(const Law& law, const State& state, const LinkMotion& motion, std::size_t i) {
    return hysteretic ? 0.0 : law.dissipation_rate(state, motion.deformations[i], motion.rates[i]);
  }
  // At the last commit.
  [[nodiscard]] Load start_of(const Step& step, std::size_t i) const {
    if constexpr (is_linear) {
      State after;
      const State& state = step.committed[i];
      const Response response =
          respond(step.laws[i], state, step.start.deformations[i], step.start.rates[i], {}, after);
      return {response.force, power(step.laws[i], state, step.start, i)};
    } else {
      return loads_[i];
    }
  }

  [[nodiscard]] static Load end_of(const Step& step, std::size_t i) {
    return {step.forces[i], power(step.laws[i], step.trial[i], step.end, i)};
  }

  void add_by_mean_force(const Step& step) {
    for (std::size_t i = 0; i < accounts_.size(); ++i) {
      Account& account = accounts_[i];
      const Load start = start_of(step, i), end = end_of(step, i);
      account.work += 0.5 * (start.force + end.force) * (step.end.deformations[i] - step.start.deformations[i]);
      if constexpr (hysteretic) {
        account.dissipated += step.laws[i].dissipated_energy(step.committed[i], step.trial[i]);
      } else {
        const HermiteCubic path = cubic_between(step.start, step.end, i, step.length);
        const double middle = step.laws[i].dissipation_rate(step.committed[i], path.value(0.5), path.rate(0.5));
        account.dissipated += step.length / 6.0 * (start.power + 4.0 * middle + end.power);
      }
    }
  }

  void add_by_quadrature(const Step& step) {
    constexpr std::array inside{0.27639320225002103, 0.72360679774997897};  // (1 -+ 1/sqrt(5))/2
    const double h = step.length;
    const std::array places{HermiteQuinticsAt{inside[0], h}, HermiteQuinticsAt{inside[1], h}};
    for (std::size_t i = 0; i < accounts_.size(); ++i) {
      const double d0 = step.start.deformations[i], v0 = step.start.rates[i], a0 = step.start.second_rates[i],
                   d1 = step.end.deformations[i], v1 = step.end.rates[i], a1 = step.end.second_rates[i];
      const Load start = start_of(step, i), end = end_of(step, i);
      double work = start.force * v0 + end.force * v1, dissipated = start.power + end.power;
      for (std::size_t k = 0; k < inside.size(); ++k) {
        const double deformation = places[k].value(d0, v0, a0, d1, v1, a1),
                     rate = places[k].rate(d0, v0, a0, d1, v1, a1);
        State after;
        const Response response =
            respond(step.laws[i], step.committed[i], deformation, rate, Interval{inside[k] * h, d0, v0}, after);
        work += 5.0 * response.force * rate;
        if constexpr (!hysteretic)
          dissipated += 5.0 * step.laws[i].dissipation_rate(step.committed[i], deformation, rate);
      }
      Account& account = accounts_[i];
      account.work += h / 12.0 * work;
      if constexpr (hysteretic)
        account.dissipated += step.laws[i].dissipated_energy(step.committed[i], step.trial[i]);
      else
        account.dissipated += h / 12.0 * dissipated;
    }
  }

  bool kept_ = false;
  std::vector<Account> accounts_;
  std::vector<Load> loads_;  // at the last commit; empty for linear laws, which have them from the motion
};

}  // namespace moat
