// The states of elements with one law between two places.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <memory>
#include <span>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "elements/block/contact_log.hpp"
#include "elements/block/corner_grips.hpp"
#include "elements/block/law_response.hpp"
#include "elements/block/link_energies.hpp"
#include "elements/block/link_motion.hpp"
#include "elements/block/regime_search.hpp"
#include "model/element_block.hpp"

namespace moat {

/// A member that a block does not need.
struct Nothing {};

/// The states of a LinkBlock of this law and these ends.
///
/// Whether a margin of a law with regimes is crossed inside a step is judged on the cubic through deformation and rate
/// at both ends, and where on the quintic through both rates.
template <class Block, class Law, class Ends>
class LinkStates final : public ElementStates {
  using State = typename Law::State;
  using Vector = VectorOf<Law>;
  using Answer = ResponseOf<Law>;
  static constexpr bool in_plan = PlanarLaw<Law>;
  static constexpr bool has_regimes = !in_plan && LawWithRegimes<Law>;
  static constexpr bool is_contact = !in_plan && ContactLaw<Law>;
  static constexpr bool is_corner = std::is_same_v<Ends, CornerAndEdge>;
  static constexpr bool takes_axial_force = AxialForceLaw<Law> || PlanarAxialForceLaw<Law>;
  // Energies alone need the motion at the last commit of such a law, and nobody the one before.
  static constexpr bool has_constant_tangents = !in_plan && LawWithConstantTangents<Law>;
  // Its force has corners inside steps, which nobody locates.
  static constexpr bool has_unlocated_corners = in_plan || !(has_constant_tangents || LawWithRegimes<Law>);

 public:
  LinkStates(const Block& block, const SparseMatrix& matrix) : block_{&block}, ends_{block.ends()} {
    const std::size_t count = block.size();
    for (Ends& ends : ends_) {
      slots_.emplace_back(ends, matrix);
      ends.put_ground_at(static_cast<int>(matrix.cols()));
    }
    if constexpr (!in_plan)
      for (const ElementInfo& info : block.infos()) offsets_.push_back(info.offset);
    committed_.resize(count);
    trial_.resize(count);
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
    Vector* __restrict deformations = now_.deformations.data();
    Vector* __restrict rates = now_.rates.data();
    Vector* __restrict forces = forces_.data();
    const std::size_t count = ends_.size();
    bool changed = false;
    for (std::size_t i = 0; i < count; ++i) {
      Vector deformation = ends[i].difference(displacement);
      if constexpr (!in_plan) deformation -= offsets[i];
      const Vector rate = ends[i].difference(velocity);
      const Answer answer = respond_over(laws[i], committed[i], {deformation, rate},
                                         {start_deformations[i], start_rates[i]}, step, axial_force(i), trial[i]);
      changed |= answer.stiffness != answers[i].stiffness || answer.damping != answers[i].damping;
      keep(answer, answers[i]);
      deformations[i] = deformation;
      rates[i] = rate;
      forces[i] = answer.force;
      if (force != nullptr) ends[i].add_force(answer.force, force);
    }
    if constexpr (is_corner) changed |= grips_.evaluate(step, displacement, velocity, forces_, contacts_, now_, force);
    return changed;
  }

