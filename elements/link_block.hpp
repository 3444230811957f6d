// Elements with one law between two nodes.
#pragma once

#include <algorithm>
#include <concepts>
#include <limits>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "elements/ends.hpp"
#include "materials/contact_state.hpp"
#include "materials/free_impact.hpp"
#include "materials/response.hpp"
#include "model/element_block.hpp"
#include "model/model.hpp"

namespace moat {

/// All elements of a model that put a law of type Law between two nodes.
///
///     deformation d = u(second) - u(first) - offset;  the law's force pulls `second` back and `first` along.
///
/// A spring has its lower node first; a contact has its right node first and its clearance as offset,
/// so that d is the indentation and a positive force is compression. `Ends` tells where the ends are attached:
/// at nodes (NodePair) or at points between nodes (PointPair).
template <ForceLaw Law, class Ends = NodePair>
class LinkBlock final : public ElementBlock {
 public:
  using State = typename Law::State;

  /// Appends an element. effective_mass (kg) is used only to estimate how long a contact lasts.
  std::size_t add(ElementInfo info, const Law& law, double effective_mass = 0.0)
    requires std::constructible_from<Ends, const ElementInfo&>
  {
    const Ends ends{info};
    return add(std::move(info), law, effective_mass, ends);
  }
  std::size_t add(ElementInfo info, const Law& law, double effective_mass, const Ends& ends) {
    ends_.push_back(ends);
    offsets_.push_back(info.offset);
    infos_.push_back(std::move(info));
    laws_.push_back(law);
    effective_masses_.push_back(effective_mass);
    const std::size_t count = infos_.size();
    committed_.resize(count);
    trial_.resize(count);
    for (auto* values : {&deformations_, &rates_, &forces_, &stiffnesses_, &dampings_})
      values->resize(count, 0.0);
    starts_.resize(count);
    accounts_.resize(count);
    return count - 1;
  }

  [[nodiscard]] const Law& law(std::size_t element) const { return laws_[element]; }
  [[nodiscard]] const State& committed(std::size_t element) const { return committed_[element]; }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinkBlock>(*this); }
  std::size_t size() const override { return infos_.size(); }
  const ElementInfo& info(std::size_t element) const override { return infos_[element]; }

  void add_couplings(PatternBuilder& pattern) const override {
    for (const Ends& ends : ends_) ends.add_couplings(pattern);
  }

  void find_slots(const SparseMatrix& matrix) override {
    for (Ends& ends : ends_) ends.find_slots(matrix);
  }

