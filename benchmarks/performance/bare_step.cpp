#include "performance/bare_step.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/units.hpp"
#include "performance/parabola_peak.hpp"
#include "structures/rayleigh_damping.hpp"

namespace moat::performance {
namespace {

using namespace units;

constexpr int size = 6;  // the base, then five floors
using Values = std::array<double, size>;

constexpr double base_mass = 550e3, floor_mass = 500e3, storey_stiffness = 1e9;
constexpr double yield_displacement = 0.01, post_yield = 19.3e6, sliding = 1.93e6 / yield_displacement - post_yield;
constexpr double clearance = 0.1, hertz = 2.95e9, restitution = 0.65;
constexpr double damping_factor = 0.75 * (1.0 - restitution * restitution);
constexpr double force_tolerance = 1e-10, location_tolerance = 1e-12, reload_threshold = 1e-9;
constexpr int max_iterations = 20;

enum class Phase { open, loaded, released };

struct Gap {
  double side;  // of the wall: +1 right, -1 left
  Phase phase = Phase::open;
  double approach_speed = 0.0;
  double indentation = 0.0, rate = 0.0, force = 0.0;
  double start_indentation = 0.0, start_rate = 0.0, start_force = 0.0, start_power = 0.0;
};

double push(const Gap& gap, double rate) {
  return 1.0 + damping_factor * std::clamp(rate / gap.approach_speed, -100.0, 100.0);
}

double margin(const Gap& gap, double indentation, double rate) {
  if (gap.phase == Phase::open) return -indentation;
  if (gap.phase == Phase::loaded) return std::min(indentation, push(gap, rate));
  return std::min(indentation, reload_threshold - push(gap, rate));
}

double dissipation_rate(const Gap& gap, double indentation, double rate) {
  if (gap.phase == Phase::open || indentation <= 0.0) return 0.0;
  const double elastic = hertz * indentation * std::sqrt(indentation);
  if (gap.phase == Phase::released) return std::max(-elastic * rate, 0.0);
  return elastic * (push(gap, rate) - 1.0) * rate;
}

double stored_energy(const Gap& gap, double indentation) {
  if (gap.phase == Phase::open || indentation <= 0.0) return 0.0;
  return 0.4 * hertz * indentation * indentation * std::sqrt(indentation);
}

// Deformation and rate on the cubic through both ends of a step.
struct Cubic {
  double start, start_rate, end, end_rate, step;

  [[nodiscard]] double margin_at(const Gap& gap, double x) const {
    const double rise = end - start;
    const double left = step * start_rate - rise, right = rise - step * end_rate;
    const double slope = rise + (1.0 - x) * (1.0 - 3.0 * x) * left + x * (2.0 - 3.0 * x) * right;
    return margin(gap, start + x * rise + x * (1.0 - x) * ((1.0 - x) * left + x * right), slope / step);
  }
  [[nodiscard]] double first_crossing(const Gap& gap, double beyond) const {
    double low = 0.0, high = beyond;
    for (int i = 0; i < 60; ++i) {
      const double middle = 0.5 * (low + high);
      (margin_at(gap, middle) > -0.5 * location_tolerance ? low : high) = middle;
    }
    return high;
  }
};

class Building {
 public:
  Building(const GroundMotion& motion, double step) : motion_{motion}, nominal_{step} {
    std::array<Mass, 5> masses;
    std::array<Stiffness, 5> stiffnesses;
    masses.fill(500 * tonne);
    stiffnesses.fill(1 * GN / m);
    const RayleighFactors rayleigh = rayleigh_factors_of_chain(0.05, masses, stiffnesses);
    storey_damping_ = rayleigh.stiffness_factor * storey_stiffness;
    floor_damping_ = rayleigh.mass_factor * floor_mass;
    mass_.fill(floor_mass);
    mass_[0] = base_mass;
    history_.rows.reserve((motion.samples().size() + 1) * (2 + channels + 6));
  }