  void evaluate_rates(const double* acceleration, double* __restrict force_rate) override {
    const Ends* ends = ends_.data();
    Vector* __restrict second_rates = now_.second_rates.data();
    Vector* __restrict force_rates = force_rates_.data();
    const std::size_t count = ends_.size();
    for (std::size_t i = 0; i < count; ++i) {
      second_rates[i] = ends[i].difference(acceleration);
      force_rates[i] = rate_of_force(i, second_rates[i]);
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
        ends_[i].add_force(lost_by_turn(i, turn), lost);
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
    if (energies_.kept())
      energies_.add_step(
          {block_->laws(), committed_, trial_, start_, now_, start_compressions_, compressions_, forces_, step}, rule);
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
    if constexpr (requires(const Law& law, const State& state, double x) { law.quantity(quantity, state, x, x, x); })
      return block_->laws()[i].quantity(quantity, committed_[i], now_.deformations[i], now_.rates[i],
                                        now_.second_rates[i]);
    else
      throw std::logic_error{"LinkStates: a law without quantities was asked for one"};
  }

  double force_inside(std::size_t i, double fraction) const override {
    // commit() has left the states of the step's start in trial_, and its motion in before_.
    const auto path = path_between(before_, start_, i, last_step_);
    State after;
    return norm_or_value(respond_over(block_->laws()[i], trial_[i], {path.value(fraction), path.rate(fraction)},
                                      {before_.deformations[i], before_.rates[i]}, fraction * last_step_,
                                      axial_inside(before_compressions_, start_compressions_, i, fraction, last_step_),
                                      after)
                             .force);
  }

  void scan([[maybe_unused]] double step, [[maybe_unused]] double aim,
            [[maybe_unused]] RegimeScan& scan) const override {
    if constexpr (has_regimes)
      for (std::size_t i = 0; i < ends_.size(); ++i) scan_link(i, step, aim, scan);
    if constexpr (is_corner) grips_.scan(aim, contacts_, scan);
  }

  double next_fall([[maybe_unused]] double aim) const override {
    double first = std::numeric_limits<double>::infinity();
    if constexpr (has_regimes) {
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        const double deformation = now_.deformations[i], rate = now_.rates[i], second_rate = now_.second_rates[i];
        // The state at that time, of laws that hold their compression in it.
        State state = takes_axial_force ? trial_[i] : committed_[i];
        const auto margin_above_aim = [&](double time) {
          if constexpr (takes_axial_force) state.compression = compressions_.values[i] + time * compressions_.rates[i];
          return margin_at(block_->laws()[i], committed_[i], state,
                           deformation + time * (rate + 0.5 * time * second_rate), rate + time * second_rate) -
                 aim;
        };
        first = std::min(first, fall_near(margin_above_aim));
      }
    }
    if constexpr (is_corner) first = std::min(first, grips_.next_fall(aim, contacts_));
    return first;
  }

  void change([[maybe_unused]] std::size_t block_index, [[maybe_unused]] std::vector<RegimeChange>& changes) override {
    if constexpr (is_corner) {
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        if (!grips_.leaves_edge(i, contacts_)) continue;
        changes.push_back({.block = block_index, .element = i, .rate = start_.rates[i]});
        enter(i, {}, changes.back());
        grips_.leave_edge(i, start_);
      }
    }
    if constexpr (has_regimes) {
      for (std::size_t i = 0; i < ends_.size(); ++i) {
        const double deformation = start_.deformations[i], rate = start_.rates[i];
        // One change may be followed at once by another (a touch that is already separating). Three changes cover every
        // phase.
        const Law& law = block_->laws()[i];
        for (int count = 0; count < 3 && margin_at(law, committed_[i], committed_[i], deformation, rate) < 0.0;
             ++count) {
          if (count == 0) changes.push_back({.block = block_index, .element = i, .rate = rate});
          enter(i, law.next_regime(committed_[i], deformation, rate), changes.back());
        }
      }
    }
  }

  ContactView contact([[maybe_unused]] std::size_t i) const override {
    if constexpr (is_contact) {
      ContactView view = contacts_.view(i, block_->effective_mass(i), committed_[i].approach_speed);
      view.distance = -now_.deformations[i];
      view.distance_rate = -now_.rates[i];
      if constexpr (is_corner) grips_.complete(i, view);
      return view;
    } else {
      return {};
    }
  }

  double shortest_contact() const override {
    double shortest = std::numeric_limits<double>::infinity();
    if constexpr (is_contact) shortest = contacts_.shortest();
    if constexpr (is_corner) shortest = std::min(shortest, grips_.shortest_contact(contacts_));
    return shortest;
  }

