// Where an element in plan is attached.
#pragma once

#include "base/plan_vector.hpp"

namespace moat {

/// Where a spring in plan is attached to its bodies at rest.
struct PlanPlaces {
  PlanVector first{}, second{};  ///< as ElementInfo::first and second, m
  PlanVector direction{};        ///< of length 1, along its force; zero for one that acts in both directions

  friend bool operator==(const PlanPlaces&, const PlanPlaces&) = default;
};

}  // namespace moat