  BareHistory run() {
    ground_ = motion_.acceleration_at(0.0);
    balance();
    follow(false);
    record();
    const double end = motion_.duration();
    while (time_ < end * (1.0 - 1e-12)) advance(end);
    for (const ParabolaPeak& tracker : trackers_) history_.peaks.push_back(tracker.magnitude());
    history_.largest_input = largest_input_;
    history_.largest_kinetic = largest_kinetic_;
    history_.integration_error = work_ - strain() - viscous_ - hysteretic_ - impact_;
    return std::move(history_);
  }

 private:
  static constexpr int channels = 3 * size + 2 * 5 + 2 + 2 * 2 + 1;

  // Forces at the trial state.
  void evaluate(const Values& u, const Values& v) {
    const double stretch = u[0] - slip_;
    const bool slides = std::abs(stretch) > yield_displacement;
    const double kept = slides ? std::copysign(yield_displacement, stretch) : stretch;
    trial_slip_ = slides ? u[0] - kept : slip_;
    bearing_force_ = post_yield * u[0] + sliding * kept;
    base_stiffness_ = slides ? post_yield : post_yield + sliding;
    base_damping_ = 0.0;
    double base_force = bearing_force_;
    for (Gap& gap : gaps_) {
      gap.indentation = gap.side * u[0] - clearance;
      gap.rate = gap.side * v[0];
      gap.force = 0.0;
      if (gap.phase != Phase::loaded || gap.indentation <= 0.0) continue;
      const double root = std::sqrt(gap.indentation), elastic = hertz * gap.indentation * root;
      const double factor = push(gap, gap.rate);
      gap.force = elastic * factor;
      base_force += gap.side * gap.force;
      base_stiffness_ += 1.5 * hertz * root * factor;
      if (std::abs(gap.rate) < 100.0 * gap.approach_speed)
        base_damping_ += elastic * damping_factor / gap.approach_speed;
    }
    force_[0] = base_force;
    for (int i = 1; i < size; ++i) {
      const double shear = storey_stiffness * (u[i] - u[i - 1]) + storey_damping_ * (v[i] - v[i - 1]);
      const double drag = floor_damping_ * (v[i] - v[0]);
      force_[i] = shear + drag;
      force_[i - 1] -= shear;
      force_[0] -= drag;
    }
  }

  // L D L^T from the roof down: the matrix is an arrow, floors in a chain and all beside the base.
  void factorise(double h) {
    if (h == factored_h_ && base_stiffness_ == factored_stiffness_ && base_damping_ == factored_damping_) return;
    ++history_.factorisations;
    factored_h_ = h;
    factored_stiffness_ = base_stiffness_;
    factored_damping_ = base_damping_;
    const double w = 0.25 * h * h, wv = 0.5 * h;
    const double storey = w * storey_stiffness + wv * storey_damping_, floor = wv * floor_damping_;
    double base = base_mass + w * base_stiffness_ + wv * base_damping_ + storey + 5.0 * floor;
    double below = floor_mass + storey + floor;  // diagonal of the floor at hand
    double beside = -floor;                      // its entry in the row of the base
    for (int i = size - 1; i >= 2; --i) {
      pivot_[i] = 1.0 / below;
      chain_[i] = -storey * pivot_[i];
      arrow_[i] = beside * pivot_[i];
      base -= beside * arrow_[i];
      const double next_beside = -floor - (i == 2 ? storey : 0.0) - beside * chain_[i];
      below = floor_mass + 2.0 * storey + floor + storey * chain_[i];
      beside = next_beside;
    }
    pivot_[1] = 1.0 / below;
    arrow_[1] = beside * pivot_[1];
    pivot_[0] = 1.0 / (base - beside * arrow_[1]);
  }

  void substitute(Values& x) const {
    for (int i = size - 1; i >= 2; --i) {
      x[i - 1] -= chain_[i] * x[i];
      x[0] -= arrow_[i] * x[i];
    }
    x[0] = (x[0] - arrow_[1] * x[1]) * pivot_[0];
    x[1] = x[1] * pivot_[1] - arrow_[1] * x[0];
    for (int i = 2; i < size; ++i) x[i] = x[i] * pivot_[i] - chain_[i] * x[i - 1] - arrow_[i] * x[0];
  }

