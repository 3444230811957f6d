#include "output/impact_recorder.hpp"

#include <algorithm>
#include <limits>

namespace moat {
namespace {

bool same(RegimeChange a, RegimeChange b) { return a.block == b.block && a.element == b.element; }

}  // namespace

void ImpactRecorder::start(const StepView& view) {
  for (std::size_t b = 0; b < view.model.blocks().size(); ++b)
    for (std::size_t e = 0; e < view.model.blocks()[b]->size(); ++e)
      if (view.model.blocks()[b]->contact(e).touching) open(view, {b, e});
}

void ImpactRecorder::follow(const StepView& view, bool after_event) {
  const double time = view.model.state().time;
  for (Ongoing& contact : ongoing_) {
    const ElementBlock& block = *view.model.blocks()[contact.gap.block];
    const std::size_t element = contact.gap.element;
    const double indentation = block.deformations()[element], rate = block.rates()[element];
    const double force = block.forces()[element], force_rate = block.force_rates()[element];
    if (after_event) {
      contact.indentation.restart(time, indentation, rate);
      contact.force.restart(time, force, force_rate);
    } else {
      contact.indentation.add(time, indentation, rate);
      contact.force.add(time, force, force_rate,
                        [&](double fraction, double) { return block.force_inside(element, fraction); });
    }
  }
}

void ImpactRecorder::step(const StepView& view) { follow(view, false); }

void ImpactRecorder::event(const StepView& view, std::span<const RegimeChange> changes) {
  for (const RegimeChange gap : changes) {
    const bool touching = view.model.blocks()[gap.block]->contact(gap.element).touching;
    const auto known =
        std::find_if(ongoing_.begin(), ongoing_.end(), [&](const Ongoing& o) { return same(o.gap, gap); });
    if (touching && known == ongoing_.end()) {
      open(view, gap);
    } else if (!touching && known != ongoing_.end()) {
      close(view, *known, true);
      ongoing_.erase(known);
    }
  }
  follow(view, true);
}

void ImpactRecorder::open(const StepView& view, RegimeChange gap) {
  const ElementBlock& block = *view.model.blocks()[gap.block];
  const double speed = block.contact(gap.element).approach_speed;
  ongoing_.push_back({gap, impacts_.size(), {}, {}, block.energy(gap.element).dissipated});
  impacts_.push_back({.where = block.info(gap.element).name,
                      .start = view.model.state().time,
                      .approach_speed = speed,
                      .restitution = std::numeric_limits<double>::quiet_NaN()});
  gaps_.push_back(gap);
}

void ImpactRecorder::close(const StepView& view, const Ongoing& contact, bool separated) {
  Impact& impact = impacts_[contact.impact];
  impact.duration = view.model.state().time - impact.start;
  impact.largest_indentation = contact.indentation.magnitude();
  impact.largest_force = contact.force.magnitude();
  impact.energy_lost =
      view.model.blocks()[contact.gap.block]->energy(contact.gap.element).dissipated - contact.dissipated_before;
  const double separation_speed = -view.model.blocks()[contact.gap.block]->rates()[contact.gap.element];
  impact.rebound_ratio =
      separated ? separation_speed / impact.approach_speed : std::numeric_limits<double>::quiet_NaN();
}

void ImpactRecorder::finish(const StepView& view) {
  for (const Ongoing& contact : ongoing_) close(view, contact, false);
  ongoing_.clear();
  for (std::size_t i = 0; i < impacts_.size(); ++i)
    impacts_[i].restitution =
        view.model.blocks()[gaps_[i].block]->delivered_restitution(gaps_[i].element, impacts_[i].approach_speed);
}

}  // namespace moat
