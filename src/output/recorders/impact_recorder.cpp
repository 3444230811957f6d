#include "output/recorders/impact_recorder.hpp"

#include <algorithm>
#include <limits>

namespace moat {
namespace {

bool same(RegimeChange a, RegimeChange b) { return a.block == b.block && a.element == b.element; }

}  // namespace

void ImpactRecorder::start(const StepView& view) {
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b) {
    const Contacts* contacts = view.model.blocks()[b]->contacts();
    if (contacts == nullptr || contacts->touching() == 0) continue;
    for (std::size_t e = 0; e < view.model.blocks()[b]->size(); ++e)
      if (contacts->contact(e).touching)
        // Later than at time 0, the contact lasts from an earlier analysis.
        open(view, {.block = b, .element = e, .time = view.model.state().time}, view.model.state().time == 0.0);
  }
}

void ImpactRecorder::follow(const StepView& view, bool after_event) {
  if (!with_energies_) return;
  for (Ongoing& contact : ongoing_) {
    const ElementBlock& block = *view.model.blocks()[contact.gap.block];
    const std::size_t element = contact.gap.element;
    const PlanContacts* sliding = block.plan_contacts();
    const ElementResults results = block.results();
    const double friction = sliding != nullptr ? sliding->friction_force(element) : 0.0,
                 friction_rate = sliding != nullptr ? sliding->friction_force_rate(element) : 0.0;
    CommonInstant& next = contact.peaks.next();
    next.time = view.model.state().time;
    next.values = {results.deformations[element], results.forces[element], friction};
    next.rates = {results.rates[element], results.force_rates[element], friction_rate};
    ContactLoop& loop = impacts_[contact.impact].loop;
    loop.indentation.push_back(next.values[0]);
    loop.force.push_back(next.values[1]);
    if (after_event)
      contact.peaks.restart();
    else
      contact.peaks.add([&](std::size_t quantity, double fraction, double of_cubic) {
        return quantity == 1 && block.laws() != nullptr ? block.laws()->force_inside(element, fraction) : of_cubic;
      });
  }
}

void ImpactRecorder::step(const StepView& view) { follow(view, false); }

void ImpactRecorder::event(const StepView& view, std::span<const RegimeChange> changes) {
  for (const RegimeChange gap : changes) {
    const Contacts* contacts = view.model.blocks()[gap.block]->contacts();
    if (contacts == nullptr) continue;
    const bool touching = contacts->contact(gap.element).touching;
    const auto known =
        std::find_if(ongoing_.begin(), ongoing_.end(), [&](const Ongoing& o) { return same(o.gap, gap); });
    if (touching && known == ongoing_.end()) {
      open(view, gap);
    } else if (!touching && known != ongoing_.end()) {
      const PlanContacts* sliding = view.model.blocks()[gap.block]->plan_contacts();
      const bool left_edge = sliding != nullptr && sliding->times_left(gap.element) > known->left_before;
      close(view, *known, gap.time, gap.rate, !left_edge);
      ongoing_.erase(known);
    }
  }
  follow(view, true);
}

void ImpactRecorder::open(const StepView& view, RegimeChange gap, bool closed_at_start) {
  const ElementBlock& block = *view.model.blocks()[gap.block];
  const double speed = block.contacts()->contact(gap.element).approach_speed;
  const ElementEnergy energy = with_energies_ ? block.energy(gap.element) : ElementEnergy{};
  ongoing_.push_back({gap, impacts_.size(), PeakTrackers{3}, energy.dissipated, energy.friction});
  impacts_.push_back({.where = block.info(gap.element).name,
                      .start = gap.time,
                      .approach_speed = speed,
                      .restitution = std::numeric_limits<double>::quiet_NaN()});
  if (const PlanContacts* sliding = block.plan_contacts()) {
    impacts_.back().corner = sliding->pair(gap.element).corner;
    impacts_.back().edge = sliding->pair(gap.element).edge;
    impacts_.back().tangential_speed = sliding->tangential_speed_at_touch(gap.element);
    ongoing_.back().left_before = sliding->times_left(gap.element);
  }
  listed_.push_back({gap, speed > 0.0 && !closed_at_start});
}

void ImpactRecorder::close(const StepView& view, const Ongoing& contact, double time, double rate, bool separated) {
  if (!with_energies_) return;
  Impact& impact = impacts_[contact.impact];
  impact.duration = time - impact.start;
  impact.largest_indentation = contact.peaks.magnitude(0);
  impact.largest_force = contact.peaks.magnitude(1);
  impact.largest_friction_force = contact.peaks.magnitude(2);
  const ElementEnergy energy = view.model.blocks()[contact.gap.block]->energy(contact.gap.element);
  impact.energy_lost = energy.dissipated - contact.dissipated_before;
  impact.friction_loss = energy.friction - contact.friction_before;
  const double ratio = -rate / impact.approach_speed;
  const bool comparable = separated && listed_[contact.impact].approached && ratio <= largest_rebound_ratio;
  impact.rebound_ratio = comparable ? ratio : std::numeric_limits<double>::quiet_NaN();
}

void ImpactRecorder::finish(const StepView& view) {
  for (const Ongoing& contact : ongoing_) close(view, contact, view.model.state().time, 0.0, false);
  ongoing_.clear();
  for (std::size_t i = 0; i < impacts_.size(); ++i) {
    const auto [gap, approached] = listed_[i];
    if (approached && with_energies_)
      impacts_[i].restitution =
          view.model.blocks()[gap.block]->contacts()->delivered_restitution(gap.element, impacts_[i].approach_speed);
  }
}

}  // namespace moat
