// Links whose law changes at instants.
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "elements/line/link_changes.hpp"
#include "elements/line/link_over_step.hpp"
#include "elements/line/links.hpp"
#include "elements/line/regime_search.hpp"

namespace moat {

/// Links whose law has regimes: bearings that yield and unload at located instants, and contacts (ContactLinks).
///
/// Whether a margin is crossed inside a step is judged on the cubic through deformation and rate at both ends, and
/// where on the quintic through both rates. A change at the end of a located step is entered there; a change inside a
/// step is entered at its interpolated instant.
template <LawWithRegimes Law, class Ends = NodePair>
class LinksWithRegimes : public Links<Law, Ends>, public Regimes {
  using Base = Links<Law, Ends>;

 public:
  /// History of one element.
  using State = typename Law::State;

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinksWithRegimes>(*this); }
  Regimes* regimes() override { return this; }
  const Regimes* regimes() const override { return this; }

  void scan(double step, double aim, RegimeScan& scan) const override {
    for (std::size_t i = 0; i < this->size(); ++i) scan_link(i, step, aim, scan);
  }

  double next_fall(double aim) const override {
    double first = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < this->size(); ++i) {
      const double deformation = this->now_.deformations[i], rate = this->now_.rates[i],
                   second_rate = this->now_.second_rates[i];
      const auto margin_above_aim = [&](double time) {
        return this->laws_[i].regime_margin(this->committed_[i], deformation + time * (rate + 0.5 * time * second_rate),
                                            rate + time * second_rate) -
               aim;
      };
      first = std::min(first, fall_near(margin_above_aim));
    }
    return first;
  }

  void change(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    for (std::size_t i = 0; i < this->size(); ++i) {
      const double deformation = this->start_.deformations[i], rate = this->start_.rates[i];
      // One change may be followed at once by another (a touch that is already separating). Three changes cover every
      // phase.
      for (int count = 0; count < 3; ++count) {
        if (this->laws_[i].regime_margin(this->committed_[i], deformation, rate) >= 0.0) break;
        const double stored_before = this->stored(i);
        if (count == 0) changes.push_back({.block = block_index, .element = i, .rate = rate});
        enter(i, this->laws_[i].next_regime(this->committed_[i], deformation, rate), rate, changes.back());
        // A contact that ends while still indented gives up the energy it had stored.
        this->energies_.release(i, stored_before - this->stored(i));
      }
    }
  }

  bool change_inside(double step, double aim, std::size_t block_index, std::vector<RegimeChange>& changes) override {
    for (std::size_t i = 0; i < this->size(); ++i)
      // As in change().
      for (int count = 0; count < 3 && margin_now(i) < 0.0; ++count) {
        const HermiteQuintic path = path_between(this->start_, this->now_, i, step);
        const auto before = changes_.of(i);
        const double crossing = margin_on_quintic(i, step).first_crossing(1.0, aim),
                     fraction = std::max(before.empty() ? 0.0 : before.back().fraction, crossing);
        const double deformation = path.value(fraction), rate = path.rate(fraction);
        const State next = this->laws_[i].next_regime(this->committed_[i], deformation, rate);
        if (jumps(i, next, rate)) return false;
        changes_.add({i, this->committed_[i], fraction, heat_until(i, next, deformation)});
        changes.push_back({.block = block_index, .element = i, .time = fraction * step, .rate = rate, .inside = true});
        enter(i, next, rate, changes.back());
      }
    return true;
  }

  void undo_changes_inside() override {
    const std::span<const Change> changes = changes_.of_step();
    for (auto change = changes.rbegin(); change != changes.rend(); ++change) {
      RegimeChange taken_back;
      enter(change->link, change->before, 0.0, taken_back);
    }
    changes_.clear();
  }

  bool add_missed_impulses(double step, const ImpulseRules& rules, MissedImpulses& missed) override {
    const std::span<const std::size_t> links = changes_.links();
    for (const std::size_t i : links) {
      const ForceOverStep force = over_step(i, step).force();
      const auto add = [&](double integral, const ImpulseRule& rule, Vector& impulses) {
        this->ends_[i].add_force(-force.missed(integral, rule, step), impulses.data());
      };
      add(force.impulse, rules.of_velocity, missed.of_velocity);
      add(force.impulse, rules.of_evaluated_velocity, missed.of_evaluated_velocity);
      add(force.falling, rules.of_displacement, missed.of_displacement);
    }
    return !links.empty();
  }

  void commit(double step, WorkRule rule) override {
    // The work of links that change is that of the parts of the step.
    works_.clear();
    if (this->energies_.kept())
      for (const Change& change : changes_.of_step()) works_.push_back(total_work(change.link, step));
    Base::commit(step, rule);
    for (std::size_t k = 0; k < works_.size(); ++k)
      this->energies_.set_total_work(changes_.of_step()[k].link, works_[k]);
    for (const Change& change : changes_.of_step()) this->energies_.release(change.link, change.heat);
    changes_.commit();
  }

 protected:
  /// Puts a link into a regime at this rate of deformation, m/s, and notes whether a contact touched or opened.
  virtual void enter(std::size_t i, const State& next, double, RegimeChange&) { this->committed_[i] = next; }
  /// Whether the force jumps where a link enters `next` inside the trial step, at this rate of deformation, m/s.
  [[nodiscard]] virtual bool jumps([[maybe_unused]] std::size_t i, [[maybe_unused]] const State& next, double) const {
    if constexpr (requires { next.jumps_to(next); }) return this->committed_[i].jumps_to(next);
    return false;
  }

 private:
  // At the end of the trial step, m.
  [[nodiscard]] double margin_now(std::size_t i) const {
    return this->laws_[i].regime_margin(this->committed_[i], this->now_.deformations[i], this->now_.rates[i]);
  }
  // Over the trial step.
  [[nodiscard]] MarginPath<Law, HermiteCubic> margin_on_cubic(std::size_t i, double step) const {
    return {this->laws_[i], this->committed_[i], cubic_between(this->start_, this->now_, i, step)};
  }
  [[nodiscard]] MarginPath<Law, HermiteQuintic> margin_on_quintic(std::size_t i, double step) const {
    return {this->laws_[i], this->committed_[i], path_between(this->start_, this->now_, i, step)};
  }

  void scan_link(std::size_t i, double step, double aim, RegimeScan& scan) const {
    const double end_margin = margin_now(i);
    if (end_margin < scan.margin) {
      scan.margin = end_margin;
      scan.nearest = i;
    }
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // A crossing that returns within the step is possible only where the deformation turns inside it.
      beyond = turning_point(this->start_.rates[i], this->now_.rates[i]);
      if (beyond <= 0.0 || margin_on_cubic(i, step)(beyond) >= 0.0) return;
      scan.crossed_back = true;
    }
    scan.crossed = true;
    ++scan.crossings;
    // The step ends in the band that locate_change() aims at: to look for the instant would be in vain.
    if (end_margin >= 2.0 * aim && !scan.crossed_back) return;
    if (scan.fraction > 0.0)
      scan.fraction = std::min(scan.fraction, margin_on_quintic(i, step).first_crossing(beyond, aim));
  }

  // The energy, J, that a link loses until and in a change, and that the account of its next regime does not see: that
  // of a law with a path begins there, and a contact that ends while still indented gives up the energy it had stored.
  [[nodiscard]] double heat_until(std::size_t i, const State& next, double deformation) const {
    const Law& law = this->laws_[i];
    const State& before = this->committed_[i];
    double heat = law.stored_energy(before, deformation) - law.stored_energy(next, deformation);
    if constexpr (LinkEnergies<Law>::hysteretic) heat += law.dissipated_energy(before, next);
    return heat;
  }

  [[nodiscard]] LinkOverStep<Law> over_step(std::size_t i, double step) const {
    return {this->laws_[i], this->start_, this->now_, i, step, changes_.of(i), this->committed_[i]};
  }
  // Until the end of the step being tried.
  [[nodiscard]] TotalWork total_work(std::size_t i, double step) const {
    const TotalWork before = this->energies_.total_work(i), of_step = over_step(i, step).work();
    TotalWork total{before.work + of_step.work, before.dissipated + of_step.dissipated};
    if constexpr (LinkEnergies<Law>::hysteretic)
      total.dissipated += this->laws_[i].dissipated_energy(this->committed_[i], this->trial_[i]);
    return total;
  }

  using Change = typename LinkChanges<State>::Change;
  LinkChanges<State> changes_;
  std::vector<TotalWork> works_;  // of changes_.of_step(), in commit()
};

}  // namespace moat