  void evaluate(const double* displacement, const double* velocity) override {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      deformations_[i] = ends_[i].difference(displacement) - offsets_[i];
      rates_[i] = ends_[i].difference(velocity);
      const Response response = laws_[i].evaluate(committed_[i], deformations_[i], rates_[i], trial_[i]);
      forces_[i] = response.force;
      stiffnesses_[i] = response.stiffness;
      dampings_[i] = response.damping;
    }
  }

  void add_forces(double* force) const override {
    for (std::size_t i = 0; i < ends_.size(); ++i) ends_[i].add_force(forces_[i], force);
  }

  void add_tangent(double displacement_weight, double velocity_weight, double* values) const override {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      ends_[i].add_stiffness(displacement_weight * stiffnesses_[i] + velocity_weight * dampings_[i], values);
  }

  void add_linear_stiffness(StiffnessStage stage, double* values) const override {
    for (std::size_t i = 0; i < ends_.size(); ++i) ends_[i].add_stiffness(laws_[i].linear_stiffness(stage), values);
  }

  void commit(double step) override {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      Start& start = starts_[i];
      const double power = laws_[i].dissipation_rate(trial_[i], deformations_[i], rates_[i]);
      if (step > 0.0) {
        Account& account = accounts_[i];
        account.work += 0.5 * (start.force + forces_[i]) * (deformations_[i] - start.deformation);
        account.dissipated += dissipated_in_step(i, step, power);
      }
      start = {deformations_[i], rates_[i], forces_[i], power};
    }
    committed_.swap(trial_);
  }

  void start_energy_account() override {
    for (std::size_t i = 0; i < ends_.size(); ++i)
      accounts_[i] = {.work = 0.0, .dissipated = 0.0, .stored_at_start = stored(i)};
  }

  ElementEnergy energy(std::size_t element) const override {
    const Account& account = accounts_[element];
    return {account.work, stored(element) - account.stored_at_start, account.dissipated, rate_independent};
  }

  std::span<const double> deformations() const override { return deformations_; }
  std::span<const double> rates() const override { return rates_; }
  std::span<const double> forces() const override { return forces_; }

  bool linear_between_events() const override { return LinearWithinRegimes<Law> || ContactLaw<Law>; }
  bool has_regimes() const override { return LawWithRegimes<Law>; }

  void scan_regimes(double step, RegimeScan& scan) const override {
    if constexpr (LawWithRegimes<Law>)
      for (std::size_t i = 0; i < ends_.size(); ++i) scan_element(i, step, scan);
  }

  void change_regimes(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    if constexpr (LawWithRegimes<Law>) {
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        // One change may lead straight into another (a touch that is already separating); three visit every phase.
        for (int change = 0; change < 3; ++change) {
          if (laws_[i].regime_margin(committed_[i], starts_[i].deformation, starts_[i].rate) >= 0.0) break;
          const double stored_before = stored(i);
          committed_[i] = laws_[i].next_regime(committed_[i], starts_[i].deformation, starts_[i].rate);
          // A contact that ends while still indented gives up what it had stored.
          accounts_[i].dissipated += stored_before - stored(i);
          if (change == 0) changes.push_back({block_index, i});
        }
      }
    }
  }

  double shortest_contact() const override {
    double shortest = std::numeric_limits<double>::infinity();
    if constexpr (ContactLaw<Law>)
      for (std::size_t i = 0; i < ends_.size(); ++i)
        if (committed_[i].phase != ContactPhase::open)
          shortest = std::min(shortest, laws_[i].contact_duration(effective_masses_[i], committed_[i].approach_speed));
    return shortest;
  }

  ContactView contact(std::size_t element) const override {
    if constexpr (ContactLaw<Law>)
      return {committed_[element].phase != ContactPhase::open, committed_[element].approach_speed};
    else
      return {};
  }

  double delivered_restitution(std::size_t element, double approach_speed) const override {
    if constexpr (ContactLaw<Law>) {
      try {
        return moat::delivered_restitution(laws_[element], effective_masses_[element], approach_speed);
      } catch (const Error&) {
        // A contact that never ends has no restitution; the impact itself is reported all the same.
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  static constexpr bool rate_independent =
      requires(const Law& law, const State& state) { law.dissipated_energy(state, state); };

  // The element at the last commit.
  struct Start {
    double deformation = 0.0, rate = 0.0, force = 0.0, power = 0.0;
  };
  struct Account {
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0;
  };

  double stored(std::size_t i) const { return laws_[i].stored_energy(committed_[i], starts_[i].deformation); }

  // Energy dissipated from the last commit to the trial state; `end_power` is the dissipation rate there.
  double dissipated_in_step(std::size_t i, double step, double end_power) const {
    if constexpr (rate_independent) {
      // Rate-independent laws know it from their states, also where they yield inside the step.
      return laws_[i].dissipated_energy(committed_[i], trial_[i]);
    } else {
      const Start& start = starts_[i];
      const double rise = deformations_[i] - start.deformation;
      const double middle = start.deformation + 0.5 * rise + 0.125 * step * (start.rate - rates_[i]);
      const double middle_rate = 1.5 * rise / step - 0.25 * (start.rate + rates_[i]);
      const double middle_power = laws_[i].dissipation_rate(committed_[i], middle, middle_rate);
      return step / 6.0 * (start.power + 4.0 * middle_power + end_power);
    }
  }

  void scan_element(std::size_t i, double step, RegimeScan& scan) const
    requires LawWithRegimes<Law>
  {
    const double end_margin = laws_[i].regime_margin(committed_[i], deformations_[i], rates_[i]);
    scan.margin = std::min(scan.margin, end_margin);
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // Beyond the margin and back within the step: only where the deformation turns inside it.
      beyond = turning_point(i);
      if (beyond <= 0.0 || margin_inside(i, step, beyond) >= 0.0) return;
    }
    scan.crossed = true;
    if (scan.fraction > 0.0) scan.fraction = std::min(scan.fraction, first_crossing(i, step, beyond, scan.aim));
  }

  // Fraction of the step at which the interpolated margin falls to `aim`, looked for between 0 and `beyond`
  // by regula falsi (Illinois). `beyond` itself if it never falls that far.
  double first_crossing(std::size_t i, double step, double beyond, double aim) const {
    double low = 0.0, high = beyond;
    double above = margin_inside(i, step, low) - aim, below = margin_inside(i, step, high) - aim;
    if (below >= 0.0) return beyond;
    if (above <= 0.0) return 0.0;
    int side = 0;
    for (int count = 0; count < 60 && high - low > 1e-15; ++count) {
      const double x = low + (high - low) * above / (above - below);
      const double value = margin_inside(i, step, x) - aim;
      if (value > 0.0) {
        low = x;
        above = value;
        if (side == 1) below *= 0.5;
        side = 1;
      } else {
        high = x;
        below = value;
        if (side == -1) above *= 0.5;
        side = -1;
      }
    }
    return high;
  }

  // The margin where the deformation is interpolated by the cubic through deformation and rate at both ends.
  double margin_inside(std::size_t i, double step, double x) const {
    const double rise = deformations_[i] - starts_[i].deformation;
    const double left = step * starts_[i].rate - rise, right = rise - step * rates_[i];
    const double deformation = starts_[i].deformation + x * rise + x * (1.0 - x) * ((1.0 - x) * left + x * right);
    const double slope = rise + (1.0 - x) * (1.0 - 3.0 * x) * left + x * (2.0 - 3.0 * x) * right;
    return laws_[i].regime_margin(committed_[i], deformation, slope / step);
  }

  // Fraction at which the deformation turns inside the step, 0 if it does not. A linear rate is exact for
  // average acceleration and close enough for others to decide whether to look.
  double turning_point(std::size_t i) const {
    const double start = starts_[i].rate, end = rates_[i];
    return start * end < 0.0 ? start / (start - end) : 0.0;
  }

  std::vector<ElementInfo> infos_;
  std::vector<Law> laws_;
  std::vector<double> effective_masses_;
  std::vector<Ends> ends_;
  std::vector<double> offsets_;
  std::vector<State> committed_, trial_;
  std::vector<double> deformations_, rates_, forces_, stiffnesses_, dampings_;
  std::vector<Start> starts_;
  std::vector<Account> accounts_;
};

}  // namespace moat
