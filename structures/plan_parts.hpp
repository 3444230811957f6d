// Columns and bearings of a building in plan: where they stand.
#pragma once

#include <concepts>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "elements/line/lead_rubber_bearing.hpp"
#include "elements/plan/planar_spring.hpp"
#include "materials/plan/biaxial_bilinear.hpp"
#include "materials/plan/biaxial_friction_pendulum.hpp"
#include "materials/plan/biaxial_grant_rubber.hpp"
#include "model/plan_outline.hpp"

namespace moat {

/// One item for all points of a grid over the outline of a building: `along_x` columns of points by `along_y` rows,
/// from border to border of the rectangle around the outline. A single column or row stands in the middle.
///
///     4 . 5 . 6     grid(3, 2, item): numbered row by row
///     .       .
///     1 . 2 . 3
template <class Item>
struct Grid {
  int along_x, along_y;  ///< how many, >= 1
  Item item;             ///< at every point
};

/// The columns or walls of a storey on a vertical line: springs along x and y.
struct StoreyColumn {
  /// > 0 N/m, in both directions; or give the next two.
  Stiffness stiffness{};
  /// >= 0 N/m, not both zero.
  Stiffness stiffness_x{}, stiffness_y{};

  /// N/m
  [[nodiscard]] Stiffness along_x() const { return stiffness.si() != 0.0 ? stiffness : stiffness_x; }
  /// N/m
  [[nodiscard]] Stiffness along_y() const { return stiffness.si() != 0.0 ? stiffness : stiffness_y; }
};

/// Equal columns in rows along x and y.
inline Grid<StoreyColumn> grid(int along_x, int along_y, StoreyColumn column) { return {along_x, along_y, column}; }

/// The law of two components of a lead-rubber bearing: it yields on a circle.
inline BiaxialBilinear in_plan(const LeadRubberBearing& bearing) {
  return {.yield_force = bearing.yield_force,
          .yield_displacement = bearing.yield_displacement,
          .post_yield_stiffness = bearing.post_yield_stiffness};
}

/// A law of two components, or a bearing that has one, perhaps under the weight on it.
template <class Bearing>
concept BearingInPlan = PlanarLaw<Bearing> || requires(const Bearing& bearing) {
  { in_plan(bearing) } -> PlanarLaw;
} || requires(const Bearing& bearing, Force weight) {
  { in_plan(bearing, weight) } -> PlanarLaw;
};

/// Equal bearings in rows along x and y.
template <BearingInPlan Bearing>
Grid<Bearing> grid(int along_x, int along_y, Bearing bearing) {
  return {along_x, along_y, std::move(bearing)};
}

/// The points of a grid over an outline, row by row. Throws InputError, naming `field`, for counts below 1.
std::vector<PlanPosition> grid_points(const Check& check, const std::string& field, int along_x, int along_y,
                                      const PlanOutline& outline);

/// A column line at a position.
struct ColumnLine {
  PlanPosition at{};    ///< on the floor
  StoreyColumn column;  ///< its springs
};

/// A storey as a whole: forces at its centre of rigidity.
///
///     F = (kx dx, ky dy) at the centre of rigidity,   M = k_theta dtheta
struct StoreyStiffness {
  /// > 0 N/m.
  Required<Stiffness> x;
  Required<Stiffness> y;  ///< > 0 N/m
  /// > 0 N m/rad, about the centre of rigidity.
  Required<Energy> rotation;
  PlanPosition centre_of_rigidity{};  ///< on the floor
};

/// The lateral stiffness of a storey: column lines on a grid or anywhere, or the storey as a whole.
class PlanColumns {
 public:
  /// Equal columns on a grid.
  PlanColumns(Grid<StoreyColumn> columns) : grid_{columns}, is_grid_{true} {}
  /// Column lines anywhere.
  PlanColumns(std::vector<ColumnLine> lines) : lines_{std::move(lines)} {}
  /// The storey as a whole.
  PlanColumns(StoreyStiffness whole) : whole_{whole} {}

  /// Column lines; none where the storey is given as a whole.
  [[nodiscard]] std::vector<ColumnLine> lines(const Check& check, const PlanOutline& outline) const;
  /// Empty where column lines are given.
  [[nodiscard]] const std::optional<StoreyStiffness>& whole() const { return whole_; }

