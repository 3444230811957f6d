#include "performance/five_storey_equations.hpp"
#include "performance/regimes.hpp"
#include "performance/sundials_problem.hpp"

namespace moat::performance {
namespace {

using State = Eigen::Map<const Values>;

class HandProblem final : public SundialsProblem {
 public:
  using SundialsProblem::SundialsProblem;

  void rate(double t, const realtype* y, realtype* rates) override {
    Eigen::Map<Values>{rates} = State{y + unknowns};
    Eigen::Map<Values>{rates + unknowns} = acceleration(motion.acceleration_at(t), y);
  }

  void jacobian(double, const realtype* y, SUNMatrix matrix) override {
    const double elastic = building_.square_frequency, viscous = elastic * building_.stiffness_factor;
    const auto couple = [&](int below, int above, double stiffness, double damping) {
      for (const int row : {below, above})
        for (const int column : {below, above}) {
          const double sign = (row == column ? -1.0 : 1.0) * (row == 0 ? building_.mass_ratio : 1.0);
          SM_ELEMENT_D(matrix, unknowns + row, column) += sign * stiffness;
          SM_ELEMENT_D(matrix, unknowns + row, unknowns + column) += sign * damping;
        }
    };
    for (int i = 0; i < unknowns; ++i) SM_ELEMENT_D(matrix, i, unknowns + i) = 1.0;
    for (int i = 1; i <= floors; ++i) {
      couple(i - 1, i, elastic, viscous);
      couple(0, i, 0.0, building_.mass_factor);
    }
    const WallForce wall = wall_force(building_, regimes_, y[0], y[unknowns]);
    SM_ELEMENT_D(matrix, unknowns, 0) -= building_.inverse_base_mass * (bearing_.stiffness + wall.stiffness);
    SM_ELEMENT_D(matrix, unknowns, unknowns) -= building_.inverse_base_mass * wall.damping;
  }

  [[nodiscard]] int margin_count() const override { return static_cast<int>(Margins{}.size()); }
  void margins(double, const realtype* y, realtype* margin) override {
    const Margins now = margins_of(building_, regimes_, y[0], y[unknowns]);
    std::copy(now.begin(), now.end(), margin);
  }

  [[nodiscard]] Peaks sample(double t, const realtype* y) override {
    const Values absolute = acceleration(motion.acceleration_at(t), y).array() + motion.acceleration_at(t);
    const double wall = wall_force(building_, regimes_, y[0], y[unknowns]).force;
    return {y[0], y[floors], absolute[0], absolute[floors], wall};
  }

  void change_regimes(double, const realtype* y, const int* crossed) override {
    for (const Event event : {bearing_corner, gap_end, force_end})
      if (crossed[event] != 0) regimes_ = beyond(building_, regimes_, event, y[0], y[unknowns]);
    bearing_ = bearing_line(building_, regimes_);
  }

 private:
  [[nodiscard]] Values acceleration(double ground, const realtype* y) const {
    const State u{y}, v{y + unknowns};
    const double force = bearing_.stiffness * u[0] + bearing_.constant +
                         regimes_.side * wall_force(building_, regimes_, u[0], v[0]).force;
    return accelerations(building_, u, v, force, ground);
  }

  FiveStoreys building_;
  Regimes regimes_;
  Line bearing_ = bearing_line(building_, regimes_);
};

}  // namespace

std::unique_ptr<SundialsProblem> hand_problem(const GroundMotion& motion) {
  return std::make_unique<HandProblem>(motion);
}

}  // namespace moat::performance
