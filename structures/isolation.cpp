#include "structures/isolation.hpp"

#include <algorithm>

namespace moat {

Isolation::Isolation(LeadRubberBearing bearing) { take(std::move(bearing)); }

void Isolation::add_to(Model& model, const std::string& prefix, NodeId base, Force weight) const {
  for (const Part& part : parts_) part.add(model, prefix + part.name, base, weight);
}

void Isolation::take(const std::string& name, NodeId lower, NodeId upper, Add add) {
  has_lower_ = lower != ground;
  has_upper_ = upper.specified();
  parts_.push_back({name, std::move(add)});
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
