// One of the contact laws, chosen when the program runs.
#pragma once

#include <concepts>
#include <string_view>
#include <variant>
#include <vector>

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
  [[nodiscard]] std::string_view name() const;
  [[nodiscard]] std::vector<Parameter> parameters() const;

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    return std::visit([&](const auto& law) { return law.evaluate(committed, indentation, rate, trial); }, form_);
  }
  double stored_energy(const State& committed, double indentation) const {
    return std::visit([&](const auto& law) { return law.stored_energy(committed, indentation); }, form_);
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    return std::visit([&](const auto& law) { return law.dissipation_rate(committed, indentation, rate); }, form_);
  }
  double linear_stiffness(StiffnessStage stage) const;
  double regime_margin(const State& committed, double indentation, double rate) const {
    return std::visit([&](const auto& law) { return law.regime_margin(committed, indentation, rate); }, form_);
  }
  State next_regime(const State& committed, double indentation, double rate) const;
  /// Returns the contact duration of the form that it is, s.
  double contact_duration(double effective_mass, double approach_speed) const;

 private:
  Form form_;
};

}  // namespace moat
