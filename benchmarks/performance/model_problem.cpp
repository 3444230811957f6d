#include <algorithm>
#include <vector>

#include "performance/five_storey_equations.hpp"
#include "performance/sundials_problem.hpp"

namespace moat::performance {
namespace {

// Events are met this much beyond the change (m or m/s), so that change_regimes() finds itself behind it: the middle of
// the band in which a step of moat ends.
constexpr double beyond_change = 5e-13;

class ModelProblem final : public SundialsProblem {
 public:
  ModelProblem(const Model& model, const GroundMotion& ground_motion)
      : SundialsProblem{ground_motion},
        model_{model},
        inverse_masses_{model.masses().head(unknowns).cwiseInverse()},
        stiffness_{model.zero_matrix()},
        damping_{model.zero_matrix()} {
    for (const auto& block : model_.blocks())
      if (block->contacts() != nullptr) gaps_ = block.get();
  }

  void rate(double t, const realtype* y, realtype* rates) override {
    evaluate(t, y);
    const double ground = motion.acceleration_at(t);
    for (int i = 0; i < unknowns; ++i) {
      rates[i] = y[unknowns + i];
      rates[unknowns + i] = absolute_acceleration(i) - ground;
    }
  }

  void jacobian(double t, const realtype* y, SUNMatrix matrix) override {
    evaluate(t, y);
    model_.assemble_tangent(0.0, 0.0, 1.0, stiffness_);
    model_.assemble_tangent(0.0, 1.0, 0.0, damping_);
    for (int i = 0; i < unknowns; ++i) SM_ELEMENT_D(matrix, i, unknowns + i) = 1.0;
    const auto scatter = [&](const SparseMatrix& tangent, int shift) {
      for (std::size_t column = 0; column < unknowns; ++column)
        for (SparseMatrix::InnerIterator entry{tangent, static_cast<int>(column)}; entry; ++entry) {
          const auto row = entry.row();
          SM_ELEMENT_D(matrix, unknowns + row, shift + static_cast<int>(column)) =
              -inverse_masses_[row] * entry.value();
        }
    };
    scatter(stiffness_, 0);
    scatter(damping_, unknowns);
  }

  [[nodiscard]] int margin_count() const override { return 1; }
  void margins(double t, const realtype* y, realtype* margin) override {
    evaluate(t, y);
    margin[0] = std::min(model_.scan_regimes(t - model_.state().time, 0.0).margin + beyond_change, 1.0);
  }

  [[nodiscard]] Peaks sample(double t, const realtype* y) override {
    evaluate(t, y);
    const auto wall = gaps_->results().forces;
    return {y[0], y[floors], absolute_acceleration(0), absolute_acceleration(floors), std::max(wall[0], wall[1])};
  }

  void change_regimes(double t, const realtype* y, const int*) override {
    evaluate(t, y);
    model_.commit();
    changes_.clear();
    model_.change_regimes(changes_);
  }

 private:
  void evaluate(double t, const realtype* y) {
    MotionState& trial = model_.trial();
    trial.time = t;
    std::copy(y, y + unknowns, trial.displacement.data());
    std::copy(y + unknowns, y + 2 * unknowns, trial.velocity.data());
    model_.evaluate();
  }
  [[nodiscard]] double absolute_acceleration(int i) const { return -inverse_masses_[i] * model_.internal_forces()[i]; }

  Model model_;
  const ElementBlock* gaps_ = nullptr;
  Vector inverse_masses_;
  SparseMatrix stiffness_, damping_;
  std::vector<RegimeChange> changes_;
};

}  // namespace

std::unique_ptr<SundialsProblem> model_problem(const Model& model, const GroundMotion& motion) {
  return std::make_unique<ModelProblem>(model, motion);
}

}  // namespace moat::performance
