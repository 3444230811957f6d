#include "analyses/events/changes_inside.hpp"

#include <algorithm>
#include <utility>

namespace moat {

bool ChangesInside::wanted(int crossings) const {
  constexpr double many = 0.3;
  constexpr int many_at_once = 8;
  if (&step_->stepper() != &step_->implicit() || treatment_ == EventTreatment::located) return false;
  if (treatment_ == EventTreatment::inside_the_step) return true;
  return step_->model().degrees_of_freedom() > located_up_to && (changes_per_step_ > many || crossings >= many_at_once);
}

// Puts elements that change inside the trial step into their next regimes. False if one of them cannot be crossed, or a
// contact needs shorter steps.
bool ChangesInside::enter(double h, std::vector<RegimeChange>& changes) {
  Model& model = step_->model();
  return model.change_regimes_inside(h, step_->aim(), changes) &&
         step_->implicit().control().is_short_enough(h, model.shortest_contact());
}

void ChangesInside::take_back(std::vector<RegimeChange>& changes) {
  step_->model().undo_changes_inside();
  changes.clear();
}

void ChangesInside::foresee(std::vector<RegimeChange>& changes) {
  step_->implicit().predict(step_->whole());
  if (!enter(step_->whole().length, changes)) take_back(changes);
  step_->implicit().add_missed_impulses(step_->whole().length);
}

bool ChangesInside::settle(double h, std::vector<RegimeChange>& changes) {
  constexpr int most_passes = 4;
  // Instants that were foreseen are those of a guess. The solution gives better ones.
  bool only_foreseen = !changes.empty();
  if (only_foreseen) take_back(changes);
  for (int pass = 0; pass < most_passes; ++pass) {
    const std::size_t before = changes.size();
    const bool possible = enter(h, changes);
    if (possible && changes.size() == before && !std::exchange(only_foreseen, false)) return true;
    ++step_->statistics().event_solves;
    if (!possible) break;
    step_->implicit().add_missed_impulses(h);
    if (!step_->solve(h)) break;
  }
  take_back(changes);
  step_->implicit().add_missed_impulses(h);
  return false;
}

void ChangesInside::accepted(std::size_t changes) {
  constexpr double of_last_step = 1.0 / 16.0;
  changes_per_step_ += of_last_step * (std::min(static_cast<double>(changes), 1.0) - changes_per_step_);
}

}  // namespace moat
