#include "analyses/modes/plan_modes.hpp"

#include <algorithm>
#include <cmath>

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

std::vector<PlanMode> plan_modes(Model& model, StiffnessStage stage, int count) {
  const Check check{"plan_modes", ""};
  check.that(model.is_plan(), "the model moves on a line.", "Its periods are those of characteristic_periods().");
  check.that(count >= 1, "count", count, "1", ">= 1");
  model.prepare();
  const SparseMatrix stiffness = model.linear_stiffness(stage);
  const Vector& masses = model.masses();
  const GroundShares shares = model.ground_shares();
  double mass_x = 0.0, mass_y = 0.0;
  for (int i = 0; i < masses.size(); ++i) {
    mass_x += masses[i] * shares.x[i] * shares.x[i];
    mass_y += masses[i] * shares.y[i] * shares.y[i];
  }
  std::vector<PlanMode> modes;
  for (Mode& each : slowest_modes(stiffness, masses, std::min(count, static_cast<int>(masses.size())))) {
    PlanMode mode;
    mode.period = each.period();
    double load_x = 0.0, load_y = 0.0;
    for (int i = 0; i < masses.size(); ++i) {
      const double energy = masses[i] * each.shape[i] * each.shape[i];
      load_x += masses[i] * shares.x[i] * each.shape[i];
      load_y += masses[i] * shares.y[i] * each.shape[i];
      mode.along_x += energy * shares.x[i] * shares.x[i];
      mode.along_y += energy * shares.y[i] * shares.y[i];
    }
    mode.rotation = std::max(1.0 - mode.along_x - mode.along_y, 0.0);
    mode.participation_x = load_x * load_x / mass_x;
    mode.participation_y = load_y * load_y / mass_y;
    mode.shape = std::move(each.shape);
    modes.push_back(std::move(mode));
  }
  return modes;
}

}  // namespace moat
