#include "analyses/modes/plan_modes.hpp"

#include <algorithm>

#include "base/check.hpp"
#include "solvers/modes.hpp"

namespace moat {

std::string PlanMode::character() const {
  constexpr double noticeable = 0.2;
  std::string text;
  const auto name = [&](const char* word, double share) {
    if (share >= noticeable) text += (text.empty() ? "" : "-") + std::string{word};
  };
  name("x", along_x);
  name("y", along_y);
  name("torsion", rotation);
  return text;
}

std::vector<PlanMode> plan_modes(const Model& model, StiffnessStage stage, int count) {
  const Check check{"plan_modes", ""};
  check.that(model.is_plan(), "the model moves on a line.", "Its periods are those of characteristic_periods().");
  check.that(count >= 1, "count", count, "1", ">= 1");
  const SparseMatrix stiffness = model.linear_stiffness(stage);
  const int size = model.degrees_of_freedom();
  SparseMatrix masses = model.zero_matrix();
  model.mass_matrix().add_to(1.0, masses);
  const Eigen::Map<const Vector> along_x{model.ground_influence().x, size}, along_y{model.ground_influence().y, size};
  const Vector mass_x = masses * along_x, mass_y = masses * along_y;
  std::vector<PlanMode> modes;
  for (Mode& each : slowest_modes(stiffness, masses, std::min(count, size))) {
    PlanMode mode;
    mode.period = each.period();
    const Vector energy = each.shape.cwiseProduct(masses * each.shape);
    mode.along_x = energy.dot(along_x.cwiseAbs2());
    mode.along_y = energy.dot(along_y.cwiseAbs2());
    mode.rotation = std::max(1.0 - mode.along_x - mode.along_y, 0.0);
    const double load_x = mass_x.dot(each.shape), load_y = mass_y.dot(each.shape);
    mode.participation_x = load_x * load_x / mass_x.dot(along_x);
    mode.participation_y = load_y * load_y / mass_y.dot(along_y);
    mode.shape = std::move(each.shape);
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace moat
