// The order of rows in the matrices of a building.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/check.hpp"

namespace moat {

/// A direction in which a floor moves; rotation is counter-clockwise, in rad.
enum class FloorDirection { x, y, rotation };

/// A row of a matrix: a direction of a floor, counted from 1, the lowest, or of the base.
struct Freedom {
  int floor = 0;                                 ///< >= 0; 0 is the base
  FloorDirection direction = FloorDirection::x;  ///< of its motion
  int slab = 1;                                  ///< >= 1, of a base of several slabs; else 1

  /// "floor 3 rotation", "base x", "slab 2 x"
  [[nodiscard]] std::string name() const;
  friend bool operator==(const Freedom&, const Freedom&) = default;
};

/// The rows of a floor in a standard order.
enum class Freedoms {
  x,             ///< one: the building moves on a line
  x_y_rotation,  ///< three, about the floor's centre of mass
};

/// Whether the rows begin with the lowest floor or with the highest.
enum class FloorOrder { bottom_up, top_down };

/// The freedoms of the rows of matrices: in a standard order, or one by one.
///
///     .freedoms = per_floor(Freedoms::x_y_rotation)
///     .freedoms = {{1, FloorDirection::x}, {1, FloorDirection::y}, {1, FloorDirection::rotation}, {2, ...}}
class FreedomOrder {
 public:
  FreedomOrder(std::vector<Freedom> rows) : rows_{std::move(rows)} {}                        ///< One for each row.
  FreedomOrder(std::initializer_list<Freedom> rows) : rows_{rows} {}                         ///< One for each row.
  FreedomOrder(Freedoms of_floor, FloorOrder order) : of_floor_{of_floor}, order_{order} {}  ///< In standard order.

  /// The rows of the base are below those of floor 1 in the same order. They are checked, and not used: rigid motion
  /// of base and floors must strain nothing, and no mass may couple them. Mass and damping may leave them out.
  [[nodiscard]] FreedomOrder with_base() const;
  /// Returns one for each row of a matrix of this size; without the base where there are just so many `floors`. Throws
  /// InputError for a size that is no multiple of the rows of a floor, and for a list of another length.
  [[nodiscard]] std::vector<Freedom> list(const Check& check, std::string_view field, int size, int floors = 0) const;

 private:
  std::vector<Freedom> rows_;
  Freedoms of_floor_ = Freedoms::x;
  FloorOrder order_ = FloorOrder::bottom_up;
  bool with_base_ = false;
};

/// The freedoms that a file names: "floor 1 x", "base rotation". Throws InputError for another name.
std::vector<Freedom> freedoms_named(const Check& check, const std::vector<std::string>& names);

/// Where every freedom of the floors stands among `given`: floor by floor from the lowest up, x alone or x, y and
/// rotation. Throws InputError for a freedom that is given twice, a floor that lacks a direction or is missing.
std::vector<int> positions_of(const Check& check, const std::vector<Freedom>& given, int floors, bool in_plan);
/// Returns and throws likewise for the slabs of the base.
std::vector<int> positions_of_base(const Check& check, const std::vector<Freedom>& given, int slabs, bool in_plan);

/// The rows of every floor in a standard order.
inline FreedomOrder per_floor(Freedoms of_floor, FloorOrder order = FloorOrder::bottom_up) { return {of_floor, order}; }

}  // namespace moat
