#include "performance/bare_loops.hpp"

#include <Eigen/Cholesky>
#include <span>

#include "performance/five_storey_equations.hpp"
#include "performance/regimes.hpp"

namespace moat::performance {
namespace {

struct Instant {
  Values u = Values::Zero(), v = Values::Zero(), a = Values::Zero();
  double ground = 0.0;
};

// The building in its present regimes.
struct Equations {
  FiveStoreys building;
  Regimes regimes;
  Line bearing = bearing_line(building, regimes);

  void change(Event event, double base, double velocity) {
    regimes = beyond(building, regimes, event, base, velocity);
    bearing = bearing_line(building, regimes);
  }
  [[nodiscard]] WallForce wall(const Values& u, const Values& v) const {
    return wall_force(building, regimes, u[0], v[0]);
  }
  [[nodiscard]] Values accelerations(const Values& u, const Values& v, const WallForce& wall, double ground) const {
    const double force = bearing.stiffness * u[0] + bearing.constant + regimes.side * wall.force;
    return performance::accelerations(building, u, v, force, ground);
  }
  [[nodiscard]] Values accelerations(const Values& u, const Values& v, double ground) const {
    return accelerations(u, v, wall(u, v), ground);
  }
};

class RungeKutta {
 public:
  explicit RungeKutta(RungeKuttaSetting setting) : setting_{setting} {}

  [[nodiscard]] int divisions(const Equations& now, double interval) const {
    if (now.regimes.side == 0) return setting_.divisions;
    const double duration = contact_duration(now.building, now.regimes);
    return std::max(setting_.divisions, static_cast<int>(std::ceil(interval * setting_.steps_per_contact / duration)));
  }
  // The classical method for u'' = f(t, u, u'), whose stages in u reduce to sums of accelerations.
  void step(const Equations& equations, const Instant& now, double h, Instant& next) {
    const double half = 0.5 * h, sixth = h / 6.0, middle_ground = 0.5 * (now.ground + next.ground);
    const Values middle = now.u + half * now.v;
    const Values a2 = equations.accelerations(middle, now.v + half * now.a, middle_ground);
    const Values a3 = equations.accelerations(middle + half * half * now.a, now.v + half * a2, middle_ground);
    const Values a4 = equations.accelerations(now.u + h * (now.v + half * a2), now.v + h * a3, next.ground);
    const Values sum = now.a + a2 + a3;
    next.u = now.u + h * (now.v + sixth * sum);
    next.v = now.v + sixth * (sum + a2 + a3 + a4);
    next.a = equations.accelerations(next.u, next.v, next.ground);
  }
  [[nodiscard]] static long iterations() { return 0; }

 private:
  RungeKuttaSetting setting_;
};

class AverageAcceleration {
 public:
  explicit AverageAcceleration(int divisions) : divisions_{divisions} {
    mass_.diagonal().setOnes();
    mass_(0, 0) = 1.0 / building_.mass_ratio;
    for (int i = 1; i <= floors; ++i) {
      couple(stiffness_, i - 1, i, building_.square_frequency);
      couple(damping_, i - 1, i, building_.square_frequency * building_.stiffness_factor);
      couple(damping_, 0, i, building_.mass_factor);
    }
  }

  [[nodiscard]] int divisions(const Equations&, double) const { return divisions_; }
  // Equations per mass of a floor.
  void step(const Equations& equations, const Instant& now, double h, Instant& next) {
    constexpr int most_iterations = 50;
    const double displacement_weight = 0.25 * h * h, velocity_weight = 0.5 * h;
    next.a = now.a;
    next.v = now.v + h * now.a;
    next.u = now.u + h * (now.v + 0.5 * h * now.a);
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
      const WallForce wall = equations.wall(next.u, next.v);
      const Values absolute = equations.accelerations(next.u, next.v, wall, 0.0);
      const Values residual = (absolute - next.a).array() - next.ground;
      largest_acceleration_ = std::max(largest_acceleration_, absolute.cwiseAbs().maxCoeff());
      if (residual.cwiseAbs().maxCoeff() <= 1e-10 * largest_acceleration_) break;
      Tangent tangent = mass_ + displacement_weight * stiffness_ + velocity_weight * damping_;
      tangent(0, 0) +=
          (displacement_weight * (equations.bearing.stiffness + wall.stiffness) + velocity_weight * wall.damping) /
          building_.floor_mass;
      const Values x = tangent.llt().solve(mass_.diagonal().cwiseProduct(residual));
      next.a += x;
      next.v += velocity_weight * x;
      next.u += displacement_weight * x;
      ++iterations_;
    }
  }
  [[nodiscard]] long iterations() const { return iterations_; }

