// Changes of regime and contacts of all elements of a model.
#include <algorithm>
#include <limits>

#include "model/model.hpp"

namespace moat {

void Model::evaluate_regimes() {
  const double step = trial_.time - state_.time;
  for (const std::size_t i : blocks_with_regimes_) {
    blocks_[i]->begin_step(step);
    blocks_[i]->evaluate(trial_.displacement.data(), trial_.velocity.data(), nullptr);
    blocks_[i]->evaluate_rates(trial_.acceleration.data(), nullptr);
  }
}

RegimeScan Model::scan_regimes(double step, double aim) const {
  RegimeScan scan;
  for (const std::size_t i : blocks_with_regimes_) blocks_[i]->regimes()->scan(step, aim, scan);
  return scan;
}

double Model::time_to_next_change(double aim) const {
  double first = std::numeric_limits<double>::infinity();
  for (const std::size_t i : blocks_with_regimes_) first = std::min(first, blocks_[i]->regimes()->next_fall(aim));
  return first;
}

void Model::change_regimes(std::vector<RegimeChange>& changes) {
  const std::size_t before = changes.size();
  for (const std::size_t i : blocks_with_regimes_) blocks_[i]->regimes()->change(i, changes);
  if (changes.size() == before) return;
  for (std::size_t i = before; i < changes.size(); ++i) changes[i].time = state_.time;
  trial_ = state_;
  evaluate();
}

bool Model::change_regimes_inside(double step, double aim, std::vector<RegimeChange>& changes) {
  const std::size_t before = changes.size();
  bool possible = true;
  for (const std::size_t i : blocks_with_regimes_)
    possible = possible && blocks_[i]->regimes()->change_inside(step, aim, i, changes);
  for (std::size_t i = before; i < changes.size(); ++i) changes[i].time += state_.time;
  return possible;
}

void Model::undo_changes_inside() {
  for (const std::size_t i : blocks_with_regimes_) blocks_[i]->regimes()->undo_changes_inside();
}

bool Model::find_missed_impulses(double step, const ImpulseRules& rules, MissedImpulses& missed) {
  missed.clear(masses_.size());
  bool any = false;
  for (const std::size_t i : blocks_with_regimes_)
    any = blocks_[i]->regimes()->add_missed_impulses(step, rules, missed) || any;
  return any;
}

int Model::contacts_going_on() const {
  int count = 0;
  for (const std::size_t i : blocks_with_contacts_) count += blocks_[i]->contacts()->touching();
  return count;
}

double Model::shortest_contact() const {
  double shortest = std::numeric_limits<double>::infinity();
  for (const std::size_t i : blocks_with_contacts_)
    shortest = std::min(shortest, blocks_[i]->contacts()->shortest_contact());
  return shortest;
}

}  // namespace moat
