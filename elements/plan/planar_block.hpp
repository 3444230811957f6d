// Elements with a law of two components between two points in plan.
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "base/hermite.hpp"
#include "elements/plan/plan_ends.hpp"
#include "materials/plan/planar_response.hpp"
#include "materials/response.hpp"
#include "model/element_block.hpp"

namespace moat {

/// All elements of a model that put a law of two components of type Law between two points in plan.
///
///     deformation d = u(second) - u(first), in x and y;  the law's force pulls `second` back and `first` along.
///
/// Deformations and forces of results() are the resultants |d| and |F|; planar() has the components. Corners of the
/// force are not located; find_corners() shows them.
template <PlanarLaw Law>
class PlanarBlock final : public ElementBlock, public ElementLaws, public PlanarElements {
 public:
  /// History of one element.
  using State = typename Law::State;

  /// Appends an element and returns its index.
  std::size_t add(ElementInfo info, const Law& law, const PlanEndsBothWays& ends, PlanVector position) {
    positions_.push_back(position);
    infos_.push_back(std::move(info));
    laws_.push_back(law);
    ends_.push_back(ends);
    const std::size_t count = infos_.size();
    committed_.resize(count);
    trial_.resize(count);
    responses_.resize(count);
    start_responses_.resize(count);
    now_.resize(count);
    start_.resize(count);
    before_.resize(count);
    force_rate_.resize(count);
    for (auto* values : {&deformations_, &rates_, &forces_, &force_rates_}) values->resize(count, 0.0);
    if (keeps_accounts_) accounts_.resize(count);
    return count - 1;
  }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<PlanarBlock>(*this); }
  std::size_t size() const override { return infos_.size(); }
  const ElementInfo& info(std::size_t element) const override { return infos_[element]; }
  const ElementLaws* laws() const override { return this; }
  std::string law_name(std::size_t element) const override { return std::string{name_of(laws_[element])}; }
  std::vector<Parameter> parameters(std::size_t element) const override { return parameters_of(laws_[element]); }
  const PlanarElements* planar() const override { return this; }

  void add_couplings(Couplings& couplings) const override {
    for (const PlanEndsBothWays& ends : ends_) ends.add_couplings(couplings);
  }
  void find_slots(const SparseMatrix& matrix) override {
    for (std::size_t i = 0; i < size(); ++i) ends_[i].find(infos_[i], matrix);
  }

  void begin_step(double step) override { step_ = step; }
  void evaluate(const double* displacement, const double* velocity, double* force) override {
    for (std::size_t i = 0; i < size(); ++i) {
      Motion& now = now_[i];
      now.deformation = ends_[i].difference(displacement);
      now.rate = ends_[i].difference(velocity);
      const PlanarResponse response = laws_[i].evaluate(committed_[i], now.deformation, now.rate, step_, trial_[i]);
      tangent_changed_ |= response.stiffness != responses_[i].stiffness || response.damping != responses_[i].damping;
      responses_[i] = response;
      deformations_[i] = size_of(now.deformation);
      rates_[i] = rate_of_size(now.deformation, now.rate, deformations_[i]);
      forces_[i] = size_of(response.force);
      if (force != nullptr) ends_[i].add_force(response.force, force);
    }
  }

  void evaluate_rates(const double* acceleration, double* force_rate) override {
    for (std::size_t i = 0; i < size(); ++i) {
      Motion& now = now_[i];
      now.second_rate = ends_[i].difference(acceleration);
      force_rate_[i] = responses_[i].force_rate + responses_[i].viscosity * now.second_rate;
      force_rates_[i] = rate_of_size(responses_[i].force, force_rate_[i], forces_[i]);
      if (force_rate != nullptr) ends_[i].add_force(force_rate_[i], force_rate);
    }
  }

  void add_tangent(double displacement_weight, double velocity_weight, SparseMatrix& matrix) const override {
    for (std::size_t i = 0; i < size(); ++i)
      ends_[i].add_stiffness(displacement_weight * responses_[i].stiffness + velocity_weight * responses_[i].damping,
                             matrix.valuePtr());
  }
  void add_linear_stiffness(StiffnessStage stage, SparseMatrix& matrix) const override {
    for (std::size_t i = 0; i < size(); ++i)
      ends_[i].add_stiffness(
          PlanMatrix::diagonal(stage == StiffnessStage::joined ? 1.0 : laws_[i].linear_stiffness(stage)),
          matrix.valuePtr());
  }

  bool take_tangent_change() override { return std::exchange(tangent_changed_, false); }

  void find_corners(UnlocatedCorners& corners, double* lost) const override {
    constexpr double jump = 0.2;
    for (std::size_t i = 0; i < size(); ++i) {
      const PlanMatrix &before = start_responses_[i].stiffness, &after = responses_[i].stiffness;
      corners.jump |= size_of(after + -1.0 * before) > jump * std::max(size_of(before), size_of(after));
      // The path turns where it is slowest.
      const PlanVector start = start_[i].rate, change = now_[i].rate - start;
      const double turn = -dot(start, change) / dot(change, change);
      if (!(turn > 0.0 && turn < 1.0)) continue;
      corners.turn = true;
      const Path path{start_[i], now_[i], step_};
      State at_turn, at_end;
      laws_[i].evaluate(committed_[i], path.value(turn), path.rate(turn), turn * step_, at_turn);
      const PlanVector led_to_turn =
          laws_[i].evaluate(at_turn, now_[i].deformation, now_[i].rate, (1.0 - turn) * step_, at_end).force;
      ends_[i].add_force(led_to_turn - responses_[i].force, lost);
    }
  }

