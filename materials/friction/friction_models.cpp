#include "materials/friction/friction_models.hpp"

namespace moat {

void Friction::check(const Check& check) const {
  std::visit([&](const auto& model) { model.check(check); }, model_);
}

std::vector<Parameter> Friction::parameters() const {
  return std::visit([](const auto& model) { return model.parameters(); }, model_);
}

}  // namespace moat
