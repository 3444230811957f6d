// The states of elements with one law between two places.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "elements/block/contact_log.hpp"
#include "elements/block/corner_grips.hpp"
#include "elements/block/link_energies.hpp"
#include "elements/block/link_step.hpp"
#include "model/element_block.hpp"

namespace moat {

/// The states of a LinkBlock of this law and these ends: their motion, forces and accounts.
template <class Block, class Law, class Ends>
class LinkStates final : public ElementStates {
  using State = typename Law::State;
  using Vector = VectorOf<Law>;
  using Answer = ResponseOf<Law>;
  static constexpr bool in_plan = PlanarLaw<Law>;
  static constexpr bool has_regimes = !in_plan && LawWithRegimes<Law>;
  static constexpr bool is_contact = !in_plan && ContactLaw<Law>;
  static constexpr bool is_corner = std::is_same_v<Ends, CornerAndEdge>;
  static constexpr bool takes_axial_force = LinkStep<Law>::takes_axial_force;
  // Energies alone need the motion at the last commit of such a law, and nobody the one before.
  static constexpr bool has_constant_tangents = !in_plan && LawWithConstantTangents<Law>;
  // Forces of such a law have corners inside steps, which nobody locates.
  static constexpr bool has_unlocated_corners = in_plan || !(has_constant_tangents || LawWithRegimes<Law>);

 public:
  /// Makes the states of all links at rest.
  LinkStates(const Block& block, const SparseMatrix& matrix) : block_{&block}, ends_{block.ends()} {
    const std::size_t count = block.size();
    for (Ends& ends : ends_) {
      slots_.emplace_back(ends, matrix);
      ends.put_ground_at(static_cast<int>(matrix.cols()));
    }
    if constexpr (!in_plan)
      for (const ElementInfo& info : block.infos()) offsets_.push_back(info.offset);
    for (std::vector<State>* states : {&committed_, &trial_}) states->resize(count);
    for (LinkMotion<Vector>* motion : {&now_, &start_, &before_}) motion->resize(count);
    answers_.resize(count);
    for (std::vector<Vector>* values : {&forces_, &force_rates_}) values->resize(count, Vector{});
    if constexpr (has_unlocated_corners) start_answers_.resize(count);
    if constexpr (takes_axial_force)
      for (LinkCompressions* each : {&compressions_, &start_compressions_, &before_compressions_}) each->resize(count);
    if constexpr (is_contact) contacts_ = ContactLog{count};
    if constexpr (is_corner) grips_ = CornerGrips{block.ends()};
  }

  std::unique_ptr<ElementStates> clone() const override { return std::make_unique<LinkStates>(*this); }

  bool evaluate(double step, const double* displacement, const double* velocity, double* __restrict force) override {
    step_ = step;
    // Pointers, because the compiler cannot know that stores of results do not change the vectors.
    const Law* laws = block_->laws().data();
    const Ends* ends = ends_.data();
    const State* committed = committed_.data();
    const double* offsets = offsets_.data();
    const Vector *start_deformations = start_.deformations.data(), *start_rates = start_.rates.data();
    State* __restrict trial = trial_.data();
    Answer* __restrict answers = answers_.data();
    Vector* __restrict deformations = now_.deformations.data(), * __restrict rates = now_.rates.data();
    Vector* __restrict forces = forces_.data();
    const std::size_t count = ends_.size();
    const LinkStep<Law> trial_end = trial_step(step);
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
      Vector deformation = ends[i].difference(displacement);
      if constexpr (!in_plan) deformation -= offsets[i];
      const Vector rate = ends[i].difference(velocity);
      const Answer answer =
          respond_over(laws[i], committed[i], {deformation, rate}, {start_deformations[i], start_rates[i]}, step,
                       trial_end.axial_at_end(i), trial[i]);
      changed |= answer.stiffness != answers[i].stiffness || answer.damping != answers[i].damping;
      keep<Law>(answer, answers[i]);
      deformations[i] = deformation;
      rates[i] = rate;
      forces[i] = answer.force;
      if (force != nullptr) ends[i].add_force(answer.force, force);
    }
    if constexpr (is_corner)
      changed |= grips_.evaluate(step, displacement, velocity, forces_, contacts_, now_, force,
                                 [&](std::size_t i, double d) { return respond_at_rest(laws[i], committed[i], d); });
    return changed;
  }

