#include "output/recorders/impact_recorder.hpp"

#include <algorithm>
#include <limits>

namespace moat {
namespace {

bool same(RegimeChange a, RegimeChange b) { return a.block == b.block && a.element == b.element; }

}  // namespace

void ImpactRecorder::start(const StepView& view) {
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b)
    for (std::size_t e = 0; e < view.model.blocks()[b]->size(); ++e)
      if (view.state.elements(b).contact(e).touching)
        // Later than at time 0, the contact lasts from an earlier analysis.
        open(view, {.block = b, .element = e, .time = view.state.time()}, view.state.time() == 0.0);
}

void ImpactRecorder::follow(const StepView& view, bool after_event) {
  if (!with_energies_) return;
  for (Ongoing& contact : ongoing_) {
    const ElementStates& elements = view.state.elements(contact.gap.block);
    const std::size_t element = contact.gap.element;
    CommonInstant& next = contact.peaks.next();
    const ContactView now = elements.contact(element);
    const ElementResult result = elements.results()[element];
    next.time = view.state.time();
    next.values = {result.deformation, result.force, now.friction_force};
    next.rates = {result.rate, result.force_rate, now.friction_force_rate};
    ContactLoop& loop = impacts_[contact.impact].loop;
    loop.indentation.push_back(next.values[0]);
    loop.force.push_back(next.values[1]);
    if (after_event)
      contact.peaks.restart();
    else
      contact.peaks.add([&](std::size_t quantity, double fraction, double of_cubic) {
        return quantity == 1 ? elements.force_inside(element, fraction) : of_cubic;
      });
  }
}

void ImpactRecorder::step(const StepView& view) { follow(view, false); }

void ImpactRecorder::event(const StepView& view, std::span<const RegimeChange> changes) {
  for (const RegimeChange gap : changes) {
    if (!view.model.blocks()[gap.block]->kind().contacts) continue;
    const ContactView now = view.state.elements(gap.block).contact(gap.element);
    const auto known =
        std::find_if(ongoing_.begin(), ongoing_.end(), [&](const Ongoing& o) { return same(o.gap, gap); });
    if (now.touching && known == ongoing_.end()) {
      open(view, gap);
    } else if (!now.touching && known != ongoing_.end()) {
      close(view, *known, gap.time, gap.rate, now.departures == known->departures_before);
      ongoing_.erase(known);
    }
  }
  follow(view, true);
}

void ImpactRecorder::open(const StepView& view, RegimeChange gap, bool closed_at_start) {
  const ElementInfo& info = view.model.blocks()[gap.block]->info(gap.element);
  const ElementStates& elements = view.state.elements(gap.block);
  const ContactView now = elements.contact(gap.element);
  const ElementEnergy energy = with_energies_ ? elements.energy(gap.element) : ElementEnergy{};
  ongoing_.push_back({gap, impacts_.size(), PeakTrackers{3}, energy.dissipated, energy.friction, now.departures});
  impacts_.push_back({.where = info.name,
                      .start = gap.time,
                      .approach_speed = now.approach_speed,
                      .restitution = std::numeric_limits<double>::quiet_NaN()});
  if (const CornerPair* pair = info.corner_pair()) {
    impacts_.back().corner = pair->corner;
    impacts_.back().edge = pair->edge;
    impacts_.back().tangential_speed = now.tangential_speed_at_touch;
  }
  listed_.push_back({gap, now.approach_speed > 0.0 && !closed_at_start});
}

void ImpactRecorder::close(const StepView& view, const Ongoing& contact, double time, double rate, bool separated) {
  if (!with_energies_) return;
  Impact& impact = impacts_[contact.impact];
  impact.duration = time - impact.start;
  impact.largest_indentation = contact.peaks.magnitude(0);
  impact.largest_force = contact.peaks.magnitude(1);
  impact.largest_friction_force = contact.peaks.magnitude(2);
  const ElementEnergy energy = view.state.elements(contact.gap.block).energy(contact.gap.element);
  impact.energy_lost = energy.dissipated - contact.dissipated_before;
  impact.friction_loss = energy.friction - contact.friction_before;
  const double ratio = -rate / impact.approach_speed;
  const bool comparable = separated && listed_[contact.impact].approached && ratio <= largest_rebound_ratio;
  impact.rebound_ratio = comparable ? ratio : std::numeric_limits<double>::quiet_NaN();
}

void ImpactRecorder::finish(const StepView& view) {
  for (const Ongoing& contact : ongoing_) close(view, contact, view.state.time(), 0.0, false);
  ongoing_.clear();
  for (std::size_t i = 0; i < impacts_.size(); ++i) {
    const auto [gap, approached] = listed_[i];
    if (approached && with_energies_)
      impacts_[i].restitution =
          view.model.blocks()[gap.block]->delivered_restitution(gap.element, impacts_[i].approach_speed);
  }
}

}  // namespace moat
