// Elements with one law between two nodes.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "base/hermite.hpp"
#include "base/parallel.hpp"
#include "elements/ends.hpp"
#include "elements/shares.hpp"
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

  /// Appends an element. effective_mass (> 0 kg, contacts only) serves to estimate how long a contact lasts, and for
  /// the approach speed that the law of a gap counts which starts closed.
  std::size_t add(ElementInfo info, const Law& law,
                  double effective_mass = 0.0) requires std::constructible_from<Ends, const ElementInfo&> {
    const Ends ends{info};
    return add(std::move(info), law, effective_mass, ends);
  }
  std::size_t add(ElementInfo info, const Law& law, double effective_mass, const Ends& ends) {
    ends_.push_back(ends);
    slots_.emplace_back();
    offsets_.push_back(info.offset);
    infos_.push_back(std::move(info));
    laws_.push_back(law);
    if constexpr (ContactLaw<Law>) {
      effective_masses_.push_back(effective_mass);
      durations_.push_back(0.0);
      approach_speeds_.push_back(0.0);
    }
    const std::size_t count = infos_.size();
    committed_.resize(count);
    trial_.resize(count);
    for (auto* values : {&deformations_, &rates_, &second_rates_, &forces_, &force_rates_}) values->resize(count, 0.0);
    if constexpr (!is_linear) {
      stiffnesses_.resize(count, 0.0);
      dampings_.resize(count, 0.0);
    }
    if (keeps_start()) allocate_start();
    if (accounting_) accounts_.resize(count);
    return count - 1;
  }

  [[nodiscard]] const Law& law(std::size_t element) const { return laws_[element]; }
  [[nodiscard]] const State& committed(std::size_t element) const { return committed_[element]; }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<LinkBlock>(*this); }
  std::size_t size() const override { return ends_.size(); }
  const ElementInfo& info(std::size_t element) const override { return infos_[element]; }

  void add_couplings(PatternBuilder& pattern) const override {
    for (std::size_t i = 0; i < size(); ++i) ends_[i].add_couplings(infos_[i], pattern);
  }

  void find_slots(const SparseMatrix& matrix) override {
    for (std::size_t i = 0; i < size(); ++i) {
      ends_[i].find_entries(infos_[i], matrix);
      slots_[i].find(ends_[i], infos_[i], matrix);
    }
    share_out(matrix);
  }

  void use_threads(int threads, const SparseMatrix& matrix) override {
    if (threads == threads_) return;
    threads_ = threads;
    share_out(matrix);
  }

  void evaluate(const double* displacement, const double* velocity, double* force) override {
    if (threads_ == 1) {
      evaluate_range(0, size(), displacement, velocity, force);
      return;
    }
    for_ranges(threads_, size(), [=, this](std::size_t begin, std::size_t end) {
      evaluate_range(begin, end, displacement, velocity, nullptr);
    });
    if (force != nullptr)
      entry_shares_.add(
          threads_, [this](std::size_t i) { return forces_[i]; }, force);
  }

  void evaluate_rates(const double* acceleration, double* force_rate) override {
    const Ends* ends = ends_.data();
    const double* rates = rates_.data();
    double* __restrict second_rates = second_rates_.data();
    double* __restrict force_rates = force_rates_.data();
    for (std::size_t i = 0; i < size(); ++i) {
      const Tangents tangents = tangents_of(i);
      second_rates[i] = ends[i].difference(acceleration);
      force_rates[i] = tangents.stiffness * rates[i] + tangents.damping * second_rates[i];
    }
    if (force_rate == nullptr) return;
    for (std::size_t i = 0; i < size(); ++i) ends[i].add_force(force_rates[i], force_rate);
  }

  void add_tangent(double displacement_weight, double velocity_weight, double* values) const override {
    const auto tangent = [&](std::size_t i) {
      const Tangents tangents = tangents_of(i);
      return displacement_weight * tangents.stiffness + velocity_weight * tangents.damping;
    };
    if (threads_ > 1)
      slot_shares_.add(threads_, tangent, values);
    else
      for (std::size_t i = 0; i < size(); ++i) slots_[i].add_stiffness(ends_[i], tangent(i), values);
  }

  bool constant_tangent() const override { return is_linear; }

  bool has_corner() const override {
    if constexpr (!is_linear && !LawWithRegimes<Law>) {
      constexpr double jump = 0.2;
      for (std::size_t i = 0; i < start_stiffnesses_.size(); ++i)
        if (std::abs(stiffnesses_[i] - start_stiffnesses_[i]) >
            jump * std::max(std::abs(stiffnesses_[i]), std::abs(start_stiffnesses_[i])))
          return true;
    }
    return false;
  }

  bool take_tangent_change() override { return tangent_changed_.take(); }

  void add_linear_stiffness(StiffnessStage stage, double* values) const override {
    for (std::size_t i = 0; i < size(); ++i)
      slots_[i].add_stiffness(ends_[i], laws_[i].linear_stiffness(stage), values);
  }

  void commit(double step, WorkRule rule) override {
    if (accounting_)
      for_ranges(threads_, size(),
                 [step, rule, this](std::size_t begin, std::size_t end) { account(step, rule, begin, end); });
    if (keeps_start()) {
      before_.swap(start_);
      start_.deformations = deformations_;
      start_.rates = rates_;
      start_.second_rates = second_rates_;
      if constexpr (!is_linear && !LawWithRegimes<Law>) start_stiffnesses_ = stiffnesses_;
      last_step_ = step;
    }
    committed_.swap(trial_);
    before_changes_inside_.clear();
  }

  void start_energy_account() override {
    accounting_ = true;
    allocate_start();
    start_.deformations = deformations_;
    start_.rates = rates_;
    start_.second_rates = second_rates_;
    accounts_.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
      accounts_[i] = {.force = forces_[i],
                      .power = laws_[i].dissipation_rate(committed_[i], deformations_[i], rates_[i]),
                      .stored_at_start = stored(i)};
  }

  ElementEnergy energy(std::size_t element) const override {
    if (!accounting_) throw std::logic_error{"LinkBlock: energy() without start_energy_account()"};
    const Account& account = accounts_[element];
    return {account.work, stored(element) - account.stored_at_start, account.dissipated, rate_independent};
  }

  void add_energies(EnergySums& sums) const override {
    for (std::size_t i = 0; i < size(); ++i) sums.add(infos_[i].kind, energy(i));
  }

  std::span<const double> deformations() const override { return deformations_; }
  std::span<const double> rates() const override { return rates_; }
  std::span<const double> forces() const override { return forces_; }
  std::span<const double> second_rates() const override { return second_rates_; }
  std::span<const double> force_rates() const override { return force_rates_; }

  double force_inside(std::size_t i, double fraction) const override {
    if (!keeps_start()) throw std::logic_error{"LinkBlock: a linear element's force needs no law to interpolate"};
    const HermiteQuintic path = between(before_, start_, i, last_step_);
    State after;
    // commit() has left the states of the step's start in trial_.
    return laws_[i].evaluate(trial_[i], path.value(fraction), path.rate(fraction), after).force;
  }

  bool linear_between_events() const override { return LinearWithinRegimes<Law> || ContactLaw<Law>; }
  bool has_regimes() const override { return LawWithRegimes<Law>; }

  void scan_regimes(double step, RegimeScan& scan) const override {
    if constexpr (LawWithRegimes<Law>)
      for_ranges(threads_, size(), scan, [step, this](std::size_t begin, std::size_t end, RegimeScan& part) {
        for (std::size_t i = begin; i < end; ++i) scan_element(i, step, part);
      });
  }

  void change_regimes(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    if constexpr (LawWithRegimes<Law>) {
      for (std::size_t i = 0; i < size(); ++i) {
        // One change may lead straight into another (a touch that is already separating); three visit every phase.
        for (int change = 0; change < 3; ++change) {
          if (laws_[i].regime_margin(committed_[i], start_.deformations[i], start_.rates[i]) >= 0.0) break;
          const double stored_before = stored(i);
          const bool touched = contact(i).touching;
          committed_[i] = laws_[i].next_regime(committed_[i], start_.deformations[i], start_.rates[i]);
          if constexpr (ContactLaw<Law>) follow_contact(i, touched, start_.rates[i]);
          // A contact that ends while still indented gives up what it had stored.
          if (accounting_) accounts_[i].dissipated += stored_before - stored(i);
          if (change == 0) changes.push_back({.block = block_index, .element = i, .rate = start_.rates[i]});
          changes.back().touched = changes.back().touched || (!touched && contact(i).touching);
        }
      }
    }
  }

  bool change_regimes_inside(double step, double aim, std::size_t block_index,
                             std::vector<RegimeChange>& changes) override {
    if constexpr (LawWithRegimes<Law>) {
      for (std::size_t i = 0; i < size(); ++i) {
        if (laws_[i].regime_margin(committed_[i], deformations_[i], rates_[i]) >= 0.0) continue;
        const bool touched = contact(i).touching;
        if (touched && deformations_[i] <= 0.0) {
          if constexpr (ContactLaw<Law>)
            if (jumps_at_opening(i)) return false;  // pulls up to there
          continue;                                 // opens, and has no force any more
        }
        const double fraction = first_crossing(i, step, 1.0, aim);
        const HermiteQuintic path = path_of(i, step);
        const double rate = path.rate(fraction);
        const State next = laws_[i].next_regime(committed_[i], path.value(fraction), rate);
        if constexpr (ContactLaw<Law>)
          if (!touched && jumps_at_touch(i, next, rate)) return false;
        before_changes_inside_.push_back({i, committed_[i]});
        committed_[i] = next;
        if constexpr (ContactLaw<Law>) follow_contact(i, touched, rate);
        changes.push_back({.block = block_index,
                           .element = i,
                           .time = fraction * step,
                           .rate = rate,
                           .touched = !touched && contact(i).touching,
                           .inside = true});
      }
    }
    return true;
  }

  void undo_changes_inside() override {
    for (; !before_changes_inside_.empty(); before_changes_inside_.pop_back()) {
      const auto& [i, state] = before_changes_inside_.back();
      const bool touched = contact(i).touching;
      committed_[i] = state;
      if constexpr (ContactLaw<Law>) follow_contact(i, touched, 0.0);
    }
  }

  void open_gaps(std::size_t block_index, std::vector<RegimeChange>& changes) override {
    if constexpr (ContactLaw<Law>) {
      if (touching_ == 0) return;
      for (std::size_t i = 0; i < size(); ++i) {
        if (committed_[i].phase == ContactPhase::open || start_.deformations[i] > 0.0) continue;
        const HermiteQuintic path = between(before_, start_, i, last_step_);
        const double fraction = first_fall([&](double x) { return path.value(x); }, 1.0, 0.0);
        committed_[i] = {};
        follow_contact(i, true, 0.0);
        changes.push_back({.block = block_index,
                           .element = i,
                           .time = (fraction - 1.0) * last_step_,
                           .rate = path.rate(fraction),
                           .inside = true});
      }
    }
  }

  double shortest_contact() const override {
    double shortest = std::numeric_limits<double>::infinity();
    if constexpr (ContactLaw<Law>)
      if (touching_ > 0)
        for (std::size_t i = 0; i < size(); ++i)
          if (committed_[i].phase != ContactPhase::open) shortest = std::min(shortest, durations_[i]);
    return shortest;
  }

  ContactView contact(std::size_t element) const override {
    if constexpr (ContactLaw<Law>) {
      const ContactState& state = committed_[element];
      if (state.phase == ContactPhase::open) return {false, approach_speeds_[element], 0.0};
      const double impulse = effective_masses_[element] * state.approach_speed;
      return {true, approach_speeds_[element], std::numbers::pi * impulse / durations_[element]};
    } else {
      return {};
    }
  }

  double delivered_restitution(std::size_t element, double approach_speed) const override {
    if constexpr (ContactLaw<Law>) {
      if (approach_speed <= 0.0) return std::numeric_limits<double>::quiet_NaN();
      try {
        return moat::delivered_restitution(laws_[element], effective_masses_[element], approach_speed);
      } catch (const Error&) {
        // A contact that never ends has no restitution; the impact itself is reported all the same.
      }
    }
    return std::numeric_limits<double>::quiet_NaN();
  }

 private:
  // Without history and without regimes: both tangents are constants of the law.
  static constexpr bool is_linear = LinearWithinRegimes<Law> && !LawWithRegimes<Law> && std::is_empty_v<State>;
  static constexpr bool rate_independent = requires(const Law& law, const State& state) {
    law.dissipated_energy(state, state);
  };

  // Called after a change of regime.
  // `rate` is that of the deformation at the change, m/s.
  void follow_contact(std::size_t i, bool touched, double rate) requires ContactLaw<Law> {
    const bool touching = contact(i).touching;
    touching_ += static_cast<int>(touching) - static_cast<int>(touched);
    if (touching && !touched) {
      approach_speeds_[i] = rate;
      // A gap that starts closed has no approach: its law counts the speed at which an elastic impact reaches this
      // depth. A located touch is so shallow that the speed is nothing.
      double& counted = committed_[i].approach_speed;
      counted = std::max(counted, std::sqrt(2.0 * stored(i) / effective_masses_[i]));
    }
    if (touching) durations_[i] = laws_[i].contact_duration(effective_masses_[i], committed_[i].approach_speed);
  }

  // Whether the contact still pulls where its gap opens.
  bool jumps_at_opening(std::size_t i) const {
    constexpr double least_indentation = 1e-12, of_expected = 0.01;
    State after;
    const double last = laws_[i].evaluate(committed_[i], least_indentation, rates_[i], after).force;
    return std::abs(last) > of_expected * contact(i).expected_force;
  }

  // Whether the force right after a touch is of the size it has at the end of the step.
  bool jumps_at_touch(std::size_t i, const State& touching, double rate) const {
    constexpr double least_indentation = 1e-12, of_its_size = 0.3;
    State after;
    const double first = laws_[i].evaluate(touching, least_indentation, rate, after).force;
    const double last = laws_[i].evaluate(touching, deformations_[i], rates_[i], after).force;
    return std::abs(first) > of_its_size * std::abs(last);
  }

  // Adds the forces to `force` unless that is null.
  void evaluate_range(std::size_t begin, std::size_t end, const double* displacement, const double* velocity,
                      double* force) {
    // So few at a time that what one loop writes is still at hand for the next.
    constexpr std::size_t at_once = 512;
    for (; begin < end; begin += at_once) {
      const std::size_t piece_end = std::min(begin + at_once, end);
      deform(begin, piece_end, displacement, velocity);
      apply_laws(begin, piece_end);
      if (force == nullptr) continue;
      const Ends* ends = ends_.data();
      const double* forces = forces_.data();
      for (std::size_t i = begin; i < piece_end; ++i) ends[i].add_force(forces[i], force);
    }
  }

  void deform(std::size_t begin, std::size_t end, const double* displacement, const double* velocity) {
    const Ends* ends = ends_.data();
    const double* offsets = offsets_.data();
    double* __restrict deformations = deformations_.data();
    double* __restrict rates = rates_.data();
    for (std::size_t i = begin; i < end; ++i) {
      deformations[i] = ends[i].difference(displacement) - offsets[i];
      rates[i] = ends[i].difference(velocity);
    }
  }

  // A loop over arrays that do not overlap: for most laws the compiler turns it into vector code.
  void apply_laws(std::size_t begin, std::size_t end) {
    const Law* laws = laws_.data();
    const State* committed = committed_.data();
    const double *deformations = deformations_.data(), *rates = rates_.data();
    State* __restrict trial = trial_.data();
    double* __restrict forces = forces_.data();
    double* __restrict stiffnesses = stiffnesses_.data();
    double* __restrict dampings = dampings_.data();
    bool changed = false;
    for (std::size_t i = begin; i < end; ++i) {
      const Response response = laws[i].evaluate(committed[i], deformations[i], rates[i], trial[i]);
      forces[i] = response.force;
      if constexpr (!is_linear) {
        changed |= (stiffnesses[i] != response.stiffness) | (dampings[i] != response.damping);
        stiffnesses[i] = response.stiffness;
        dampings[i] = response.damping;
      }
    }
    if (changed) tangent_changed_.raise();
  }

  struct Account {
    double force = 0.0, power = 0.0;  // at the last commit
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0;
  };

  // How the deformation of every element moves at one instant.
  struct Movement {
    std::vector<double> deformations, rates, second_rates;

    void resize(std::size_t count) {
      for (auto* values : {&deformations, &rates, &second_rates}) values->resize(count, 0.0);
    }
    void swap(Movement& other) {
      deformations.swap(other.deformations);
      rates.swap(other.rates);
      second_rates.swap(other.second_rates);
    }
  };

  static HermiteQuintic between(const Movement& start, const Movement& end, std::size_t i, double step) {
    return {start.deformations[i],
            start.rates[i],
            start.second_rates[i],
            end.deformations[i],
            end.rates[i],
            end.second_rates[i],
            step};
  }
  // From the committed to the trial state.
  HermiteQuintic path_of(std::size_t i, double step) const {
    return {start_.deformations[i],
            start_.rates[i],
            start_.second_rates[i],
            deformations_[i],
            rates_[i],
            second_rates_[i],
            step};
  }

  struct Tangents {
    double stiffness, damping;
  };
  Tangents tangents_of(std::size_t i) const {
    if constexpr (is_linear) {
      State trial;
      const Response response = laws_[i].evaluate(State{}, 0.0, 0.0, trial);
      return {response.stiffness, response.damping};
    } else {
      return {stiffnesses_[i], dampings_[i]};
    }
  }

  // Whether the movement at the last commits is needed: for changes of regime, forces inside a step, and energies.
  bool keeps_start() const { return !is_linear || accounting_; }

  void allocate_start() {
    start_.resize(size());
    before_.resize(size());
  }

  void share_out(const SparseMatrix& matrix) {
    if (threads_ <= 1) return;
    entry_shares_ = Shares{static_cast<std::size_t>(matrix.size), size(),
                           [&](std::size_t i, auto add) { ends_[i].for_each_entry(add); }};
    slot_shares_ = Shares{static_cast<std::size_t>(matrix.nonzeros()), size(),
                          [&](std::size_t i, auto add) { slots_[i].for_each_slot(ends_[i], add); }};
  }

  void account(double step, WorkRule rule, std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      Account& account = accounts_[i];
      const double power = rate_independent ? 0.0 : laws_[i].dissipation_rate(trial_[i], deformations_[i], rates_[i]);
      if (step > 0.0) {
        if (rule == WorkRule::mean_force)
          add_by_mean_force(i, step, power);
        else
          add_by_quadrature(i, step, power);
        // Rate-independent laws know it from their states, also where they yield inside the step.
        if constexpr (rate_independent) account.dissipated += laws_[i].dissipated_energy(committed_[i], trial_[i]);
      }
      account.force = forces_[i];
      account.power = power;
    }
  }

  double stored(std::size_t i) const { return laws_[i].stored_energy(committed_[i], start_.deformations[i]); }

  // The work by the means of the step's ends, the dissipation by Simpson's rule.
  void add_by_mean_force(std::size_t i, double step, double end_power) {
    Account& account = accounts_[i];
    account.work += 0.5 * (account.force + forces_[i]) * (deformations_[i] - start_.deformations[i]);
    if constexpr (!rate_independent) {
      const HermiteCubic path{start_.deformations[i], start_.rates[i], deformations_[i], rates_[i], step};
      const double middle_power = laws_[i].dissipation_rate(committed_[i], path.value(0.5), path.rate(0.5));
      account.dissipated += step / 6.0 * (account.power + 4.0 * middle_power + end_power);
    }
  }

  // Both by Lobatto's rule with four points.
  void add_by_quadrature(std::size_t i, double step, double end_power) {
    constexpr double first_inside = 0.27639320225002103;  // (1 - 1/sqrt(5))/2
    Account& account = accounts_[i];
    const HermiteQuintic path = path_of(i, step);
    double work = account.force * start_.rates[i] + forces_[i] * rates_[i];
    double dissipated = account.power + end_power;
    for (const double x : {first_inside, 1.0 - first_inside}) {
      const double deformation = path.value(x), rate = path.rate(x);
      State after;
      work += 5.0 * laws_[i].evaluate(committed_[i], deformation, rate, after).force * rate;
      if constexpr (!rate_independent) dissipated += 5.0 * laws_[i].dissipation_rate(committed_[i], deformation, rate);
    }
    account.work += step / 12.0 * work;
    if constexpr (!rate_independent) account.dissipated += step / 12.0 * dissipated;
  }

  void scan_element(std::size_t i, double step, RegimeScan& scan) const requires LawWithRegimes<Law> {
    const double end_margin = laws_[i].regime_margin(committed_[i], deformations_[i], rates_[i]);
    scan.margin = std::min(scan.margin, end_margin);
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // Beyond the margin and back within the step: only where the deformation turns inside it.
      beyond = turning_point(i);
      if (beyond <= 0.0 || margin_inside(i, step, beyond) >= 0.0) return;
      scan.returned = true;
    }
    scan.crossed = true;
    ++scan.crossings;
    if (scan.fraction > 0.0) scan.fraction = std::min(scan.fraction, first_crossing(i, step, beyond, scan.aim));
  }

  // Fraction of the step at which the interpolated margin falls to `aim`, looked for between 0 and `beyond`. `beyond`
  // itself if it never falls that far.
  double first_crossing(std::size_t i, double step, double beyond, double aim) const {
    return first_fall([&](double x) { return margin_inside(i, step, x); }, beyond, aim);
  }

  // Where a function of 0 to `beyond` falls to `aim`, by regula falsi (Illinois); on the far side of it.
  template <class Function>
  static double first_fall(const Function& function, double beyond, double aim) {
    double low = 0.0, high = beyond;
    double above = function(low) - aim, below = function(high) - aim;
    if (below >= 0.0) return beyond;
    if (above <= 0.0) return 0.0;
    int side = 0;
    for (int count = 0; count < 60 && high - low > 1e-15; ++count) {
      const double x = low + (high - low) * above / (above - below);
      const double value = function(x) - aim;
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

  // Where the deformation is interpolated by the cubic through deformation and rate at both ends.
  double margin_inside(std::size_t i, double step, double x) const {
    const HermiteCubic path{start_.deformations[i], start_.rates[i], deformations_[i], rates_[i], step};
    return laws_[i].regime_margin(committed_[i], path.value(x), path.rate(x));
  }

  // Fraction at which the deformation turns inside the step, 0 if it does not. A linear rate is exact for
  // average acceleration and close enough for others to decide whether to look.
  double turning_point(std::size_t i) const {
    const double start = start_.rates[i], end = rates_[i];
    return start * end < 0.0 ? start / (start - end) : 0.0;
  }

  std::vector<ElementInfo> infos_;
  std::vector<Law> laws_;
  std::vector<double> effective_masses_, durations_;  // kg; s, of the contact going on. Empty for laws without contact
  std::vector<double> approach_speeds_;               // m/s, at the last touch; that of the law's state has a floor
  int touching_ = 0;                                  // number of contacts going on
  std::vector<Ends> ends_;
  std::vector<typename Ends::Slots> slots_;
  std::vector<double> offsets_;
  std::vector<State> committed_, trial_;
  std::vector<double> deformations_, rates_, second_rates_, forces_, force_rates_;
  std::vector<double> stiffnesses_, dampings_;  // empty for linear laws
  Flag tangent_changed_;
  std::vector<std::pair<std::size_t, State>> before_changes_inside_;  // of the step being tried
  Movement start_, before_;                                           // at the last commit, and at the one before
  std::vector<double> start_stiffnesses_;                             // of laws without regimes, at the last commit
  double last_step_ = 0.0;                                            // between them, s
  bool accounting_ = false;
  std::vector<Account> accounts_;
  int threads_ = 1;
  Shares entry_shares_, slot_shares_;  // with more than one thread
};

}  // namespace moat
