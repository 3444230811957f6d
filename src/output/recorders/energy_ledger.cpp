#include "output/recorders/energy_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace moat {

void EnergyLedger::start(const StepView& view) {
  remember(view);
  input_ = largest_input_ = 0.0;
  largest_kinetic_ = kinetic_at_start_ = view.state.kinetic_energy();
}

void EnergyLedger::step(const StepView& view) {
  const GroundColumns inertia = view.state.ground_inertia();
  add_input(view, inertia.x, ground_acceleration_.x, view.ground_acceleration.x);
  add_input(view, inertia.y, ground_acceleration_.y, view.ground_acceleration.y);
  add_input(view, inertia.z, ground_acceleration_.z, view.ground_acceleration.z);
  largest_input_ = std::max(largest_input_, std::abs(input_));
  largest_kinetic_ = std::max(largest_kinetic_, view.state.kinetic_energy());
  remember(view);
}

// Adds the input of one component of the ground, from the inertia of all degrees of freedom under 1 m/s^2 of it.
void EnergyLedger::add_input(const StepView& view, const double* inertia, double ground_before, double ground_now) {
  if (ground_before == 0.0 && ground_now == 0.0) return;
  const MotionState& end = view.state.motion();
  const int count = view.model.degrees_of_freedom();
  const Eigen::Map<const Vector> masses{inertia, count};
  const auto displacement = end.displacement.head(count);
  if (view.work_rule == WorkRule::mean_force) {
    // The rule is the one for the work of the elements, so that the residual is an identity.
    input_ -= 0.5 * (ground_before + ground_now) * masses.dot(displacement - displacement_);
    return;
  }
  // Integration by parts, with a_g linear in the step: integral of a_g v = a_g1 u1 - a_g0 u0 - slope * integral of u.
  // The last integral is that of the quintic through u, v and a at both ends; `mean` is its sum over the masses.
  const double h = end.time - time_;
  if (h <= 0.0) return;
  const double slope = (ground_now - ground_before) / h;
  const double now = masses.dot(displacement), before = masses.dot(displacement_);
  const double mean = 0.5 * h * (now + before) + h * h / 10.0 * masses.dot(velocity_ - end.velocity.head(count)) +
                      h * h * h / 120.0 * masses.dot(acceleration_ + end.acceleration.head(count));
  input_ -= ground_now * now - ground_before * before - slope * mean;
}

// The next step starts with the accelerations after the jump.
void EnergyLedger::event(const StepView& view, std::span<const RegimeChange>) { remember(view); }

void EnergyLedger::remember(const StepView& view) {
  const MotionState& state = view.state.motion();
  const int count = view.model.degrees_of_freedom();
  time_ = state.time;
  displacement_ = state.displacement.head(count);
  velocity_ = state.velocity.head(count);
  acceleration_ = state.acceleration.head(count);
  ground_acceleration_ = view.ground_acceleration;
}

EnergyBalance EnergyLedger::totals(const AnalysisState& state) const {
  EnergyBalance balance;
  balance.input = input_;
  balance.largest_input = largest_input_;
  balance.largest_kinetic = largest_kinetic_;
  balance.kinetic = state.kinetic_energy() - kinetic_at_start_;
  const Model& model = state.model();
  EnergySums sums;
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const bool contacts = model.blocks()[b]->kind().contacts;
    for (std::size_t e = 0; e < model.blocks()[b]->size(); ++e) sums.add(contacts, state.elements(b).energy(e));
  }
  balance.strain = sums.stored;
  balance.integration_error = sums.error;
  balance.viscous = sums.viscous;
  balance.hysteretic = sums.hysteretic;
  balance.impact = sums.by_impact;
  balance.friction = sums.by_friction;
  balance.in_plan = model.is_plan();
  balance.weights_change = !state.weights().empty() || sums.weight_work != 0.0;
  balance.weight_work = sums.weight_work;
  balance.equation_residual = balance.kinetic + sums.work - balance.input;
  return balance;
}

EnergyBalance EnergyLedger::balance(const AnalysisState& state) const {
  constexpr double round_off = 1e-10;          // of force times deformation, in all steps
  constexpr double least_deformation = 1e-12;  // m: a law may have a force without one
  EnergyBalance balance = totals(state);
  std::map<std::string, std::size_t> position_of_place;
  const Model& model = state.model();
  for (std::size_t b = 0; b < model.blocks().size(); ++b) {
    const ElementBlock& block = *model.blocks()[b];
    const ElementResults results = state.elements(b).results();
    for (std::size_t e = 0; e < block.size(); ++e) {
      balance.round_off +=
          round_off * std::abs(results[e].force) * (std::abs(results[e].deformation) + least_deformation);
      const ElementInfo& info = block.info(e);
      const ElementEnergy energy = state.elements(b).energy(e);
      if (std::abs(energy.error()) > std::abs(balance.worst_element_error)) {
        balance.worst_element_error = energy.error();
        balance.worst_element = info.name;
      }
      if (block.kind().contacts) {
        balance.gaps.push_back({info.name, energy.dissipated});
      } else if (energy.hysteretic) {
        const auto [known, inserted] = position_of_place.try_emplace(info.listed_under(), balance.bearings.size());
        if (inserted) balance.bearings.push_back({info.listed_under(), 0.0});
        balance.bearings[known->second].value += energy.dissipated;
      }
    }
  }
  return balance;
}

}  // namespace moat
