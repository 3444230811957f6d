#include "performance/bare_newmark.hpp"

#include <array>
#include <limits>
#include <span>
#include <utility>

#include "performance/five_storey_equations.hpp"
#include "performance/regime_box.hpp"

namespace moat::performance {
namespace {

constexpr std::size_t unknowns = floors + 1;

double largest_magnitude(const Values& values) {
  double largest = 0.0;
  for (std::size_t i = 0; i < unknowns; ++i) largest = std::max(largest, std::abs(values[i]));
  return largest;
}

// The tangent of the equations of one step, per unit of mass, with the floors eliminated:
//
//     [ T  b ] [ x_f ]   [ r_f ]       T x_f + b x_0 = r_f
//     [ b' s ] [ x_0 ] = [ r_0 ]       only s depends on what bearing and wall are doing
class EliminatedFloors {
 public:
  static constexpr bool knows_when_solved = true;

  EliminatedFloors() = default;
  EliminatedFloors(const FiveStoreys& building, double h)
      : displacement_weight{0.25 * h * h}, velocity_weight{0.5 * h} {
    const double storey =
        building.square_frequency * (displacement_weight + velocity_weight * building.stiffness_factor);
    const double drag = velocity_weight * building.mass_factor;
    // Cholesky-like elimination of the tridiagonal T from the top, for every unit vector.
    std::array<double, unknowns> pivot{};
    for (std::size_t i = floors; i >= 1; --i)
      pivot[i] = 1.0 + drag + (i == floors ? storey : 2.0 * storey - storey * storey / pivot[i + 1]);
    for (std::size_t column = 1; column <= floors; ++column) {
      std::array<double, unknowns> x{};
      x[column] = 1.0;
      for (std::size_t i = floors - 1; i >= 1; --i) x[i] += storey * x[i + 1] / pivot[i + 1];
      x[1] /= pivot[1];
      for (std::size_t i = 2; i <= floors; ++i) x[i] = (x[i] + storey * x[i - 1]) / pivot[i];
      for (std::size_t i = 1; i <= floors; ++i) inverse_[column - 1].set(i, x[i]);
    }
    std::array<double, unknowns> coupling{};
    for (std::size_t i = 1; i <= floors; ++i) coupling[i] = i == 1 ? -storey - drag : -drag;
    for (std::size_t i = 1; i <= floors; ++i) from_base_ = from_base_ + coupling[i] * inverse_[i - 1];
    from_base_.set(0, -1.0);
    base_ = 1.0 + building.mass_ratio * (storey + static_cast<double>(floors) * drag);
    for (std::size_t i = 1; i <= floors; ++i) base_ -= building.mass_ratio * coupling[i] * from_base_[i];
    mass_ratio_ = building.mass_ratio;
  }

  // `base`: of bearing and wall, added to s.
  [[nodiscard]] Values solve(const Values& residual, double base) const {
    Values y = residual[1] * inverse_[0];
    for (std::size_t i = 2; i <= floors; ++i) y = y + residual[i] * inverse_[i - 1];
    const Values::Pair products = residual.pairs[0] * from_base_.pairs[0] + residual.pairs[1] * from_base_.pairs[1] +
                                  residual.pairs[2] * from_base_.pairs[2];
    // The first product is -r_0.
    const double below = residual[0] - mass_ratio_ * (products[0] + products[1] + residual[0]);
    return y - (below / (base_ + base)) * from_base_;
  }

  double displacement_weight = 0.0, velocity_weight = 0.0;

 private:
  std::array<Values, floors> inverse_;  // columns of T^-1
  Values from_base_;                    // (-1, T^-1 b)
  double base_ = 0.0, mass_ratio_ = 0.0;
};

// The same tangent, assembled and factored whenever it is needed.
class DenseTangent {
 public:
  static constexpr bool knows_when_solved = false;

  DenseTangent() = default;
  DenseTangent(const FiveStoreys& building, double h)
      : displacement_weight{0.25 * h * h},
        velocity_weight{0.5 * h},
        storey_{building.square_frequency * (displacement_weight + velocity_weight * building.stiffness_factor)},
        drag_{velocity_weight * building.mass_factor},
        base_mass_{1.0 / building.mass_ratio} {}

