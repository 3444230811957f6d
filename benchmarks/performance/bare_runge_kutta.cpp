#include "performance/bare_runge_kutta.hpp"

#include <span>

#include "performance/five_storey_equations.hpp"
#include "performance/regime_box.hpp"

namespace moat::performance {
namespace {

struct Instant {
  Values u{}, v{}, a{};
  double ground = 0.0;
};

class History {
 public:
  History(const GroundMotion& motion, RungeKuttaSetting setting)
      : samples_{motion.samples()}, interval_{motion.time_step()}, setting_{setting}, divisions_{setting.divisions} {
    now_->ground = samples_[0];
    evaluate(*now_);
    peaks_.add(0.0, sample());
  }

  Peaks run() {
    while (sample_ + 1 < samples_.size()) advance();
    return peaks_.values();
  }

 private:
  // The classical method for u'' = f(t, u, u'), whose stages in u reduce to sums of accelerations.
  template <bool touching>
  void take_step(double h, double ground_middle, double ground_end) {
    const Values u = now_->u, v = now_->v, a = now_->a;
    const double half = 0.5 * h, sixth = h / 6.0;
    const Values middle = u + half * v;
    const Values a2 = evaluate<touching>(middle, v + half * a, ground_middle);
    const Values a3 = evaluate<touching>(middle + (half * half) * a, v + half * a2, ground_middle);
    const Values a4 = evaluate<touching>(u + h * (v + half * a2), v + h * a3, ground_end);
    const Values sum = a + a2 + a3;
    next_->u = u + h * (v + sixth * sum);
    next_->v = v + sixth * (sum + a2 + a3 + a4);
    next_->ground = ground_end;
  }

  template <bool touching>
  Values evaluate(const Values& u, const Values& v, double ground) const {
    double force = bearing_.stiffness * u[0] + bearing_.constant;
    if constexpr (touching) force += regimes_.side * wall_force(building_, regimes_, u[0], v[0]);
    return accelerations(building_, u, v, force, ground);
  }
  void evaluate(Instant& instant) const {
    instant.a = regimes_.side != 0 ? evaluate<true>(instant.u, instant.v, instant.ground)
                                   : evaluate<false>(instant.u, instant.v, instant.ground);
  }

  void step(double h, double ground_slope) {
    const double middle = now_->ground + 0.5 * h * ground_slope, end = now_->ground + h * ground_slope;
    if (regimes_.side != 0)
      take_step<true>(h, middle, end);
    else
      take_step<false>(h, middle, end);
  }

  void advance() {
    // The grid in use divides the interval of the samples; place_ is where in it the step starts.
    const double position = place_ * divisions_;
    const double grid = std::floor(position + 1e-9) + 1.0;
    const bool on_sample = grid >= divisions_;
    double h = (grid - position) * (interval_ / divisions_);
    const double slope = (samples_[sample_ + 1] - samples_[sample_]) / interval_;
    step(h, slope);

    const BasePath path{now_->u[0], now_->v[0], next_->u[0], next_->v[0], h};
    if (!box_.holds(path.end, path.end_velocity) || path.start_velocity * path.end_velocity < 0.0) {
      if (const auto crossing = first_crossing(box_, path)) return locate(h, *crossing, slope);
    }
    place_ = on_sample ? 0.0 : grid / divisions_;
    if (on_sample) next_->ground = samples_[++sample_];
    accept();
  }

  void accept() {
    evaluate(*next_);
    std::swap(now_, next_);
    peaks_.add(time(), sample());
  }

  // The cubic is as exact as the method; a correction or two along the slope bring round-off.
  void locate(double h, Crossing crossing, double slope) {
    double length = crossing.fraction * h;
    const bool of_displacement = crossing.side <= greatest_displacement;
    for (int correction = 0;; ++correction) {
      step(length, slope);
      const double mean_rate = length > 0.0 ? (next_->v[0] - now_->v[0]) / length : now_->a[0];
      const double miss = of_displacement ? (box_.bounds[crossing.side] - next_->u[0]) / next_->v[0]
                                          : (box_.bounds[crossing.side] - next_->v[0]) / mean_rate;
      const double corrected = length + miss;
      if (correction == 2 || std::abs(miss) <= 1e-8 * h || !(corrected > 0.0 && corrected <= h)) break;
      length = corrected;
    }
    place_ += length / interval_;
    if (place_ >= 1.0 - 1e-9) {
      place_ = 0.0;
      next_->ground = samples_[++sample_];
    }
    accept();
    regimes_ = beyond(building_, box_, crossing.side, regimes_, now_->u[0], now_->v[0]);
    box_ = box_of(building_, regimes_);
    bearing_ = bearing_line(building_, regimes_);
    divisions_ = setting_.divisions;
    if (regimes_.side != 0)
      divisions_ = std::max(divisions_, static_cast<int>(std::ceil(interval_ * setting_.steps_per_contact /
                                                                   contact_duration(building_, regimes_))));
    evaluate(*now_);
    peaks_.restart(time(), sample());
  }

  [[nodiscard]] double time() const { return (static_cast<double>(sample_) + place_) * interval_; }
  [[nodiscard]] Peaks sample() const {
    return {now_->u[0], now_->u[floors], now_->a[0] + now_->ground, now_->a[floors] + now_->ground,
            regimes_.side == 0 ? 0.0 : wall_force(building_, regimes_, now_->u[0], now_->v[0])};
  }

  FiveStoreys building_;
  Regimes regimes_;
  RegimeBox box_ = box_of(building_, regimes_);
  Line bearing_ = bearing_line(building_, regimes_);
  std::span<const double> samples_;
  double interval_;
  RungeKuttaSetting setting_;
  int divisions_;
  std::size_t sample_ = 0;
  double place_ = 0.0;
  Instant instants_[2];
  Instant *now_ = &instants_[0], *next_ = &instants_[1];
  FivePeaks peaks_;
};

}  // namespace

Peaks bare_runge_kutta(const GroundMotion& motion, RungeKuttaSetting setting) { return History{motion, setting}.run(); }

}  // namespace moat::performance
