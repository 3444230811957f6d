#include "materials/contact/any_contact.hpp"

namespace moat {

std::string_view AnyContact::name() const {
  return std::visit([](const auto& law) { return law.name; }, form_);
}

std::vector<Parameter> AnyContact::parameters() const {
  return std::visit([](const auto& law) { return law.parameters(); }, form_);
}

double AnyContact::linear_stiffness(StiffnessStage stage) const {
  return std::visit([&](const auto& law) { return law.linear_stiffness(stage); }, form_);
}

ContactState AnyContact::next_regime(const State& committed, double indentation, double rate) const {
  return std::visit([&](const auto& law) { return law.next_regime(committed, indentation, rate); }, form_);
}

double AnyContact::contact_duration(double effective_mass, double approach_speed) const {
  return std::visit([&](const auto& law) { return law.contact_duration(effective_mass, approach_speed); }, form_);
}

}  // namespace moat
