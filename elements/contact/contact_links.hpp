// Links that touch and separate.
#pragma once

#include <algorithm>
#include <cmath>
#include <concepts>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "elements/line/links_with_regimes.hpp"
#include "materials/contact/contact_state.hpp"
#include "materials/contact/free_impact.hpp"

namespace moat {

/// Links with a contact law. Besides the regimes they keep the approach speed of every contact, and its duration as a
/// free impact, from which the length of steps follows.
template <ContactLaw Law, class Ends = NodePair>
class ContactLinks : public LinksWithRegimes<Law, Ends>, public Contacts {
  using Base = LinksWithRegimes<Law, Ends>;

 public:
  /// Touch, approach speed and phase of a contact.
  using State = ContactState;

  /// Appends an element. effective_mass > 0 kg is used to estimate the duration of a contact, and the approach speed of
  /// a gap that is closed at the start.
  template <std::constructible_from<const ElementInfo&> AtNodes = Ends>
  std::size_t add(ElementInfo info, const Law& law, double effective_mass) {
    const AtNodes ends{info};
    return add(std::move(info), law, effective_mass, ends);
  }
  /// As above, with ends that are not the nodes of `info`.
  std::size_t add(ElementInfo info, const Law& law, double effective_mass, const Ends& ends) {
    effective_masses_.push_back(effective_mass);
    durations_.push_back(0.0);
    approach_speeds_.push_back(0.0);
    info.drawn_as = DrawnAs::gap;
    return Base::add(std::move(info), law, ends);
  }

  std::unique_ptr<ElementBlock> clone() const override { return std::make_unique<ContactLinks>(*this); }
  Contacts* contacts() override { return this; }
  const Contacts* contacts() const override { return this; }
  /// A closed gap does not count.
  bool linear_between_events() const override { return true; }

  ContactView contact(std::size_t i) const override {
    if (!is_touching(i)) return {false, approach_speeds_[i], 0.0};
    const double impulse = effective_masses_[i] * this->committed_[i].approach_speed;
    return {true, approach_speeds_[i], std::numbers::pi * impulse / durations_[i]};
  }

  int touching() const override { return touching_; }

  double shortest_contact() const override {
    double shortest = std::numeric_limits<double>::infinity();
    if (touching_ > 0)
      for (std::size_t i = 0; i < this->size(); ++i)
        if (is_touching(i)) shortest = std::min(shortest, durations_[i]);
    return shortest;
  }

  double delivered_restitution(std::size_t i, double approach_speed) const override {
    if (approach_speed <= 0.0) return std::numeric_limits<double>::quiet_NaN();
    try {
      return moat::delivered_restitution(this->laws_[i], effective_masses_[i], approach_speed);
    } catch (const Error&) {
      // A contact that never ends has no restitution; the impact itself is reported all the same.
      return std::numeric_limits<double>::quiet_NaN();
    }
  }

 protected:
  void enter(std::size_t i, const State& next, double rate, RegimeChange& change) override {
    const bool touched_before = is_touching(i);
    this->committed_[i] = next;
    const bool touches = is_touching(i);
    touching_ += static_cast<int>(touches) - static_cast<int>(touched_before);
    if (touches && !touched_before) {
      change.touched = true;
      approach_speeds_[i] = rate;
      // A gap that is closed at the start has no approach. Its law uses the speed of an elastic impact that reaches
      // this depth. At a located touch the depth is so small that this speed is negligible.
      double& counted = this->committed_[i].approach_speed;
      counted = std::max(counted, std::sqrt(2.0 * this->stored(i) / effective_masses_[i]));
    }
    change.opened = change.opened || (touched_before && !touches);
    if (touches)
      durations_[i] = this->laws_[i].contact_duration(effective_masses_[i], this->committed_[i].approach_speed);
  }

  // At touch, if the force is of the size it has at the end of the step at once; and where the gap opens while it still
  // pulls.
  bool jumps(std::size_t i, const State& next, double rate) const override {
    constexpr double of_end = 0.3, of_expected = 0.01;
    if (!is_touching(i)) {
      const double end = force_at(i, next, this->now_.deformations[i], this->now_.rates[i]);
      return std::abs(force_at(i, next, least_indentation, rate)) > of_end * std::abs(end);
    }
    return next.phase == ContactPhase::open && std::abs(force_at(i, this->committed_[i], least_indentation, rate)) >
                                                   of_expected * contact(i).expected_force;
  }

  /// Whether a contact has touched and not opened, at the committed state.
  [[nodiscard]] bool is_touching(std::size_t i) const { return this->committed_[i].phase != ContactPhase::open; }

 private:
  static constexpr double least_indentation = 1e-12;  // m

  [[nodiscard]] double force_at(std::size_t i, const State& state, double indentation, double rate) const {
    State after;
    return this->laws_[i].evaluate(state, indentation, rate, after).force;
  }

  std::vector<double> effective_masses_, durations_;  // kg; s, of the contact in progress
  std::vector<double> approach_speeds_;               // m/s, at the last touch; that of the law's state has a floor
  int touching_ = 0;                                  // number of contacts in progress
};

}  // namespace moat
