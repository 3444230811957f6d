// Elements with one law between two places.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <span>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "elements/line/ends.hpp"
#include "elements/line/link_arrays.hpp"
#include "elements/line/link_energies.hpp"
#include "elements/line/link_motion.hpp"
#include "elements/line/regime_search.hpp"
#include "materials/response.hpp"
#include "model/element_block.hpp"

namespace moat {

/// All elements of a model that put a law of type Law between two places, in contiguous arrays.
///
///     deformation d = u(second) - u(first) - offset;  the law's force pulls `second` back and `first` along.
///
/// A spring has its lower node first; a contact has its right node first and its clearance as offset, so that d is the
/// indentation and a positive force is compression. `Ends` is how the two places are attached: at nodes (NodePair) or
/// at points between nodes (PointPair).
///
/// This class serves laws that are smooth everywhere; LinksWithRegimes and ContactLinks add the rest. Take the type
/// from LinkBlock<Law> (elements/line/link_block.hpp).
template <ForceLaw Law, class Ends = NodePair>
class Links : public ElementBlock, public ElementLaws, protected LinkArrays {
 public:
  /// History of one element.
  using State = typename Law::State;

  /// Appends an element and returns its index.
  template <std::constructible_from<const ElementInfo&> AtNodes = Ends>
  std::size_t add(ElementInfo info, const Law& law) {
    const AtNodes ends{info};
    return add(std::move(info), law, ends);
  }
  /// As above, with ends that are not the nodes of `info`.
  std::size_t add(ElementInfo info, const Law& law, const Ends& ends) {
    ends_.push_back(ends);
    append(std::move(info));
    laws_.push_back(law);
    if (!forces_.empty()) resize_results();
    return infos_.size() - 1;
  }

  /// As it was added.
  [[nodiscard]] const Law& law(std::size_t element) const { return laws_[element]; }
  /// History at the committed state.
  [[nodiscard]] const State& committed(std::size_t element) const { return committed_[element]; }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<Links>(*this); }
  std::size_t size() const override { return ends_.size(); }
  const ElementInfo& info(std::size_t element) const override { return infos_[element]; }
  const ElementLaws* laws() const override { return this; }
  std::string law_name(std::size_t element) const override { return std::string{name_of(laws_[element])}; }
  std::vector<Parameter> parameters(std::size_t element) const override { return parameters_of(laws_[element]); }

  void add_couplings(Couplings& couplings) const override {
    for (std::size_t i = 0; i < size(); ++i) ends_[i].add_couplings(infos_[i], couplings);
  }

  void find_slots(const SparseMatrix& matrix) override {
    resize_results();
    for (std::size_t i = 0; i < size(); ++i) {
      ends_[i].find_entries(infos_[i], matrix);
      if constexpr (!is_linear) slots_[i].find(ends_[i], matrix);
    }
  }