 private:
  // At the end of the trial step.
  [[nodiscard]] AxialForce axial_force([[maybe_unused]] std::size_t i) const {
    if constexpr (takes_axial_force)
      return {compressions_.values[i], start_compressions_.rates[i]};
    else
      return {};
  }
  // At a fraction of a step of `length` s.
  [[nodiscard]] static AxialForce axial_inside([[maybe_unused]] const LinkCompressions& start,
                                               [[maybe_unused]] const LinkCompressions& end,
                                               [[maybe_unused]] std::size_t i, [[maybe_unused]] double fraction,
                                               [[maybe_unused]] double length) {
    if constexpr (takes_axial_force)
      return {compression_between(start, end, i, length).value(fraction), start.rates[i]};
    else
      return {};
  }
  // At the committed state, J.
  [[nodiscard]] double stored(std::size_t i) const {
    return block_->laws()[i].stored_energy(committed_[i], start_.deformations[i]);
  }
  // Number by number: a copy of the whole from memory that was just written so stalls.
  static void keep(const Response& answer, Response& kept) {
    kept.force = answer.force;
    kept.stiffness = answer.stiffness;
    kept.damping = answer.damping;
    if constexpr (takes_axial_force) kept.by_compression = answer.by_compression;
  }
  template <std::derived_from<PlanarResponse> Any>
  static void keep(const Any& answer, Any& kept) {
    kept = answer;
  }
  static double norm(double value) { return std::abs(value); }
  static double norm(PlanMatrix a) { return std::sqrt(a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy); }
  static double norm_or_value(double value) { return value; }
  static double norm_or_value(PlanVector vector) { return length(vector); }

  [[nodiscard]] Vector rate_of_force(std::size_t i, Vector second_rate) const {
    const Answer& answer = answers_[i];
    if constexpr (in_plan && takes_axial_force)
      return answer.force_rate + answer.viscosity * second_rate + compressions_.rates[i] * answer.rate_by_compression;
    else if constexpr (in_plan)
      return answer.force_rate + answer.viscosity * second_rate;
    else if constexpr (takes_axial_force &&
                       requires(const Law& law, double x) { law.force_rate(trial_[i], x, x, x, x); })
      return block_->laws()[i].force_rate(trial_[i], now_.deformations[i], now_.rates[i], second_rate,
                                          compressions_.rates[i]);
    else if constexpr (requires(const Law& law, double x) { law.force_rate(trial_[i], x, x, x); })
      return block_->laws()[i].force_rate(trial_[i], now_.deformations[i], now_.rates[i], second_rate);
    else
      return answer.stiffness * now_.rates[i] + answer.damping * second_rate +
             (takes_axial_force ? answer.by_compression * compressions_.rates[i] : 0.0);
  }

  // The force that the law loses where its path turns inside the trial step, N: the difference at the end if the law is
  // led to the turn first. With one component it is the larger of that and the distance of its force at the turn from
  // its tangent.
  [[nodiscard]] Vector lost_by_turn(std::size_t i, double turn) const {
    const Law& law = block_->laws()[i];
    const DeformationAndRate<Vector> end{now_.deformations[i], now_.rates[i]};
    State at_turn, after;
    if constexpr (in_plan) {
      const PlanPath path = path_between(start_, now_, i, step_);
      const AxialForce axial_at_turn = axial_inside(start_compressions_, compressions_, i, turn, step_);
      respond_over(law, committed_[i], {path.value(turn), path.rate(turn)}, {}, turn * step_, axial_at_turn, at_turn);
      return respond_over(law, at_turn, end, {}, (1.0 - turn) * step_, axial_force(i), after).force - forces_[i];
    } else {
      const double farthest = cubic_between(start_, now_, i, step_).value(turn);
      const double force = respond_over(law, committed_[i], {farthest, end.rate}, {}, 0.0, {}, at_turn).force,
                   at_end = respond_over(law, at_turn, end, {}, 0.0, {}, after).force - forces_[i],
                   from_tangent = force - forces_[i] - answers_[i].stiffness * (farthest - end.deformation);
      return std::abs(at_end) > std::abs(from_tangent) ? at_end : from_tangent;
    }
  }

