// Heat that flows from a lead core into the steel around it.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace moat {

/// The flow of heat J from a lead core into end plates and shims, by the history of its temperature T
/// (docs/explanation/equations.md):
///
///     J(t) = (k_s A/a) integral of y(t+ - s+) dT(s),   y(t+) = c + sum of c_j exp(-t+/tau_j),   t+ = alpha_s t/a^2
///          = (k_s A/a) [c T + sum of c_j (T - x_j)],   dx_j/dt+ = (T - x_j)/tau_j     x_j: temperatures of layers
///
/// For T ~ t+/(1 + t+/0.135), about that of a bearing that slides on, J is the flow of Kalpakidis & Constantinou
/// (2009), (k_s A/a) T [1/F(t+) + 1.274 (t_s/a) (t+)^(-1/3)]. c_j >= 0 were fitted to it by least squares of the
/// relative error at 160 times from t+ = 1e-4 to 100: within 0.23 % for F and 0.6 % for shims. As c_j >= 0, lead
/// without power only cools, and never below the start.
struct SteelAroundLead {
  static constexpr std::size_t size = 10;         ///< Number of layers.
  using Temperatures = std::array<double, size>;  ///< x_j, K; between 0 and the largest T so far

  double rate = 0.0;   ///< k_s/(a rho c h) >= 0 1/s, with the heat capacity of the lead
  double time = 1.0;   ///< a^2/alpha_s > 0 s
  double shims = 0.0;  ///< 1.274 t_s/a

  /// A step, s, in which the layers follow the mean of T at both ends. The lead loses lost() + share() (T1 - T0), K.
  class Step {
   public:
    /// A step of `length` s.
    Step(const SteelAroundLead& steel, double length) : flow_{steel.share(size) * length} {
      double tau = steel.time * shortest;
      for (std::size_t j = 0; j < size; ++j, tau *= ratio) {
        followed_[j] = -std::expm1(-length / tau);
        flows_[j] = steel.share(j) * tau * followed_[j];
        flow_ += flows_[j];
      }
    }
    /// Returns the flow out of the lead, W.
    [[nodiscard]] double lost(double temperature, const Temperatures& layers) const {
      double sum = flow_ * temperature;
      for (std::size_t j = 0; j < size; ++j) sum -= flows_[j] * layers[j];
      return sum;
    }
    /// Returns the share of the last temperature.
    [[nodiscard]] double share() const { return 0.5 * flow_; }
    /// Moves on by one step.
    void advance(double from, double to, Temperatures& layers) const {
      for (std::size_t j = 0; j < size; ++j) layers[j] += followed_[j] * (0.5 * (from + to) - layers[j]);
    }

   private:
    double flow_;
    Temperatures followed_, flows_;
  };

  /// The rate at which the lead cools, K/s.
  [[nodiscard]] double cooling(double temperature, const Temperatures& layers) const {
    double sum = share(size) * temperature;
    for (std::size_t j = 0; j < size; ++j) sum += share(j) * (temperature - layers[j]);
    return sum;
  }
  /// Leads lead and layers through a rest, s, in parts so short that the lead loses about 0.5 % in each.
  void rest(double length, double& temperature, Temperatures& layers) const {
    const double parts = std::ceil(length * rate * (1.0 + shims) / 0.005);
    if (parts < 1.0) return;
    const Step part{*this, length / parts};
    for (double i = 0.0; i < parts; ++i) {
      const double start = temperature;
      temperature -= part.lost(start, layers) / (1.0 + part.share());
      part.advance(start, temperature, layers);
    }
  }

 private:
  static constexpr double shortest = 3e-5, ratio = 5.0;  // tau_j = shortest ratio^j
  // c_j, and c at the end, for both terms.
  static constexpr std::array<double, size + 1> of_plates{137.74,  31.392,  14.794,  6.458,   2.5949, 1.188,
                                                          0.57745, 0.26105, 0.11217, 0.05949, 1.2081};
  static constexpr std::array<double, size + 1> of_shims{20.221,  7.3495,  4.4071,  2.5728,  1.3512, 0.76461,
                                                         0.53091, 0.39499, 0.23215, 0.20276, 0.17925};
  // The share of the temperature of the lead that flows away through c_j in a second, 1/s.
  [[nodiscard]] double share(std::size_t j) const { return rate * (of_plates[j] + shims * of_shims[j]); }
};

}  // namespace moat
