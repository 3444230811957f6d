// One of the contact laws, chosen when the program runs.
#pragma once

#include <concepts>
#include <variant>

#include "materials/contact/bilinear_contact.hpp"
#include "materials/contact/root_damped_hertz_contact.hpp"
#include "materials/contact/viscous_hertz_contact.hpp"
#include "materials/contact/viscous_linear_contact.hpp"
#include "materials/response.hpp"

namespace moat {

/// Any of the forms of contact, itself a law like them.
class AnyContact {
 public:
  using State = ContactState;
  /// All forms of contact.
  using Form = std::variant<ViscousHertzContact, RootDampedHertzContact, ViscousLinearContact, BilinearContact>;

  /// Any law that is one of the forms, or converts to one.
  template <class Law>
  requires std::constructible_from<Form, const Law&> AnyContact(const Law& law) : form_{law} {}

  /// The form that it is.
  [[nodiscard]] const Form& form() const { return form_; }

  /// Returns the name of the form that it is.
  [[nodiscard]] std::string_view name() const {
    return std::visit([](const auto& law) { return law.name; }, form_);
  }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    return std::visit([](const auto& law) { return law.parameters(); }, form_);
  }

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    return std::visit([&](const auto& law) { return law.evaluate(committed, indentation, rate, trial); }, form_);
  }
  double stored_energy(const State& committed, double indentation) const {
    return std::visit([&](const auto& law) { return law.stored_energy(committed, indentation); }, form_);
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    return std::visit([&](const auto& law) { return law.dissipation_rate(committed, indentation, rate); }, form_);
  }
  double linear_stiffness(StiffnessStage stage) const {
    return std::visit([&](const auto& law) { return law.linear_stiffness(stage); }, form_);
  }
  double regime_margin(const State& committed, double indentation, double rate) const {
    return std::visit([&](const auto& law) { return law.regime_margin(committed, indentation, rate); }, form_);
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    return std::visit([&](const auto& law) { return law.next_regime(committed, indentation, rate); }, form_);
  }
  /// Returns the contact duration of the form that it is, s.
  double contact_duration(double effective_mass, double approach_speed) const {
    return std::visit([&](const auto& law) { return law.contact_duration(effective_mass, approach_speed); }, form_);
  }

 private:
  Form form_;
};

/// One of moat's contacts as AnyContact, so that all of them share a block of elements; any other contact as it is.
template <ContactLaw Law>
auto as_any_contact(const Law& law) {
  if constexpr (std::constructible_from<AnyContact, const Law&>)
    return AnyContact{law};
  else
    return law;
}

}  // namespace moat