  // The margin inside a trial step of this length. That of a law under an axial force is of its state there.
  [[nodiscard]] double margin(std::size_t i, double fraction, [[maybe_unused]] double step, double deformation,
                              double rate) const {
    const Law& law = block_->laws()[i];
    if constexpr (takes_axial_force) {
      if (fraction == 1.0) return margin_at(law, committed_[i], trial_[i], deformation, rate);
      State there;
      respond_over(law, committed_[i], {deformation, rate}, {start_.deformations[i], start_.rates[i]}, fraction * step,
                   axial_inside(start_compressions_, compressions_, i, fraction, step), there);
      return margin_at(law, committed_[i], there, deformation, rate);
    } else {
      return law.regime_margin(committed_[i], deformation, rate);
    }
  }
  // The margin of a law at an instant, from the committed state and the state there.
  [[nodiscard]] static double margin_at(const Law& law, const State& committed, [[maybe_unused]] const State& there,
                                        double deformation, double rate) {
    if constexpr (MarginUnderAxialForce<Law>)
      return law.regime_margin(committed, deformation, rate, AxialForce{there.compression});
    else if constexpr (takes_axial_force)
      return law.regime_margin(there, deformation, rate);
    else
      return law.regime_margin(committed, deformation, rate);
  }

  void scan_link(std::size_t i, double step, double aim, RegimeScan& scan) const {
    const double end_margin = margin(i, 1.0, step, now_.deformations[i], now_.rates[i]);
    if (end_margin < scan.margin) {
      scan.margin = end_margin;
      scan.nearest = i;
    }
    double beyond = 1.0;
    if (end_margin >= 0.0) {
      // A crossing that returns within the step is possible only where the deformation turns inside it.
      beyond = turning_point(start_.rates[i], now_.rates[i]);
      const HermiteCubic path = cubic_between(start_, now_, i, step);
      if (beyond <= 0.0 || margin(i, beyond, step, path.value(beyond), path.rate(beyond)) >= 0.0) return;
      scan.crossed_back = true;
    }
    scan.crossed = true;
    // The step ends in the band that locate_change() aims at: to look for the instant would be in vain.
    if (end_margin >= 2.0 * aim && !scan.crossed_back) return;
    if (scan.fraction <= 0.0) return;
    const HermiteQuintic path = path_between(start_, now_, i, step);
    const auto margin_inside = [&](double fraction) {
      return margin(i, fraction, step, path.value(fraction), path.rate(fraction));
    };
    scan.fraction = std::min(scan.fraction, first_fall(margin_inside, beyond, aim));
  }

  // Puts a link into a regime at the committed state.
  void enter(std::size_t i, const State& next, [[maybe_unused]] RegimeChange& change) {
    const double stored_before = stored(i);
    committed_[i] = next;
    if constexpr (is_contact) {
      const double mass = block_->effective_mass(i);
      if (contacts_.enter(i, next.phase, change)) {
        // A gap that is closed at the start has no approach. Its law uses the speed of an elastic impact that reaches
        // this depth. At a located touch the depth is so small that this speed is negligible.
        committed_[i].approach_speed = std::max(next.approach_speed, std::sqrt(2.0 * stored(i) / mass));
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
  LinkMotion<Vector> now_, start_, before_;      // at the last evaluate(), at the last commit, and at the one before
  std::vector<Answer> answers_, start_answers_;  // of the last evaluate(), and of laws with corners at the last commit
  std::vector<Vector> forces_, force_rates_;     // of the last evaluate(), N, N/s
  // At the last evaluate(), at the last commit, and at the one before.
  LinkCompressions compressions_, start_compressions_, before_compressions_;
  LinkEnergies<Law> energies_;
  std::conditional_t<is_contact, ContactLog, Nothing> contacts_;
  std::conditional_t<is_corner, CornerGrips, Nothing> grips_;
  double step_ = 0.0, last_step_ = 0.0;  // s
};

}  // namespace moat