  bool solve(double h, double end) {
    ++history_.solves;
    const double ground = motion_.acceleration_at(end);
    const double w = 0.25 * h * h, wv = 0.5 * h;
    Values predicted_u, predicted_v, residual;
    for (int i = 0; i < size; ++i) {
      predicted_u[i] = u_[i] + h * v_[i] + w * a_[i];
      predicted_v[i] = v_[i] + wv * a_[i];
    }
    trial_a_ = a_;
    double round_off = 0.0;
    for (int iteration = 0;; ++iteration) {
      for (int i = 0; i < size; ++i) {
        trial_u_[i] = predicted_u[i] + w * trial_a_[i];
        trial_v_[i] = predicted_v[i] + wv * trial_a_[i];
      }
      evaluate(trial_u_, trial_v_);
      double scale = 0.0, largest = 0.0;
      for (int i = 0; i < size; ++i) {
        const double inertia = mass_[i] * trial_a_[i], load = mass_[i] * ground;
        residual[i] = inertia + force_[i] + load;
        scale = std::max({scale, std::abs(inertia), std::abs(force_[i]), std::abs(load)});
        largest = std::max(largest, std::abs(residual[i]));
      }
      if (largest <= force_tolerance * scale || (largest <= round_off && largest <= 1e-6 * scale)) return true;
      if (iteration == max_iterations || !(scale < std::numeric_limits<double>::infinity())) return false;
      ++history_.newton_iterations;
      factorise(h);
      constexpr double last_digits = 8.0 * std::numeric_limits<double>::epsilon();
      round_off = last_digits * std::abs((base_stiffness_ + storey_stiffness) * trial_u_[0]);
      for (int i = 1; i < size; ++i)
        round_off = std::max(round_off, last_digits * std::abs(2.0 * storey_stiffness * trial_u_[i]));
      substitute(residual);
      for (int i = 0; i < size; ++i) trial_a_[i] -= residual[i];
    }
  }

  // Smallest margin at the end of the trial step; where a change lies inside, its fraction of the step (else 1).
  double scan(double h, double& fraction) const {
    double smallest = std::numeric_limits<double>::infinity();
    fraction = 1.0;
    for (const Gap& gap : gaps_) {
      const double end_margin = margin(gap, gap.indentation, gap.rate);
      smallest = std::min(smallest, end_margin);
      double beyond = 1.0;
      const Cubic cubic{gap.start_indentation, gap.start_rate, gap.indentation, gap.rate, h};
      if (end_margin >= 0.0) {
        if (gap.start_rate * gap.rate >= 0.0) continue;
        beyond = gap.start_rate / (gap.start_rate - gap.rate);
        if (cubic.margin_at(gap, beyond) >= 0.0) continue;
      }
      fraction = std::min(fraction, cubic.first_crossing(gap, beyond));
    }
    return smallest;
  }

  // Solves shorter steps until one ends just beyond the change; returns its length.
  double locate(double h, double end_margin, double fraction) {
    double before = 0.0, beyond = h, margin_before = 0.0, margin_beyond = end_margin;
    double next = fraction * h;
    for (int count = 0; count < 100; ++count) {
      if (!(next > before && next < beyond) || (count > 8 && count % 2 == 0)) next = 0.5 * (before + beyond);
      solve(next, time_ + next);
      const double found = scan(next, fraction);
      if (found < 0.0 && found >= -location_tolerance) return next;
      if (found < 0.0) {
        beyond = next;
        margin_beyond = found;
        next = fraction * beyond;
      } else {
        before = next;
        margin_before = found;
        next =
            before + (beyond - before) * (margin_before + 0.5 * location_tolerance) / (margin_before - margin_beyond);
      }
      if (beyond - before < 1e-15) return beyond;
    }
    return beyond;
  }