  void evaluate(const double* displacement, const double* velocity, double* __restrict force) override {
    const Law* laws = laws_.data();
    const Ends* ends = ends_.data();
    const State* committed = committed_.data();
    const double* offsets = offsets_.empty() ? nullptr : offsets_.data();
    State* __restrict trial = trial_.data();
    double* __restrict deformations = now_.deformations.data();
    double* __restrict rates = now_.rates.data();
    double* __restrict forces = forces_.data();
    double* __restrict stiffnesses = stiffnesses_.data();
    double* __restrict dampings = dampings_.data();
    const std::size_t count = size();
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
      const double deformation = ends[i].difference(displacement) - (offsets == nullptr ? 0.0 : offsets[i]),
                   rate = ends[i].difference(velocity);
      Interval interval;
      if constexpr (TimeDependentLaw<Law>) interval = {step_, start_.deformations[i], start_.rates[i]};
      const Response response = respond(laws[i], committed[i], deformation, rate, interval, trial[i]);
      deformations[i] = deformation;
      rates[i] = rate;
      forces[i] = response.force;
      if constexpr (!is_linear) {
        changed |= (stiffnesses[i] != response.stiffness) | (dampings[i] != response.damping);
        stiffnesses[i] = response.stiffness;
        dampings[i] = response.damping;
      }
      if (force != nullptr) ends[i].add_force(response.force, force);
    }
    if (changed) tangent_changed_ = true;
  }

  void begin_step(double step) override { step_ = step; }

  void evaluate_rates(const double* acceleration, double* __restrict force_rate) override {
    const Ends* ends = ends_.data();
    const double* rates = now_.rates.data();
    double* __restrict second_rates = now_.second_rates.data();
    double* __restrict force_rates = force_rates_.data();
    const std::size_t count = size();
    for (std::size_t i = 0; i < count; ++i) {
      const Tangents tangents = tangents_of(i);
      const double second_rate = ends[i].difference(acceleration);
      double of_force;
      if constexpr (knows_force_rate)
        of_force = laws_[i].force_rate(trial_[i], now_.deformations[i], rates[i], second_rate);
      else
        of_force = tangents.stiffness * rates[i] + tangents.damping * second_rate;
      second_rates[i] = second_rate;
      force_rates[i] = of_force;
      if (force_rate != nullptr) ends[i].add_force(of_force, force_rate);
    }
  }

  void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const override {
    for (std::size_t i = 0; i < size(); ++i) {
      const Tangents tangents = tangents_of(i);
      add_stiffness(i, displacement_weight * tangents.stiffness + velocity_weight * tangents.damping, matrix);
    }
  }

  void add_linear_stiffness(StiffnessStage stage, SparseMatrix& matrix) const override {
    for (std::size_t i = 0; i < size(); ++i)
      add_stiffness(i, stage == StiffnessStage::joined ? 1.0 : laws_[i].linear_stiffness(stage), matrix);
  }

  bool constant_tangent() const override { return is_linear; }
  bool take_tangent_change() override { return std::exchange(tangent_changed_, false); }

  void find_corners(UnlocatedCorners& corners, double* lost) const override {
    if constexpr (has_unlocated_corners) {
      constexpr double jump = 0.2;
      for (std::size_t i = 0; i < start_stiffnesses_.size(); ++i) {
        corners.jump |= std::abs(stiffnesses_[i] - start_stiffnesses_[i]) >
                        jump * std::max(std::abs(stiffnesses_[i]), std::abs(start_stiffnesses_[i]));
        // A law that evolves in time follows the path itself.
        if constexpr (TimeDependentLaw<Law>) continue;
        const double turn = turning_point(start_.rates[i], now_.rates[i]);
        if (turn <= 0.0 || turn >= 1.0) continue;
        corners.turn = true;
        ends_[i].add_force(lost_by_turn(i, turn), lost);
      }
    }
  }

  bool linear_between_events() const override {
    if constexpr (requires(const Law& law) { law.is_linear_within_regimes(); })
      return std::ranges::all_of(laws_, &Law::is_linear_within_regimes);
    else
      return LinearWithinRegimes<Law>;
  }

  void commit(double step, WorkRule rule) override {
    if (energies_.kept()) energies_.add_step({laws_, committed_, trial_, start_, now_, forces_, step}, rule);
    if (keeps_start()) {
      if constexpr (!is_linear) before_.swap(start_);
      start_.copy(now_);
      if constexpr (has_unlocated_corners) keep_stiffnesses();
      last_step_ = step;
    }
    committed_.swap(trial_);
  }

  void start_energy_accounts() override {
    start_motion();
    energies_.start(laws_, committed_, now_, forces_);
  }

  ElementEnergy energy(std::size_t element) const override {
    if (!energies_.kept()) throw std::logic_error{"Links: energy() without start_energy_accounts()"};
    return energies_.energy(element, stored(element));
  }

  void add_energies(EnergySums& sums) const override {
    if constexpr (is_linear) {
      if (!energies_.kept()) throw std::logic_error{"Links: add_energies() without start_energy_accounts()"};
      for (std::size_t i = 0; i < size(); ++i) sums.add(false, energies_.energy(i, stored(i)));
    } else {
      ElementBlock::add_energies(sums);
    }
  }

  std::span<const ReportedQuantity> law_quantities(std::size_t i) const override { return quantities_of(laws_[i]); }
  ReportedValue law_quantity(std::size_t i, std::size_t quantity) const override {
    return law_quantity_at(i, quantity, committed_[i], now_.deformations[i], now_.rates[i], now_.second_rates[i]);
  }

  ElementResults results() const override { return {now_.deformations, now_.rates, forces_, force_rates_}; }

  double force_inside(std::size_t i, double fraction) const override {
    if (is_linear) throw std::logic_error{"Links: a linear element's force needs no law to interpolate"};
    const HermiteQuintic path = path_between(before_, start_, i, last_step_);
    State after;
    // commit() has left the states of the step's start in trial_.
    const Interval interval{fraction * last_step_, before_.deformations[i], before_.rates[i]};
    return respond(laws_[i], trial_[i], path.value(fraction), path.rate(fraction), interval, after).force;
  }

 protected:
  static constexpr bool is_linear = LawWithConstantTangents<Law>;  ///< Both tangents are constants.
  static constexpr bool has_unlocated_corners =
      !is_linear && !LawWithRegimes<Law>;  ///< Its force has corners inside steps, which nobody locates.

  /// Stored energy at the committed state, J.
  [[nodiscard]] double stored(std::size_t i) const {
    return laws_[i].stored_energy(committed_[i], start_.deformations[i]);
  }

  std::vector<Law> laws_;                    ///< one per element, like all arrays below; as added
  std::vector<Ends> ends_;                   ///< as added
  std::vector<typename Ends::Slots> slots_;  ///< positions in the tangent; empty for linear laws
  std::vector<State> committed_, trial_;     ///< histories at both states
  LinkEnergies<Law> energies_;               ///< their accounts

 private:
  // The force that the law loses where its path turns inside the trial step, N. It is the larger of two: the difference
  // at the end if the law is led to the turn first, and the distance of its force at the turn from its tangent.
  [[nodiscard]] double lost_by_turn(std::size_t i, double turn) const {
    const double farthest = cubic_between(start_, now_, i, step_).value(turn), rate = now_.rates[i];
    State at_turn, after;
    const double force = respond(laws_[i], committed_[i], farthest, rate, {}, at_turn).force,
                 at_end = respond(laws_[i], at_turn, now_.deformations[i], rate, {}, after).force - forces_[i],
                 from_tangent = force - forces_[i] - stiffnesses_[i] * (farthest - now_.deformations[i]);
    return std::abs(at_end) > std::abs(from_tangent) ? at_end : from_tangent;
  }

  struct Tangents {
    double stiffness, damping;
  };
  [[nodiscard]] Tangents tangents_of(std::size_t i) const {
    if constexpr (is_linear) {
      State trial;
      const Response response = respond(laws_[i], State{}, 0.0, 0.0, {}, trial);
      return {response.stiffness, response.damping};
    } else {
      return {stiffnesses_[i], dampings_[i]};
    }
  }

  // A linear law adds to matrices once: a search then costs less than the memory for its places.
  void add_stiffness(std::size_t i, double stiffness, SparseMatrix& matrix) const {
    if constexpr (is_linear) {
      if (stiffness == 0.0) return;
      typename Ends::Slots slots;
      slots.find(ends_[i], matrix);
      slots.add_stiffness(ends_[i], stiffness, matrix.valuePtr());
    } else {
      slots_[i].add_stiffness(ends_[i], stiffness, matrix.valuePtr());
    }
  }

  // Changes of regime, forces inside a step and energies need the motion at the last commit.
  [[nodiscard]] bool keeps_start() const { return !is_linear || energies_.kept(); }
  // At first once for all elements, so that nothing is larger than it must be.
  void resize_results() {
    const std::size_t count = size();
    resize({.tangents = !is_linear, .start = keeps_start(), .before = !is_linear});
    if constexpr (!is_linear) slots_.resize(count);
    committed_.resize(count);
    trial_.resize(count);
    energies_.resize(count);
  }

  [[nodiscard]] ReportedValue law_quantity_at([[maybe_unused]] std::size_t i, std::size_t quantity, const State& state,
                                              double deformation, double rate, double second_rate) const {
    if constexpr (requires(const Law& law) { law.quantity(quantity, state, deformation, rate, second_rate); })
      return laws_[i].quantity(quantity, state, deformation, rate, second_rate);
    else
      throw std::logic_error{"Links: a law without quantities was asked for one"};
  }

  static constexpr bool knows_force_rate = requires(const Law& law, const State& state, double x) {
    law.force_rate(state, x, x, x);
  };

  bool tangent_changed_ = false;
};

}  // namespace moat