 private:
  using Tangent = Eigen::Matrix<double, unknowns, unknowns>;

  static void couple(Tangent& matrix, int i, int j, double value) {
    matrix(i, i) += value;
    matrix(j, j) += value;
    matrix(i, j) -= value;
    matrix(j, i) -= value;
  }

  FiveStoreys building_;
  int divisions_;
  Tangent mass_ = Tangent::Zero(), stiffness_ = Tangent::Zero(), damping_ = Tangent::Zero();
  double largest_acceleration_ = 0.0;
  long iterations_ = 0;
};

template <class Method>
class History {
 public:
  History(const GroundMotion& motion, Method method)
      : method_{method}, samples_{motion.samples()}, interval_{motion.time_step()} {
    now_.ground = samples_[0];
    start_regimes();
    peaks_.add(0.0, sample());
  }

  BareHistory run() {
    while (sample_ + 1 < samples_.size()) advance();
    return {peaks_.values(), steps_, method_.iterations()};
  }

 private:
  void step(double h) {
    const double slope = (samples_[sample_ + 1] - samples_[sample_]) / interval_;
    next_.ground = now_.ground + h * slope;
    method_.step(equations_, now_, h, next_);
  }

  // The grid divides the interval of the samples; place_ is the fraction of it at which the step starts.
  void advance() {
    const double position = place_ * divisions_, grid = std::floor(position + 1e-9) + 1.0;
    const double h = (grid - position) * (interval_ / divisions_);
    step(h);
    const BasePath path{now_.u[0], now_.v[0], next_.u[0], next_.v[0], h};
    if (const auto crossing = first_crossing(equations_.building, equations_.regimes, path))
      return locate(h, *crossing);
    place_ = grid / divisions_;
    accept();
  }

  void accept() {
    if (place_ >= 1.0 - 1e-9) {
      place_ = 0.0;
      next_.ground = samples_[++sample_];
    }
    now_ = next_;
    peaks_.add(time(), sample());
    ++steps_;
  }

  // The cubic is nearly exact; corrections along the slope bring round-off.
  void locate(double h, Crossing crossing) {
    double length = crossing.fraction * h;
    for (int correction = 0;; ++correction) {
      step(length);
      const auto& [building, regimes, bearing] = equations_;
      const double margin = margins_of(building, regimes, next_.u[0], next_.v[0])[crossing.event];
      const double miss = -margin / margin_rates(building, regimes, next_.u[0], next_.v[0], next_.a[0])[crossing.event];
      const double corrected = length + miss;
      if (correction == 3 || std::abs(miss) <= 1e-9 * h || !(corrected > 0.0 && corrected <= h)) break;
      length = corrected;
    }
    place_ += length / interval_;
    accept();
    equations_.change(crossing.event, now_.u[0], now_.v[0]);
    start_regimes();
    peaks_.restart(time(), sample());
  }

  void start_regimes() {
    now_.a = equations_.accelerations(now_.u, now_.v, now_.ground);
    divisions_ = method_.divisions(equations_, interval_);
  }

  [[nodiscard]] double time() const { return (static_cast<double>(sample_) + place_) * interval_; }
  [[nodiscard]] Peaks sample() const {
    return {now_.u[0], now_.u[floors], now_.a[0] + now_.ground, now_.a[floors] + now_.ground,
            equations_.wall(now_.u, now_.v).force};
  }

  Method method_;
  Equations equations_;
  std::span<const double> samples_;
  double interval_;
  int divisions_ = 1;
  std::size_t sample_ = 0;
  double place_ = 0.0;
  Instant now_, next_;
  FivePeaks peaks_;
  long steps_ = 0;
};

}  // namespace

BareHistory bare_runge_kutta(const GroundMotion& motion, RungeKuttaSetting setting) {
  return History{motion, RungeKutta{setting}}.run();
}

BareHistory bare_newmark(const GroundMotion& motion, int divisions) {
  return History{motion, AverageAcceleration{divisions}}.run();
}

}  // namespace moat::performance
