// The motion of a diaphragm over time.
#pragma once

#include <optional>

#include "base/plan_vector.hpp"
#include "output/files/model_facts.hpp"
#include "output/files/table.hpp"

namespace moat {

/// Displacements of the points of a diaphragm, from the columns of a table that must outlive it.
class Orbit {
 public:
  /// Columns of the same table, in m.
  Orbit(const Column& time, const Column& x, const Column& y, const Column& rotation)
      : time_{time}, x_{x}, y_{y}, rotation_{rotation} {}

  /// Number of rows of the table.
  [[nodiscard]] std::size_t rows() const { return time_.values.size(); }
  /// Displacement of a point with this arm from the centre of mass, m.
  [[nodiscard]] PlanVector displacement(std::size_t row, PlanVector arm) const {
    return PlanVector{x_.values[row], y_.values[row]} + rotation_.values[row] * turned_left(arm);
  }
  /// At a time in s, linear between rows.
  [[nodiscard]] PlanVector displacement_at(double time, PlanVector arm) const;

 private:
  const Column &time_, &x_, &y_, &rotation_;
};

/// None where a column is missing.
std::optional<Orbit> orbit_of(const DiaphragmFacts& diaphragm, const Table& histories);

}  // namespace moat
