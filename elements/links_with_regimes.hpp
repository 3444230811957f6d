// Links whose law changes at instants.
#pragma once

#include <algorithm>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "elements/links.hpp"
#include "elements/regime_search.hpp"

namespace moat {

/// Links whose law has regimes: bearings that yield and unload at located instants, and contacts (ContactLinks).
///
/// The margin inside a step is that of the cubic through deformation and rate at both ends. A change at the end of a
/// located step is entered there; a change inside a step is entered at its interpolated instant.
template <LawWithRegimes Law, class Ends = NodePair>
class LinksWithRegimes : public Links<Law, Ends>, public Regimes {
  using Base = Links<Law, Ends>;

 public:
  /// History of one element.
  using State = typename Law::State;

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinksWithRegimes>(*this); }
  std::unique_ptr<ElementBlock> part(std::span<const std::size_t> kept, const NumbersInPart& numbers) const override {
    auto copy = std::make_unique<LinksWithRegimes>();
    copy->take(*this, kept, numbers);
    return copy;
  }
  Regimes* regimes() override { return this; }
  const Regimes* regimes() const override { return this; }

  void scan(double step, double aim, RegimeScan& scan) const override {
    for (std::size_t i = 0; i < this->size(); ++i) scan_link(i, step, aim, scan);
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
    for (std::size_t i = 0; i < this->size(); ++i) {
      if (this->laws_[i].regime_margin(this->committed_[i], this->now_.deformations[i], this->now_.rates[i]) >= 0.0)
        continue;
      if (opens(i)) {
        if (jumps_at_opening(i)) return false;
        continue;  // it has no force any more
      }
      const double fraction = margin_path(i, step).first_crossing(1.0, aim);
      const HermiteQuintic path = path_between(this->start_, this->now_, i, step);
      const double rate = path.rate(fraction);
      const State next = this->laws_[i].next_regime(this->committed_[i], path.value(fraction), rate);
      if (jumps_at_entry(i, next, rate)) return false;
      before_changes_inside_.push_back({i, this->committed_[i], heat_before(i, next)});
      changes.push_back({.block = block_index, .element = i, .time = fraction * step, .rate = rate, .inside = true});
      enter(i, next, rate, changes.back());
    }
    return true;
  }

  void undo_changes_inside() override {
    for (; !before_changes_inside_.empty(); before_changes_inside_.pop_back()) {
      const ChangeInside& change = before_changes_inside_.back();
      RegimeChange taken_back;
      enter(change.link, change.state, 0.0, taken_back);
    }
  }

  void commit(double step, WorkRule rule) override {
    Base::commit(step, rule);
    for (const ChangeInside& change : before_changes_inside_) this->energies_.release(change.link, change.heat);
    before_changes_inside_.clear();
  }

 protected:
  /// Puts a link into a regime at this rate of deformation, m/s, and notes whether a contact touched or opened.
  virtual void enter(std::size_t i, const State& next, double, RegimeChange&) { this->committed_[i] = next; }
  /// Whether a contact opens inside the trial step, and whether it still pulls there.
  [[nodiscard]] virtual bool opens(std::size_t) const { return false; }
  /// Whether it still pulls there, so that the force jumps to zero.
  [[nodiscard]] virtual bool jumps_at_opening(std::size_t) const { return false; }
  /// Whether the force jumps where a link enters `next` inside the trial step.
  [[nodiscard]] virtual bool jumps_at_entry(std::size_t, const State&, double) const { return false; }

 private:
  [[nodiscard]] MarginPath<Law> margin_path(std::size_t i, double step) const {
    return {this->laws_[i], this->committed_[i], cubic_between(this->start_, this->now_, i, step)};
  }

  void scan_link(std::size_t i, double step, double aim, RegimeScan& scan) const {
    const double end_margin =
        this->laws_[i].regime_margin(this->committed_[i], this->now_.deformations[i], this->now_.rates[i]);
    if (end_margin < scan.margin) {
      scan.margin = end_margin;
      scan.nearest = i;
    }
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // A crossing that returns within the step is possible only where the deformation turns inside it.
      beyond = turning_point(this->start_.rates[i], this->now_.rates[i]);
      if (beyond <= 0.0 || margin_path(i, step)(beyond) >= 0.0) return;
      scan.crossed_back = true;
    }
    scan.crossed = true;
    ++scan.crossings;
    if (scan.fraction > 0.0) scan.fraction = std::min(scan.fraction, margin_path(i, step).first_crossing(beyond, aim));
  }

  // A change inside the step being tried.
  struct ChangeInside {
    std::size_t link;
    State state;  // before
    double heat;  // J, from the start of the step until the change
  };
  // The account of the step begins in the next regime.
  [[nodiscard]] double heat_before(std::size_t i, const State& next) const {
    if constexpr (LinkEnergies<Law>::hysteretic)
      return this->laws_[i].dissipated_energy(this->committed_[i], next);
    else
      return 0.0;
  }

  std::vector<ChangeInside> before_changes_inside_;
};

}  // namespace moat
