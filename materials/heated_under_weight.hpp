// A slider whose surface heats, under a weight that changes.
#pragma once

#include <algorithm>
#include <cmath>

#include "materials/heated_sliding_isolator.hpp"

namespace moat {

/// HeatedSlidingIsolator under the weight N of the instant: restoring stiffness N/R, friction mu N with the pressure of
/// N; the elastic stiffness k_0 is that of the static weight.
///
/// It slides, and ends to slide, as under a constant weight; sliding begins only while the rate pushes, o v > 0 with o
/// = sgn q. Where it sticks and N falls, so that |q| would exceed mu N while the rate does not push, the slip follows.
/// The product o s becomes the largest o d - mu N/k_0 in the step, of the parabola through value and rate at its start
/// and value at its end. Zero friction where it lifts, N <= 0.
struct HeatedUnderWeight {
  static constexpr std::string_view name = "HeatedUnderWeight";

  HeatedSlidingIsolator line;  ///< The law under the static weight.

  struct State {
    /// History of the slider.
    HeatedSlidingIsolator::State slider{};
    double compression = 0.0;  ///< N, of the instant
    signed char sheds = 0;     ///< sign of q where it sheds at the instant; else 0

    /// Whether the force jumps at a change of regime.
    [[nodiscard]] bool jumps_to(const State& next) const { return slider.jumps_to(next.slider); }
    friend bool operator==(const State&, const State&) = default;
  };
  static constexpr auto quantities = HeatedSlidingIsolator::quantities;

  Response evaluate(const State& committed, double deformation, double rate, Interval interval, AxialForce axial,
                    State& trial) const {
    const double weight = std::max(axial.compression, 0.0);
    const HeatedSlidingIsolator law = under(weight);
    trial.compression = axial.compression;
    trial.sheds = 0;
    Response response = law.evaluate(committed.slider, deformation, rate, interval, trial.slider);
    response.by_compression += line.restoring_stiffness / line.normal_force * deformation;
    if (committed.slider.direction != 0) return response;
    const double k0 = line.elastic_stiffness, h = interval.length;
    const HeatedSlidingIsolator::Surface surface = law.unheated(committed.slider, std::abs(rate));
    const double limit = surface.coefficient * weight,
                 start_limit = committed.compression > 0.0
                                   ? under(committed.compression).limit(committed.slider, std::abs(interval.start_rate))
                                   : limit;
    for (const double side : {-1.0, 1.0}) {
      // The largest o d - L/k_0 with its derivatives by the value at the end and by the slope at the start.
      const double start = side * interval.start_deformation - start_limit / k0, end = side * deformation - limit / k0,
                   slope = side * interval.start_rate * h - (limit - start_limit) / k0, bend = end - start - slope;
      const bool inside = slope > 0.0 && slope + 2.0 * bend < 0.0;
      const double at = inside ? -0.5 * slope / bend : 1.0;
      // The committed instant that is evaluated again sheds as its step did, from the slip at its end.
      const bool goes_on = h == 0.0 && committed.sheds == side && axial.compression <= committed.compression;
      const double largest = goes_on  ? side * committed.slider.slip + (start_limit - limit) / k0
                             : inside ? start + 0.5 * slope * at
                                      : end;
      if (!goes_on && ((!inside && side * rate > 0.0) || largest <= side * committed.slider.slip)) continue;
      const double by_end = at * at, by_limit = side * at, sign = rate < 0.0 ? -1.0 : 1.0;
      if (at == 1.0) trial.sheds = static_cast<signed char>(side);
      trial.slider.slip = side * largest;
      trial.slider.friction_force = k0 * (deformation - trial.slider.slip);
      response.force = law.restoring_stiffness * deformation + trial.slider.friction_force;
      response.stiffness = law.restoring_stiffness + k0 * (1.0 - by_end);
      response.damping = by_limit * surface.slope * weight * sign;
      response.by_compression += by_limit * (surface.coefficient + weight * surface.by_compression);
    }
    return response;
  }
  double force_rate(const State& state, double deformation, double rate, double second_rate,
                    double compression_rate) const {
    if (state.compression <= 0.0) return 0.0;
    const HeatedSlidingIsolator law = under(state.compression);
    const double by_spring = line.restoring_stiffness / line.normal_force * deformation * compression_rate;
    HeatedSlidingIsolator::State ignored;
    if (state.sheds == 0) {
      const int direction = state.slider.direction;
      if (direction == 0) return law.force_rate(state.slider, deformation, rate, second_rate) + by_spring;
      const HeatedSlidingIsolator::Surface surface = law.heat(state.slider, direction * rate, 0.0, ignored);
      return law.force_rate(state.slider, deformation, rate, second_rate) + by_spring +
             direction * (surface.coefficient + law.normal_force * surface.by_compression) * compression_rate;
    }
    const double speed = std::abs(rate), faster = rate < 0.0 ? -second_rate : second_rate;
    const HeatedSlidingIsolator::Surface surface = law.unheated(state.slider, speed);
    return law.restoring_stiffness * rate + by_spring +
           state.sheds * (law.rates_of(state.slider, speed, faster).coefficient * law.normal_force +
                          (surface.coefficient + law.normal_force * surface.by_compression) * compression_rate);
  }
  double stored_energy(const State& committed, double deformation) const {
    return under(committed.compression).stored_energy(committed.slider, deformation);
  }
  double dissipation_rate(const State& committed, double deformation, double rate) const {
    return under(committed.compression).dissipation_rate(committed.slider, deformation, rate);
  }
  double dissipated_energy(const State& from, const State& to) const {
    return line.dissipated_energy(from.slider, to.slider);
  }
  double linear_stiffness(StiffnessStage stage) const { return line.linear_stiffness(stage); }
  /// d(from) d(to)/(2 R), m: the work of a changing compression in a step is (N1 - N0) times it.
  double weight_lever(const State&, double from, const State&, double to) const {
    return 0.5 * line.restoring_stiffness / line.normal_force * from * to;
  }

  double regime_margin(const State& committed, double deformation, double rate, AxialForce axial) const {
    const double margin = under(axial.compression).regime_margin(committed.slider, deformation, rate);
    if (committed.slider.direction != 0) return margin;
    const double side = deformation < committed.slider.slip ? -1.0 : 1.0;
    return std::max(margin, -side * rate * HeatedSlidingIsolator::time_of_rate);
  }
  State next_regime(const State& committed, double deformation, double rate) const {
    return {under(committed.compression).next_regime(committed.slider, deformation, rate), committed.compression};
  }
  ReportedValue quantity(std::size_t index, const State& state, double deformation, double rate,
                         double second_rate) const {
    return under(state.compression).quantity(index, state.slider, deformation, rate, second_rate);
  }

 private:
  [[nodiscard]] HeatedSlidingIsolator under(double compression) const {
    HeatedSlidingIsolator law = line;
    law.normal_force = std::max(compression, 0.0);
    law.restoring_stiffness *= law.normal_force / line.normal_force;
    return law;
  }
};

}  // namespace moat