  [[nodiscard]] Values solve(const Values& residual, double base) const {
    std::array<std::array<double, unknowns>, unknowns> matrix{};
    const auto couple = [&](std::size_t i, std::size_t j, double value) {
      matrix[i][i] += value;
      matrix[j][j] += value;
      matrix[i][j] -= value;
      matrix[j][i] -= value;
    };
    matrix[0][0] = base_mass_ * (1.0 + base);
    for (std::size_t i = 1; i <= floors; ++i) {
      matrix[i][i] += 1.0;
      couple(i - 1, i, storey_);
      couple(0, i, drag_);
    }
    std::array<double, unknowns> x{};
    for (std::size_t i = 0; i < unknowns; ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        for (std::size_t k = 0; k < j; ++k) matrix[i][j] -= matrix[i][k] * matrix[j][k];
        matrix[i][j] /= matrix[j][j];
      }
      for (std::size_t k = 0; k < i; ++k) matrix[i][i] -= matrix[i][k] * matrix[i][k];
      matrix[i][i] = std::sqrt(matrix[i][i]);
      x[i] = (i == 0 ? base_mass_ : 1.0) * residual[i];
      for (std::size_t k = 0; k < i; ++k) x[i] -= matrix[i][k] * x[k];
      x[i] /= matrix[i][i];
    }
    Values result;
    for (std::size_t i = unknowns; i-- > 0;) {
      for (std::size_t k = i + 1; k < unknowns; ++k) x[i] -= matrix[k][i] * x[k];
      x[i] /= matrix[i][i];
      result.set(i, x[i]);
    }
    return result;
  }

  double displacement_weight = 0.0, velocity_weight = 0.0;

 private:
  double storey_ = 0.0, drag_ = 0.0, base_mass_ = 0.0;  // per mass of a floor
};

template <class Tangent>
class History {
 public:
  History(const GroundMotion& motion, NewmarkSetting setting)
      : samples_{motion.samples()}, interval_{motion.time_step()}, setting_{setting} {
    now_.ground = samples_[0];
    balance();
    remember(0.0);
    peaks_.add(0.0, sample());
  }

  Peaks run() {
    while (sample_ + 1 < samples_.size()) advance();
    return peaks_.values();
  }

 private:
  static constexpr int most_halvings = 24;
  static constexpr int ramp_at_start = 8, ramp_at_touch = 6, ramp_at_separation = 3;

  struct Instant {
    Values u, v, a;
    double ground = 0.0, slip = 0.0, wall = 0.0;
  };
  // Of bearing and wall on the base, per unit of its mass.
  struct BaseForce {
    double force = 0.0, stiffness = 0.0, damping = 0.0, slip = 0.0, wall = 0.0;
    bool slides = false;
  };

  template <bool touching>
  [[nodiscard]] BaseForce base_force(double base, double velocity) const {
    BaseForce result;
    const double limit = building_.yield_displacement, post_yield = building_.post_yield_stiffness;
    const double sliding_part = building_.elastic_stiffness - post_yield;
    const double stretch = base - now_.slip;
    result.slides = std::abs(stretch) > limit;
    const double kept = result.slides ? std::copysign(limit, stretch) : stretch;
    result.slip = base - kept;
    result.force = post_yield * base + sliding_part * kept;
    result.stiffness = result.slides ? post_yield : building_.elastic_stiffness;
    if constexpr (touching) {
      const double indentation = regimes_.side * base - building_.gap;
      if (!regimes_.released && indentation > 0.0) {
        const double root = std::sqrt(indentation), elastic = building_.impact_stiffness * indentation * root;
        const double ratio = speed_ratio(regimes_, velocity);
        const double factor = 1.0 + building_.impact_damping * ratio;
        result.wall = elastic * factor;
        result.force += regimes_.side * result.wall;
        result.stiffness += 1.5 * building_.impact_stiffness * root * factor;
        if (std::abs(ratio) < largest_speed_ratio)
          result.damping = elastic * building_.impact_damping / regimes_.approach_speed;
      }
    }
    return result;
  }

