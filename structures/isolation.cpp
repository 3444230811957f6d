#include "structures/isolation.hpp"

#include <algorithm>

namespace moat {

Isolation::Isolation(LeadRubberBearing bearing) { take(std::move(bearing)); }

void Isolation::add_to(Model& model, const std::string& prefix, NodeId base, Force weight,
                       const std::optional<AxialForces>& axial_forces) const {
  std::vector<Force> weights(parts_.size(), weight);
  if (axial_forces) {
    const Check check{"Isolation", ""};
    std::vector<BearingPlace> places;
    for (const Part& part : parts_) {
      if (!part.carries) continue;
      check.that(part.place.has_value(), "axial_forces: \"" + part.name + "\" has no position.",
                 "Give Isolator{.name = ..., .law = ..., .at = 3 * m} for each group of bearings.");
      places.push_back(*part.place);
    }
    const std::vector<Force> shares = static_weights(check, *axial_forces, places, weight, {}, false);
    std::size_t next = 0;
    for (std::size_t i = 0; i < parts_.size(); ++i)
      if (parts_[i].carries) weights[i] = shares[next++];
  }
  for (std::size_t i = 0; i < parts_.size(); ++i)
    parts_[i].add(model, prefix + parts_[i].name, base, weights[i], axial_forces.has_value());
}

void Isolation::take(const std::string& name, NodeId lower, NodeId upper, Add add) {
  has_lower_ = lower != ground;
  has_upper_ = upper.specified();
  parts_.push_back({.name = name, .add = std::move(add)});
}

void Isolation::join(Isolation other) {
  has_lower_ = has_lower_ || other.has_lower_;
  has_upper_ = has_upper_ || other.has_upper_;
  for (Part& part : other.parts_) {
    const std::string name = part.name;
    for (int number = 2; std::ranges::count(parts_, part.name, &Part::name) > 0; ++number)
      part.name = name + " " + std::to_string(number);
    parts_.push_back(std::move(part));
  }
}

}  // namespace moat
