#include "structures/isolation.hpp"

namespace moat {

Isolation::Isolation(LeadRubberBearing bearing) { take(std::move(bearing)); }
Isolation::Isolation(const Isolation& other) = default;
Isolation::Isolation(Isolation&& other) noexcept = default;
Isolation& Isolation::operator=(const Isolation& other) = default;
Isolation& Isolation::operator=(Isolation&& other) noexcept = default;
Isolation::~Isolation() = default;

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
    for (int number = 2; is_taken(part.name); ++number) part.name = name + " " + std::to_string(number);
    parts_.push_back(std::move(part));
  }
}

bool Isolation::is_taken(const std::string& name) const {
  for (const Part& part : parts_)
    if (part.name == name) return true;
  return false;
}

}  // namespace moat