  // Average acceleration over h from the instant `now_`, into `next_`.
  template <bool touching>
  void solve(const Tangent& tangent, double h, double ground) {
    const double displacement_weight = tangent.displacement_weight, velocity_weight = tangent.velocity_weight;
    Values a = now_.a;
    Values v = now_.v + h * a;
    Values u = now_.u + h * (now_.v + (0.5 * h) * a);
    BaseForce base = base_force<touching>(u[0], v[0]);
    constexpr int most_iterations = 50;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const Values residual = accelerations(building_, u, v, base.force, ground) - a;
      if (touching || !Tangent::knows_when_solved || iteration > 0) {
        // Of the largest acceleration so far, as moat has it.
        if (largest_magnitude(residual) <= 1e-10 * largest_acceleration_) break;
      }
      const double nonlinear =
          building_.inverse_base_mass * (displacement_weight * base.stiffness + velocity_weight * base.damping);
      const Values x = tangent.solve(residual, nonlinear);
      a = a + x;
      v = v + velocity_weight * x;
      u = u + displacement_weight * x;
      const bool slid = base.slides;
      const double line = base.force + base.stiffness * displacement_weight * x[0];
      base = base_force<touching>(u[0], v[0]);
      // On the same line as before: linear, hence solved.
      if (!touching && Tangent::knows_when_solved && base.slides == slid &&
          std::abs(base.force - line) <= 1e-10 * std::abs(line) + 1e-6)
        break;
    }
    next_ = {u, v, a, ground, base.slip, base.wall};
  }
  void solve(const Tangent& tangent, double h, double ground) {
    if (regimes_.side != 0)
      solve<true>(tangent, h, ground);
    else
      solve<false>(tangent, h, ground);
  }
  void solve(double h, double ground) { solve(Tangent{building_, h}, h, ground); }

  const Tangent& tangent_at(int halvings, double h) {
    const auto level = static_cast<std::size_t>(halvings);
    if (!known_tangents_[level]) {
      tangents_[level] = Tangent{building_, h};
      known_tangents_[level] = true;
    }
    return tangents_[level];
  }

  // Acceleration that balances the present state.
  void balance() {
    const BaseForce base =
        regimes_.side != 0 ? base_force<true>(now_.u[0], now_.v[0]) : base_force<false>(now_.u[0], now_.v[0]);
    now_.a = accelerations(building_, now_.u, now_.v, base.force, now_.ground);
    now_.wall = base.wall;
  }

  [[nodiscard]] int halvings_now() const {
    int halvings = halvings_;
    if (since_event_ < 4.0 * contact_ && contact_ < std::numeric_limits<double>::infinity())
      halvings = std::max(halvings, contact_halvings_);
    return std::min(halvings + ramp_, most_halvings);
  }

  void advance() {
    double h = 0.0, grid = 0.0;
    int halvings = 0;
    const double slope = (samples_[sample_ + 1] - samples_[sample_]) / interval_;
    do {
      halvings = halvings_now();
      const double divisions = static_cast<double>(1 << halvings), position = place_ * divisions;
      const double nominal = interval_ / divisions;
      grid = std::floor(position + 1e-6) + 1.0;
      h = (grid - position) * nominal;
      const bool whole = std::abs(h - nominal) < 1e-9 * nominal;
      grid /= divisions;
      if (whole)
        solve(tangent_at(halvings, nominal), nominal, now_.ground + nominal * slope);
      else
        solve(h, now_.ground + h * slope);
    } while (!accepts(h));

    const BasePath path{now_.u[0], now_.v[0], next_.u[0], next_.v[0], h};
    if (!box_.holds(path.end, path.end_velocity) || path.start_velocity * path.end_velocity < 0.0) {
      if (const auto crossing = first_crossing(box_, path)) return locate(h, *crossing, slope);
    }
    place_ = grid;
    accept(h);
  }

  void accept(double h) {
    if (place_ >= 1.0 - 1e-9) {
      place_ = 0.0;
      next_.ground = samples_[++sample_];
    }
    now_ = next_;
    since_event_ += h;
    remember(h);
    ramp_ = std::max(ramp_ - 1, 0);
    peaks_.add(time(), sample());
  }

