#include "output/energy_ledger.hpp"

#include <algorithm>
#include <cmath>

namespace moat {
namespace {

double kinetic_energy(const Model& model) {
  const int count = model.degrees_of_freedom();
  return 0.5 * model.masses().dot(model.state().velocity.head(count).cwiseAbs2());
}

void add_to(std::vector<DissipatedEnergy>& list, const std::string& where, double value) {
  const auto known = std::find_if(list.begin(), list.end(), [&](const auto& entry) { return entry.where == where; });
  if (known == list.end())
    list.push_back({where, value});
  else
    known->value += value;
}

}  // namespace

void EnergyLedger::start(const StepView& view) {
  displacement_ = view.model.state().displacement;
  ground_acceleration_ = view.ground_acceleration;
  kinetic_at_start_ = kinetic_energy(view.model);
}

void EnergyLedger::step(const StepView& view) {
  const Vector& displacement = view.model.state().displacement;
  const int count = view.model.degrees_of_freedom();
  const double mean = 0.5 * (ground_acceleration_ + view.ground_acceleration);
  input_ -= mean * view.model.masses().dot(displacement.head(count) - displacement_.head(count));
  largest_input_ = std::max(largest_input_, std::abs(input_));
  displacement_ = displacement;
  ground_acceleration_ = view.ground_acceleration;
}

EnergyBalance EnergyLedger::balance(const Model& model) const {
  EnergyBalance balance;
  balance.input = input_;
  balance.largest_input = largest_input_;
  balance.kinetic = kinetic_energy(model) - kinetic_at_start_;
  double work = 0.0;
  for (const auto& block : model.blocks()) {
    for (std::size_t e = 0; e < block->size(); ++e) {
      const ElementInfo& info = block->info(e);
      const ElementEnergy energy = block->energy(e);
      work += energy.work;
      balance.strain += energy.stored;
      balance.integration_error += energy.error();
      if (std::abs(energy.error()) > std::abs(balance.worst_element_error)) {
        balance.worst_element_error = energy.error();
        balance.worst_element = info.name;
      }
      switch (info.kind) {
        case ElementKind::gap:
          balance.impact += energy.dissipated;
          add_to(balance.gaps, info.name, energy.dissipated);
          break;
        case ElementKind::bearing:
          balance.hysteretic += energy.dissipated;
          add_to(balance.bearings, info.place, energy.dissipated);
          break;
        default:
          balance.viscous += energy.dissipated;
      }
    }
  }
  balance.equation_residual = balance.kinetic + work - balance.input;
  return balance;
}

}  // namespace moat