  void evaluate_rates(const double* acceleration, double* __restrict force_rate) override {
    const Ends* ends = ends_.data();
    Vector* __restrict second_rates = now_.second_rates.data();
    Vector* __restrict force_rates = force_rates_.data();
    const std::size_t count = ends_.size();
    const LinkStep<Law> trial_end = trial_step(step_);
    for (std::size_t i = 0; i < count; ++i) {
      second_rates[i] = ends[i].difference(acceleration);
      force_rates[i] = rate_of_force(block_->laws()[i], trial_[i], answers_[i], {now_.deformations[i], now_.rates[i]},
                                     second_rates[i], trial_end.compression_rate_at_end(i));
      if (force_rate != nullptr) ends[i].add_force(force_rates[i], force_rate);
    }
    if constexpr (is_corner) grips_.evaluate_rates(acceleration, force_rates_, force_rate);
  }

  void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const override {
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const auto stiffness = displacement_weight * answers_[i].stiffness + velocity_weight * answers_[i].damping;
      if constexpr (is_corner)
        slots_[i].both.add_stiffness(ends_[i].ends, grips_.tangent(i, stiffness, displacement_weight),
                                     matrix.valuePtr());
      else
        slots_[i].add_stiffness(ends_[i], stiffness, matrix.valuePtr());
    }
  }

  void find_corners([[maybe_unused]] UnlocatedCorners& corners, [[maybe_unused]] double* lost) const override {
    if constexpr (is_corner) corners.jump |= grips_.begin_to_slide();
    if constexpr (has_unlocated_corners) {
      constexpr double jump = 0.2;
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        const auto &before = start_answers_[i].stiffness, &after = answers_[i].stiffness;
        corners.jump |= norm(after + -1.0 * before) > jump * std::max(norm(before), norm(after));
        // A law that evolves in time follows the path itself.
        if constexpr (!in_plan && (TimeDependentLaw<Law> || takes_axial_force)) continue;
        const double turn = turning_point(start_.rates[i], now_.rates[i]);
        if (turn <= 0.0 || turn >= 1.0) continue;
        corners.turn = true;
        ends_[i].add_force(trial_step(step_).lost_by_turn(i, turn, answers_[i].stiffness), lost);
      }
    }
  }

  AxialActions axial_actions() override { return {compressions_.values, compressions_.rates}; }

  void add_force_by_compression([[maybe_unused]] std::size_t i, [[maybe_unused]] double change,
                                [[maybe_unused]] double* force) const override {
    if constexpr (takes_axial_force) ends_[i].add_force(change * answers_[i].by_compression, force);
  }

  void commit(double step, WorkRule rule) override {
    if constexpr (is_corner) grips_.commit(step, rule, energies_.kept(), contacts_);
    if (energies_.kept()) energies_.add_step(trial_step(step), rule);
    if constexpr (!has_constant_tangents) std::swap(before_, start_);
    if (!has_constant_tangents || energies_.kept()) start_ = now_;
    if constexpr (has_unlocated_corners) start_answers_ = answers_;
    if constexpr (takes_axial_force) {
      std::swap(before_compressions_, start_compressions_);
      start_compressions_ = compressions_;
    }
    last_step_ = step;
    committed_.swap(trial_);
  }

  void start_energy_accounts() override {
    start_ = now_;
    energies_.start(block_->laws(), committed_, now_, forces_);
    if constexpr (is_corner) grips_.start_energy_accounts();
  }

  ElementEnergy energy(std::size_t i) const override {
    if (!energies_.kept()) throw std::logic_error{"LinkStates: energy() without start_energy_accounts()"};
    ElementEnergy energy = energies_.energy(i, stored(i));
    if constexpr (is_corner) grips_.add_energy(i, energy);
    return energy;
  }

  ElementResults results() const override {
    if constexpr (in_plan)
      return {.plan = {now_.deformations, now_.rates, forces_, force_rates_}};
    else
      return {.line = {now_.deformations, now_.rates, forces_, force_rates_}};
  }

  ReportedValue law_quantity([[maybe_unused]] std::size_t i, [[maybe_unused]] std::size_t quantity) const override {
    if constexpr (requires(const Law& law, const State& state, Vector x) { law.quantity(quantity, state, x, x, x); })
      return block_->laws()[i].quantity(quantity, committed_[i], now_.deformations[i], now_.rates[i],
                                        now_.second_rates[i]);
    else
      throw std::logic_error{"LinkStates: a law without quantities was asked for one"};
  }

  double force_inside(std::size_t i, double fraction) const override {
    // commit() has left the states of the step's start in trial_, and its motion in before_.
    const LinkStep<Law> last{block_->laws(),      trial_,  committed_, before_, start_, before_compressions_,
                             start_compressions_, forces_, last_step_};
    const auto path = path_between(before_, start_, i, last_step_);
    State after;
    return value_or_length(last.respond(i, fraction, {path.value(fraction), path.rate(fraction)}, after).force);
  }

  void scan([[maybe_unused]] double step, [[maybe_unused]] double aim,
            [[maybe_unused]] RegimeScan& scan) const override {
    if constexpr (has_regimes)
      for (std::size_t i = 0; i < ends_.size(); ++i) trial_step(step).scan(i, aim, scan);
    if constexpr (is_corner) grips_.scan(aim, contacts_, scan);
  }

  double next_fall([[maybe_unused]] double aim) const override {
    double first = std::numeric_limits<double>::infinity();
    if constexpr (has_regimes)
      for (std::size_t i = 0; i < ends_.size(); ++i) first = std::min(first, trial_step(step_).next_fall(i, aim));
    if constexpr (is_corner) first = std::min(first, grips_.next_fall(aim, contacts_));
    return first;
  }

  void change([[maybe_unused]] std::size_t block_index, [[maybe_unused]] std::vector<RegimeChange>& changes) override {
    if constexpr (is_corner)
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        if (!grips_.leaves_edge(i, contacts_)) continue;
        changes.push_back({.block = block_index, .element = i, .rate = start_.rates[i]});
        enter(i, {}, changes.back());
        grips_.leave_edge(i, start_);
      }
    if constexpr (has_regimes) {
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        const double deformation = start_.deformations[i], rate = start_.rates[i];
        // One change may be followed at once by another: a touch that already separates. Three cover every phase.
        const Law& law = block_->laws()[i];
        for (int count = 0;
             count < 3 && LinkStep<Law>::margin_at(law, committed_[i], committed_[i], deformation, rate) < 0.0;
             ++count) {
          if (count == 0) changes.push_back({.block = block_index, .element = i, .rate = rate});
          enter(i, law.next_regime(committed_[i], deformation, rate), changes.back());
        }
      }
    }
  }

  ContactView contact([[maybe_unused]] std::size_t i) const override {
    ContactView view;
    if constexpr (is_contact) {
      view = contacts_.view(i, block_->effective_mass(i), committed_[i].approach_speed);
      view.distance = -now_.deformations[i];
      view.distance_rate = -now_.rates[i];
    }
    if constexpr (is_corner) grips_.complete(i, view);
    return view;
  }

  double shortest_contact() const override {
    double shortest = std::numeric_limits<double>::infinity();
    if constexpr (is_contact) shortest = contacts_.shortest();
    if constexpr (is_corner) shortest = std::min(shortest, grips_.shortest_contact(contacts_));
    return shortest;
  }
  void archive(StateArchive& archive) override {
    archive(committed_, trial_, now_, start_, before_, answers_, start_answers_, forces_, force_rates_, compressions_,
            start_compressions_, before_compressions_, energies_, contacts_, grips_, step_, last_step_);
  }

 private:
  [[nodiscard]] LinkStep<Law> trial_step(double length) const {
    return {block_->laws(), committed_, trial_, start_, now_, start_compressions_, compressions_, forces_, length};
  }
  // At the committed state, J.
  [[nodiscard]] double stored(std::size_t i) const {
    return block_->laws()[i].stored_energy(committed_[i], start_.deformations[i]);
  }
  // Puts a link into a regime at the committed state.
  void enter(std::size_t i, const State& next, [[maybe_unused]] RegimeChange& change) {
    const double stored_before = stored(i);
    committed_[i] = next;
    if constexpr (is_contact) {
      const double mass = block_->effective_mass(i);
      if (contacts_.enter(i, next.phase, change)) {
        // A gap that is closed at the start has no approach; its law uses the speed of an elastic impact of this depth.
        if (const double speed = std::sqrt(2.0 * stored(i) / mass); speed > next.approach_speed)
          committed_[i] = block_->laws()[i].next_regime({}, start_.deformations[i], speed);
        if constexpr (is_corner) grips_.touch(i);
      }
      if (contacts_.touching(i))
        contacts_.set_duration(i, block_->laws()[i].contact_duration(mass, committed_[i].approach_speed));
    }
    // A contact that ends while still indented gives up the energy it had stored.
    energies_.release(i, stored_before - stored(i));
  }

  const Block* block_;
  std::vector<Ends> ends_;
  std::vector<typename Ends::Slots> slots_;
  std::vector<double> offsets_;  // m, of deformations with one component
  std::vector<State> committed_, trial_;
  // At the last evaluate(), at the last commit, and at the one before.
  LinkMotion<Vector> now_, start_, before_;
  LinkCompressions compressions_, start_compressions_, before_compressions_;
  std::vector<Answer> answers_, start_answers_;  // of the last evaluate(), and of laws with corners at the last commit
  std::vector<Vector> forces_, force_rates_;     // of the last evaluate(), N, N/s
  LinkEnergies<Law> energies_;
  std::conditional_t<is_contact, ContactLog, std::monostate> contacts_;
  std::conditional_t<is_corner, CornerGrips, std::monostate> grips_;
  double step_ = 0.0, last_step_ = 0.0;  // s
};

}  // namespace moat