  // The cubic through the ends is exact for average acceleration but for the change of step: one correction or two.
  void locate(double h, Crossing crossing, double slope) {
    double length = crossing.fraction * h;
    const bool of_displacement = crossing.side <= greatest_displacement;
    for (int correction = 0;; ++correction) {
      solve(length, now_.ground + length * slope);
      const double miss = of_displacement ? (box_.bounds[crossing.side] - next_.u[0]) / next_.v[0]
                                          : (box_.bounds[crossing.side] - next_.v[0]) / next_.a[0];
      const double corrected = length + miss;
      if (correction == 3 || std::abs(miss) <= 1e-9 * h || !(corrected > 0.0 && corrected <= h)) break;
      length = corrected;
    }
    place_ += length / interval_;
    accept(length);
    regimes_ = beyond(building_, box_, crossing.side, regimes_, now_.u[0], now_.v[0]);
    box_ = wall_box();
    balance();
    contact_ = contact_duration(building_, regimes_);
    contact_halvings_ = 0;
    if (regimes_.side != 0)
      while (std::ldexp(interval_, -contact_halvings_) * setting_.steps_per_contact > contact_) ++contact_halvings_;
    ramp_ = regimes_.side != 0 ? ramp_at_touch : ramp_at_separation;
    since_event_ = 0.0;
    known_ = 0;
    remember(0.0);
    peaks_.restart(time(), sample());
  }

  // The bearing's corners are not located.
  [[nodiscard]] RegimeBox wall_box() const {
    Regimes regimes = regimes_;
    FiveStoreys elastic = building_;
    elastic.yield_displacement = RegimeBox::none;
    regimes.sliding = 0;
    return box_of(elastic, regimes);
  }

  // analyses/step_control.hpp says why.
  bool accepts(double h) {
    if (known_ < 2) return true;
    Values now = next_.a;
    for (Values::Pair& pair : now.pairs) pair += next_.ground;
    const double mean = 0.5 * (h + last_h_);
    const double bend = largest_magnitude((1.0 / h) * (now - last_) - (1.0 / last_h_) * (last_ - before_)) / mean;
    const double largest = std::max(largest_acceleration_, largest_magnitude(now));
    if (largest <= 0.0) return true;
    const double error_per_square = bend / (12.0 * largest);
    constexpr double repeat_above = 4.0, lengthen_below = 0.2;
    if (error_per_square * h * h > repeat_above * setting_.tolerance && halvings_ < most_halvings &&
        std::ldexp(interval_, -halvings_ - 1) < h) {
      ++halvings_;
      return false;
    }
    const double nominal = std::ldexp(interval_, -halvings_);
    const double nominal_error = error_per_square * nominal * nominal;
    if (nominal_error > setting_.tolerance && halvings_ < most_halvings)
      ++halvings_;
    else if (nominal_error < lengthen_below * setting_.tolerance && halvings_ > 0)
      --halvings_;
    return true;
  }

  void remember(double h) {
    before_ = last_;
    last_ = now_.a;
    for (Values::Pair& pair : last_.pairs) pair += now_.ground;
    largest_acceleration_ = std::max(largest_acceleration_, largest_magnitude(last_));
    last_h_ = h;
    known_ = std::min(known_ + 1, 2);
  }

  [[nodiscard]] double time() const { return (static_cast<double>(sample_) + place_) * interval_; }
  [[nodiscard]] Peaks sample() const {
    return {now_.u[0], now_.u[floors], now_.a[0] + now_.ground, now_.a[floors] + now_.ground, now_.wall};
  }

  FiveStoreys building_;
  Regimes regimes_;
  RegimeBox box_ = wall_box();
  std::span<const double> samples_;
  double interval_;
  NewmarkSetting setting_;
  std::size_t sample_ = 0;
  double place_ = 0.0;  // in the interval of the samples, 0 to 1
  Instant now_, next_;
  std::array<Tangent, most_halvings + 1> tangents_;
  std::array<bool, most_halvings + 1> known_tangents_{};
  double contact_ = RegimeBox::none, since_event_ = 0.0;
  int halvings_ = 0, ramp_ = ramp_at_start, contact_halvings_ = 0;
  Values before_, last_;
  double last_h_ = 0.0, largest_acceleration_ = 0.0;
  int known_ = 0;
  FivePeaks peaks_;
};

}  // namespace

Peaks bare_newmark(const GroundMotion& motion, NewmarkSetting setting) {
  return History<EliminatedFloors>{motion, setting}.run();
}

Peaks plain_newmark(const GroundMotion& motion, NewmarkSetting setting) {
  return History<DenseTangent>{motion, setting}.run();
}

}  // namespace moat::performance