  void commit(double step, WorkRule rule) override {
    if (keeps_accounts_)
      for (std::size_t i = 0; i < size(); ++i) add_step(i, step, rule);
    before_.swap(start_);
    start_ = now_;
    start_responses_ = responses_;
    committed_.swap(trial_);
    last_step_ = step;
  }

  void start_energy_accounts() override {
    keeps_accounts_ = true;
    accounts_.resize(size());
    for (std::size_t i = 0; i < size(); ++i)
      accounts_[i] = {responses_[i].force, 0.0, 0.0, laws_[i].stored_energy(committed_[i], now_[i].deformation)};
  }
  ElementEnergy energy(std::size_t i) const override {
    if (!keeps_accounts_) throw std::logic_error{"PlanarBlock: energy() without start_energy_accounts()"};
    const Account& account = accounts_[i];
    return {.work = account.work,
            .stored = laws_[i].stored_energy(committed_[i], start_[i].deformation) - account.stored_at_start,
            .dissipated = account.dissipated,
            .hysteretic = true};
  }

  ElementResults results() const override { return {deformations_, rates_, forces_, force_rates_}; }
  std::span<const ReportedQuantity> law_quantities(std::size_t) const override { return {}; }
  ReportedValue law_quantity(std::size_t, std::size_t) const override {
    throw std::logic_error{"PlanarBlock: a law without quantities was asked for one"};
  }

  double force_inside(std::size_t i, double fraction) const override {
    // commit() has left the states of the step's start in trial_, and its motion in before_.
    const Path path{before_[i], start_[i], last_step_};
    State after;
    return length(
        laws_[i].evaluate(trial_[i], path.value(fraction), path.rate(fraction), fraction * last_step_, after).force);
  }

  PlanVector position(std::size_t i) const override { return positions_[i]; }
  double linear_stiffness(std::size_t i, StiffnessStage stage) const override {
    return laws_[i].linear_stiffness(stage);
  }
  PlanVector deformation(std::size_t i) const override { return now_[i].deformation; }
  PlanVector deformation_rate(std::size_t i) const override { return now_[i].rate; }
  PlanVector force(std::size_t i) const override { return responses_[i].force; }
  PlanVector force_rate(std::size_t i) const override { return force_rate_[i]; }

 private:
  struct Motion {
    PlanVector deformation, rate, second_rate;  // m, m/s, m/s^2
  };
  struct Account {
    PlanVector force;  // at the last commit
    double work = 0.0, dissipated = 0.0, stored_at_start = 0.0;
  };
  // The deformation over a step, through value and both rates at its ends.
  struct Path {
    Path(const Motion& start, const Motion& end, double step)
        : x{start.deformation.x, start.rate.x, start.second_rate.x, end.deformation.x, end.rate.x,
            end.second_rate.x,   step},
          y{start.deformation.y, start.rate.y, start.second_rate.y, end.deformation.y, end.rate.y,
            end.second_rate.y,   step} {}
    [[nodiscard]] PlanVector value(double fraction) const { return {x.value(fraction), y.value(fraction)}; }
    [[nodiscard]] PlanVector rate(double fraction) const { return {x.rate(fraction), y.rate(fraction)}; }
    HermiteQuintic x, y;
  };

  static double rate_of_size(PlanVector vector, PlanVector rate, double size) {
    return size > 0.0 ? dot(vector, rate) / size : 0.0;
  }
  // Without the care of std::hypot for numbers near the ends of their range, which costs ten times as much.
  static double size_of(PlanVector vector) { return std::sqrt(dot(vector, vector)); }
  // The norm of a matrix that is the same in all axes.
  static double size_of(PlanMatrix a) { return std::sqrt(a.xx * a.xx + a.xy * a.xy + a.yx * a.yx + a.yy * a.yy); }

  void add_step(std::size_t i, double step, WorkRule rule) {
    Account& account = accounts_[i];
    const PlanVector force = responses_[i].force;
    if (step > 0.0) {
      account.work += rule == WorkRule::mean_force
                          ? dot(0.5 * (account.force + force), now_[i].deformation - start_[i].deformation)
                          : work_by_quadrature(i, step);
      account.dissipated += laws_[i].dissipated_energy(committed_[i], trial_[i]);
    }
    account.force = force;
  }

  // Lobatto's rule with four points (elements/line/link_energies.hpp).
  [[nodiscard]] double work_by_quadrature(std::size_t i, double step) const {
    constexpr double first_inside = 0.27639320225002103;  // (1 - 1/sqrt(5))/2
    const Path path{start_[i], now_[i], step};
    double work = dot(accounts_[i].force, start_[i].rate) + dot(responses_[i].force, now_[i].rate);
    for (const double x : {first_inside, 1.0 - first_inside}) {
      State after;
      work +=
          5.0 * dot(laws_[i].evaluate(committed_[i], path.value(x), path.rate(x), x * step, after).force, path.rate(x));
    }
    return step / 12.0 * work;
  }

  std::vector<ElementInfo> infos_;
  std::vector<Law> laws_;
  std::vector<PlanEndsBothWays> ends_;
  std::vector<PlanVector> positions_;  // m
  std::vector<State> committed_, trial_;
  std::vector<PlanarResponse> responses_, start_responses_;  // of the last evaluate(), and at the last commit
  std::vector<Motion> now_, start_, before_;                 // at the last evaluate(), commit, and the one before
  std::vector<PlanVector> force_rate_;
  std::vector<double> deformations_, rates_, forces_, force_rates_;
  std::vector<Account> accounts_;
  bool keeps_accounts_ = false, tangent_changed_ = false;
  double step_ = 0.0, last_step_ = 0.0;  // s
};

}  // namespace moat