  void advance(double end) {
    const double target = std::min((std::floor(time_ / nominal_ + 1e-6) + 1.0) * nominal_, end);
    double h = std::abs(target - time_ - nominal_) < 1e-9 * nominal_ ? nominal_ : target - time_;
    double to = target;
    while (!solve(h, to)) to = time_ + (h *= 0.5);
    double fraction = 1.0;
    const double end_margin = scan(h, fraction);
    const bool changes = fraction < 1.0 || end_margin < 0.0;
    if (changes) {
      h = locate(h, end_margin, fraction);
      to = time_ + h;
    }
    account(h, motion_.acceleration_at(to));
    time_ = to;
    commit();
    ++history_.steps;
    follow(false);
    if (!changes && to == target && time_ >= static_cast<double>(next_row_) * motion_.time_step() * (1.0 - 1e-12))
      record();
    if (changes) change_phases();
  }

  static double simpson(double h, double rise, double start_rate, double end_rate, double damping) {
    const double middle = 1.5 * rise / h - 0.25 * (start_rate + end_rate);
    return h / 6.0 * damping * (start_rate * start_rate + 4.0 * middle * middle + end_rate * end_rate);
  }

  // Work of and dissipation in every element over the step, from the left values that are still committed.
  void account(double h, double ground) {
    const double mean_ground = 0.5 * (ground_ + ground);
    for (int i = 0; i < size; ++i) input_ -= mean_ground * mass_[i] * (trial_u_[i] - u_[i]);
    for (int i = 1; i < size; ++i) {
      const double before = u_[i] - u_[i - 1], after = trial_u_[i] - trial_u_[i - 1];
      work_ += 0.5 * storey_stiffness * (before + after) * (after - before);
      const double rate_before = v_[i] - v_[i - 1], rate_after = trial_v_[i] - trial_v_[i - 1];
      work_ += 0.5 * storey_damping_ * (rate_before + rate_after) * (after - before);
      viscous_ += simpson(h, after - before, rate_before, rate_after, storey_damping_);
      const double drag_before = v_[i] - v_[0], drag_after = trial_v_[i] - trial_v_[0];
      const double rise = (trial_u_[i] - trial_u_[0]) - (u_[i] - u_[0]);
      work_ += 0.5 * floor_damping_ * (drag_before + drag_after) * rise;
      viscous_ += simpson(h, rise, drag_before, drag_after, floor_damping_);
    }
    work_ += 0.5 * (start_bearing_force_ + bearing_force_) * (trial_u_[0] - u_[0]);
    hysteretic_ += sliding * yield_displacement * std::abs(trial_slip_ - slip_);
    for (Gap& gap : gaps_) {
      const double power = dissipation_rate(gap, gap.indentation, gap.rate);
      const double rise = gap.indentation - gap.start_indentation;
      work_ += 0.5 * (gap.start_force + gap.force) * rise;
      if (gap.phase != Phase::open) {
        const double middle = gap.start_indentation + 0.5 * rise + 0.125 * h * (gap.start_rate - gap.rate);
        const double middle_rate = 1.5 * rise / h - 0.25 * (gap.start_rate + gap.rate);
        impact_ += h / 6.0 * (gap.start_power + 4.0 * dissipation_rate(gap, middle, middle_rate) + power);
      }
      gap.start_power = power;
    }
    ground_ = ground;
  }

  void commit() {
    u_ = trial_u_;
    v_ = trial_v_;
    a_ = trial_a_;
    slip_ = trial_slip_;
    start_bearing_force_ = bearing_force_;
    for (Gap& gap : gaps_) {
      gap.start_indentation = gap.indentation;
      gap.start_rate = gap.rate;
      gap.start_force = gap.force;
    }
    double kinetic = 0.0;
    for (int i = 0; i < size; ++i) kinetic += 0.5 * mass_[i] * v_[i] * v_[i];
    kinetic_ = kinetic;
    largest_kinetic_ = std::max(largest_kinetic_, kinetic);
    largest_input_ = std::max(largest_input_, std::abs(input_));
  }

  // Accelerations that balance the committed displacements and velocities.
  void balance() {
    trial_u_ = u_;
    trial_v_ = v_;
    evaluate(u_, v_);
    for (int i = 0; i < size; ++i) trial_a_[i] = -force_[i] / mass_[i] - ground_;
    commit();
    for (Gap& gap : gaps_) gap.start_power = dissipation_rate(gap, gap.indentation, gap.rate);
  }

