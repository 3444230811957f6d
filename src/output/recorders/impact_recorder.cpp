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
  const double time = view.model.state().time;
  for (Ongoing& contact : ongoing_) {
    const ElementBlock& block = *view.model.blocks()[contact.gap.block];
    const std::size_t element = contact.gap.element;
    const PlanContacts* sliding = block.plan_contacts();
    const ElementResults results = block.results();
    const double indentation = results.deformations[element], rate = results.rates[element];
    const double force = results.forces[element], force_rate = results.force_rates[element];
    ContactLoop& loop = impacts_[contact.impact].loop;
    loop.indentation.push_back(indentation);
    loop.force.push_back(force);
    if (after_event) {
      contact.indentation.restart(time, indentation, rate);
      contact.force.restart(time, force, force_rate);
      if (sliding != nullptr)
        contact.friction.restart(time, sliding->friction_force(element), sliding->friction_force_rate(element));
    } else {
      contact.indentation.add(time, indentation, rate);
      contact.force.add(time, force, force_rate, [&](double fraction, double of_cubic) {
        return block.laws() != nullptr ? block.laws()->force_inside(element, fraction) : of_cubic;
      });
      if (sliding != nullptr)
        contact.friction.add(time, sliding->friction_force(element), sliding->friction_force_rate(element));
    }
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
  const ElementEnergy energy = block.energy(gap.element);
  ongoing_.push_back({gap, impacts_.size(), {}, {}, {}, energy.dissipated, energy.friction});
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
  Impact& impact = impacts_[contact.impact];
  impact.duration = time - impact.start;
  impact.largest_indentation = contact.indentation.magnitude();
  impact.largest_force = contact.force.magnitude();
  impact.largest_friction_force = contact.friction.magnitude();
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
    if (approached)
      impacts_[i].restitution =
          view.model.blocks()[gap.block]->contacts()->delivered_restitution(gap.element, impacts_[i].approach_speed);
  }
}

}  // namespace moat
