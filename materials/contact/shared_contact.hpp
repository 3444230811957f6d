// A share of a contact law.
#pragma once

#include <string_view>
#include <vector>

#include "materials/contact/contact_state.hpp"

namespace moat {

/// The force of a contact law times a share > 0: several points of a face divide the law of the face among them.
template <ContactLaw Law>
struct SharedContact {
  Law law;             ///< of the whole face
  double share = 1.0;  ///< > 0, of its force

  using State = ContactState;

  /// Returns the name of the law of the face.
  [[nodiscard]] std::string_view name() const { return name_of(law); }
  [[nodiscard]] std::vector<Parameter> parameters() const {
    std::vector<Parameter> list = parameters_of(law);
    list.push_back({"share", share, "1"});
    return list;
  }

  Response evaluate(const State& committed, double indentation, double rate, State& trial) const {
    const Response whole = law.evaluate(committed, indentation, rate, trial);
    return {share * whole.force, share * whole.stiffness, share * whole.damping};
  }
  double stored_energy(const State& committed, double indentation) const {
    return share * law.stored_energy(committed, indentation);
  }
  double dissipation_rate(const State& committed, double indentation, double rate) const {
    return share * law.dissipation_rate(committed, indentation, rate);
  }
  double linear_stiffness(StiffnessStage stage) const { return share * law.linear_stiffness(stage); }
  double regime_margin(const State& committed, double indentation, double rate) const {
    return law.regime_margin(committed, indentation, rate);
  }
  State next_regime(const State& committed, double indentation, double rate) const {
    return law.next_regime(committed, indentation, rate);
  }
  /// Returns the contact duration of the mass that the share carries, s.
  double contact_duration(double effective_mass, double approach_speed) const {
    return law.contact_duration(effective_mass / share, approach_speed);
  }
};

}  // namespace moat