 private:
  Grid<StoreyColumn> grid_{1, 1, {}};
  bool is_grid_ = false;
  std::vector<ColumnLine> lines_{};
  std::optional<StoreyStiffness> whole_{};
};

/// The columns of all storeys: one PlanColumns for all, or a list from the lowest up.
class StoreyColumns {
 public:
  /// One PlanColumns for every storey.
  template <std::convertible_to<PlanColumns> Every>
  StoreyColumns(Every every) : list_{PlanColumns{std::move(every)}} {}
  /// One per storey, from the lowest up.
  StoreyColumns(std::vector<PlanColumns> list) : list_{std::move(list)}, is_list_{true} {}

  /// Columns of storey 1, 2, ...
  [[nodiscard]] const PlanColumns& of(int storey) const {
    return list_[is_list_ ? static_cast<std::size_t>(storey - 1) : 0];
  }
  /// Throws InputError unless a list has one for each storey.
  void check(const Check& check, int storeys) const {
    check.that(!is_list_ || list_.size() == static_cast<std::size_t>(storeys),
               "columns has " + std::to_string(list_.size()) + " entries for " + std::to_string(storeys) + " storeys.",
               "Give one for all storeys, or one for each from the lowest up.");
  }

 private:
  std::vector<PlanColumns> list_;
  bool is_list_ = false;
};

/// The bearings under a building: any law of two components, or LeadRubberBearing, FrictionPendulum or GrantRubber,
/// which have one; on a grid, or each at its place. A pendulum without a weight carries its share of the building, the
/// same for every bearing.
///
///     .bearings = grid(3, 2, BiaxialBoucWen{...})
///     .bearings = grid(3, 2, FrictionPendulum{...})
///     .bearings = {{at_1, BiaxialBilinear{...}}, {at_2, LeadRubberBearing{...}}}
class PlanBearings {
 public:
  /// One bearing, of any such law.
  class Placed {
   public:
    /// A bearing at a position on the floor.
    template <BearingInPlan Bearing>
    Placed(PlanPosition at, Bearing bearing) : at_{at} {
      add_ = [bearing](Model& model, const Names& names, DiaphragmId under, PlanPosition at_place, Force weight) {
        const auto place = [&](const auto& law) {
          add(model, PlanBearing<std::remove_cvref_t<decltype(law)>>{
                         .name = names.name, .under = under, .at = at_place, .law = law, .place = names.place});
        };
        if constexpr (PlanarLaw<Bearing>)
          place(bearing);
        else if constexpr (requires { in_plan(bearing); })
          place(in_plan(bearing));
        else
          place(in_plan(bearing, weight));
      };
    }

    /// On the floor, as given.
    [[nodiscard]] PlanPosition at() const { return at_; }
    /// Returns the same bearing at another position.
    [[nodiscard]] Placed moved_to(PlanPosition at) const {
      Placed copy = *this;
      copy.at_ = at;
      return copy;
    }
    /// Names of the element and of the place that its peaks are listed under.
    struct Names {
      std::string name, place;  ///< unique, and common to all bearings of a building
    };
    /// `weight` is that on this bearing.
    void add_to(Model& model, const Names& names, DiaphragmId under, Force weight) const {
      add_(model, names, under, at_, weight);
    }

   private:
    PlanPosition at_;
    std::function<void(Model&, const Names&, DiaphragmId, PlanPosition, Force)> add_;
  };

  /// Equal bearings on a grid.
  template <class Law>
  PlanBearings(Grid<Law> bearings)
      : along_x_{bearings.along_x}, along_y_{bearings.along_y}, list_{Placed{PlanPosition{}, bearings.item}} {}
  /// Bearings anywhere.
  PlanBearings(std::vector<Placed> list);
  /// Bearings anywhere.
  PlanBearings(std::initializer_list<Placed> list);
  // All of these are defaults; compiled in the library, they cost no time in scripts.
  PlanBearings(const PlanBearings& other);                 ///< A copy.
  PlanBearings(PlanBearings&& other) noexcept;             ///< Takes all of it.
  PlanBearings& operator=(const PlanBearings& other);      ///< A copy.
  PlanBearings& operator=(PlanBearings&& other) noexcept;  ///< Takes all of it.
  ~PlanBearings();

  /// At their positions on the outline. Throws InputError for a grid of less than 1 x 1.
  [[nodiscard]] std::vector<Placed> placed(const Check& check, const PlanOutline& outline) const;

 private:
  int along_x_ = 0, along_y_ = 0;  // of a grid
  std::vector<Placed> list_;
};

}  // namespace moat
