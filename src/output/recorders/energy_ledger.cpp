#include "output/recorders/energy_ledger.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

namespace moat {
namespace {

double kinetic_energy(const Model& model) {
  const int count = model.degrees_of_freedom();
  return 0.5 * model.masses().dot(model.state().velocity.head(count).cwiseAbs2());
}

}  // namespace

void EnergyLedger::start(const StepView& view) {
  const int count = view.model.degrees_of_freedom();
  const GroundShares shares = view.model.ground_shares();
  const bool all_along_x = std::all_of(shares.x, shares.x + count, [](double share) { return share == 1.0; });
  mass_along_x_.resize(all_along_x ? 0 : count);
  mass_along_y_.resize(view.model.is_plan() ? count : 0);
  for (int i = 0; i < mass_along_x_.size(); ++i) mass_along_x_[i] = view.model.masses()[i] * shares.x[i];
  for (int i = 0; i < mass_along_y_.size(); ++i) mass_along_y_[i] = view.model.masses()[i] * shares.y[i];
  remember(view);
  input_ = largest_input_ = 0.0;
  kinetic_at_start_ = kinetic_energy(view.model);
  largest_kinetic_ = kinetic_at_start_;
}

void EnergyLedger::step(const StepView& view) {
  add_input(view, mass_along_x_.size() == 0 ? view.model.masses() : mass_along_x_, ground_acceleration_.x,
            view.ground_acceleration);
  if (view.model.is_plan()) add_input(view, mass_along_y_, ground_acceleration_.y, view.ground_acceleration_y);
  largest_input_ = std::max(largest_input_, std::abs(input_));
  largest_kinetic_ = std::max(largest_kinetic_, kinetic_energy(view.model));
  remember(view);
}

// Adds the input of one component of the ground, which acts on these masses.
void EnergyLedger::add_input(const StepView& view, const Vector& masses, double ground_before, double ground_now) {
  const MotionState& end = view.model.state();
  const int count = view.model.degrees_of_freedom();
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
  const MotionState& state = view.model.state();
  const int count = view.model.degrees_of_freedom();
  time_ = state.time;
  displacement_ = state.displacement.head(count);
  velocity_ = state.velocity.head(count);
  acceleration_ = state.acceleration.head(count);
  ground_acceleration_ = view.ground();
}

EnergyBalance EnergyLedger::totals(const Model& model) const {
  EnergyBalance balance;
  balance.input = input_;
  balance.largest_input = largest_input_;
  balance.largest_kinetic = largest_kinetic_;
  balance.kinetic = kinetic_energy(model) - kinetic_at_start_;
  EnergySums sums;
  for (const auto& block : model.blocks()) block->add_energies(sums);
  balance.strain = sums.stored;
  balance.integration_error = sums.error;
  balance.viscous = sums.viscous;
  balance.hysteretic = sums.hysteretic;
  balance.impact = sums.by_impact;
  balance.friction = sums.by_friction;
  balance.in_plan = model.is_plan();
  balance.equation_residual = balance.kinetic + sums.work - balance.input;
  return balance;
}

EnergyBalance EnergyLedger::balance(const Model& model) const {
  constexpr double round_off = 1e-10;          // of force times deformation, in all steps
  constexpr double least_deformation = 1e-12;  // m: a law may have a force without one
  EnergyBalance balance = totals(model);
  std::map<std::string, std::size_t> position_of_place;
  for (const auto& block : model.blocks()) {
    const ElementResults results = block->results();
    for (std::size_t e = 0; e < block->size(); ++e) {
      balance.round_off +=
          round_off * std::abs(results.forces[e]) * (std::abs(results.deformations[e]) + least_deformation);
      const ElementInfo& info = block->info(e);
      const ElementEnergy energy = block->energy(e);
      if (std::abs(energy.error()) > std::abs(balance.worst_element_error)) {
        balance.worst_element_error = energy.error();
        balance.worst_element = info.name;
      }
      if (block->contacts() != nullptr) {
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
