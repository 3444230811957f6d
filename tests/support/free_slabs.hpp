// Free slabs in plan, and the contacts of a model.
#pragma once

#include <set>
#include <string>

#include "moat.hpp"

namespace moat::testing {

inline constexpr double restitution = 0.65;
inline ExactHertzDamp law() { return {.stiffness = 1e9 * units::N / units::m_3_2, .restitution = restitution}; }

inline DiaphragmId add_slab(Model& model, const std::string& name, const PlanOutline& outline, Speed vx = {},
                            Speed vy = {}) {
  return add(model, Diaphragm{.name = name,
                              .mass = 800 * units::tonne,
                              .centre_of_mass = {Length{outline.centroid().x}, Length{outline.centroid().y}},
                              .outline = outline,
                              .initial_velocity_x = vx,
                              .initial_velocity_y = vy,
                              .free = true});
}

inline std::set<std::string> contacts_of(const Model& model) {
  std::set<std::string> names;
  for (const auto& block : model.blocks())
    for (std::size_t e = 0; block->kind().contacts && e < block->size(); ++e) names.insert(block->info(e).name);
  return names;
}

}  // namespace moat::testing