  void change_phases() {
    for (Gap& gap : gaps_) {
      for (int change = 0; change < 3; ++change) {
        if (margin(gap, gap.indentation, gap.rate) >= 0.0) break;
        const double stored_before = stored_energy(gap, gap.indentation);
        if (gap.phase == Phase::open) {
          gap.phase = Phase::loaded;
          gap.approach_speed = std::max(gap.rate, 1e-4);
        } else if (gap.indentation <= 0.0) {
          gap.phase = Phase::open;
        } else {
          gap.phase = gap.phase == Phase::loaded ? Phase::released : Phase::loaded;
        }
        impact_ += stored_before - stored_energy(gap, gap.indentation);
      }
    }
    ++history_.events;
    balance();
    follow(true);
  }

  template <class Use>
  void for_each_channel(Use&& use) const {
    int next = 0;
    for (int i = 0; i < size; ++i) {
      use(next++, u_[i]);
      use(next++, v_[i]);
      use(next++, a_[i] + ground_);
    }
    for (int i = 1; i < size; ++i) {
      use(next++, u_[i] - u_[i - 1]);
      use(next++, storey_stiffness * (u_[i] - u_[i - 1]));
    }
    use(next++, u_[0]);
    use(next++, bearing_force_);
    for (const Gap& gap : gaps_) {
      use(next++, std::max(gap.indentation, 0.0));
      use(next++, gap.force);
    }
    double inertia = 0.0;
    for (int i = 0; i < size; ++i) inertia += mass_[i] * (a_[i] + ground_);
    use(next++, -inertia);
  }

  void follow(bool after_event) {
    for_each_channel([&](int channel, double value) {
      ParabolaPeak& tracker = trackers_[static_cast<std::size_t>(channel)];
      after_event ? tracker.restart(time_, value) : tracker.add(time_, value);
    });
  }

  [[nodiscard]] double strain() const {
    const double kept = std::clamp(u_[0] - slip_, -yield_displacement, yield_displacement);
    double strain = 0.5 * post_yield * u_[0] * u_[0] + 0.5 * sliding * kept * kept;
    for (int i = 1; i < size; ++i) strain += 0.5 * storey_stiffness * (u_[i] - u_[i - 1]) * (u_[i] - u_[i - 1]);
    for (const Gap& gap : gaps_) strain += stored_energy(gap, gap.indentation);
    return strain;
  }

  void record() {
    history_.rows.push_back(time_);
    history_.rows.push_back(ground_);
    for_each_channel([&](int, double value) { history_.rows.push_back(value); });
    for (const double energy : {input_, kinetic_, strain(), viscous_, hysteretic_, impact_})
      history_.rows.push_back(energy);
    ++next_row_;
  }

  const GroundMotion& motion_;
  double nominal_;
  double storey_damping_ = 0.0, floor_damping_ = 0.0;
  Values mass_;

  double time_ = 0.0, ground_ = 0.0;
  Values u_{}, v_{}, a_{}, trial_u_{}, trial_v_{}, trial_a_{}, force_{};
  double slip_ = 0.0, trial_slip_ = 0.0, bearing_force_ = 0.0, start_bearing_force_ = 0.0;
  double base_stiffness_ = 0.0, base_damping_ = 0.0;
  std::array<Gap, 2> gaps_{Gap{.side = -1.0}, Gap{.side = 1.0}};

  double factored_h_ = 0.0, factored_stiffness_ = 0.0, factored_damping_ = 0.0;
  Values pivot_{}, chain_{}, arrow_{};

  double input_ = 0.0, work_ = 0.0, viscous_ = 0.0, hysteretic_ = 0.0, impact_ = 0.0;
  double kinetic_ = 0.0, largest_kinetic_ = 0.0, largest_input_ = 0.0;
  std::array<ParabolaPeak, channels> trackers_;
  long next_row_ = 0;
  BareHistory history_;
};

}  // namespace

BareHistory bare_history(const GroundMotion& motion, double step) { return Building{motion, step}.run(); }

}  // namespace moat::performance
