// Columns and bearings of a building in plan: where they stand.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "elements/line/isolator.hpp"
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

/// The bearing of a design under this weight, N, unless the design has a weight of its own. Throws InputError for a bad
/// parameter.
inline BiaxialBilinear in_plan(const BearingDesign& design, Force weight) {
  design.check(Check{"BearingDesign", ""});
  const Bilinear law = design.carrying(design.weight.si() > 0.0 ? design.weight : weight);
  return {.yield_force = law.yield_force,
          .yield_displacement = law.yield_displacement,
          .post_yield_stiffness = law.post_yield_stiffness};
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
  PlanColumns(Grid<StoreyColumn> columns) : form_{columns} {}              ///< Equal columns on a grid.
  PlanColumns(std::vector<ColumnLine> lines) : form_{std::move(lines)} {}  ///< Column lines anywhere.
  PlanColumns(StoreyStiffness whole) : form_{whole} {}                     ///< The storey as a whole.

  /// Column lines, for a storey that is not given as a whole. Throws InputError for a grid of less than 1 x 1.
  [[nodiscard]] std::vector<ColumnLine> lines(const Check& check, const PlanOutline& outline) const;
  /// The storey as a whole; null where column lines are given.
  [[nodiscard]] const StoreyStiffness* whole() const { return std::get_if<StoreyStiffness>(&form_); }

 private:
  std::variant<Grid<StoreyColumn>, std::vector<ColumnLine>, StoreyStiffness> form_;
};

/// The bearings under a building: any law of two components, or LeadRubberBearing, FrictionPendulum or GrantRubber,
/// which have one; on a grid, or each at its place. A pendulum or a BearingDesign without a weight carries its share of
/// the building, the same for every bearing.
///
///     .bearings = grid(3, 2, BiaxialBoucWen{...})
///     .bearings = grid(3, 2, FrictionPendulum{...})
///     .bearings = {{at_1, BiaxialBilinear{...}}, {at_2, LeadRubberBearing{...}}}
///     .bearings = read_bearings("bearings.csv", {.types = {{"LRB700", LeadRubberBearing{...}}}})
///
/// Bearings of a type are grouped in results; those without one are "bearings". A bearing without a name is called by
/// its number: "bearing 3".
class PlanBearings {
 public:
  /// Names of an element and of the place that its peaks are listed under.
  struct Names {
    std::string name, place;  ///< unique, and common to all bearings of a type
  };
  /// One bearing, of any such law.
  struct Placed {
    /// A bearing at a position on the floor.
    template <BearingInPlan Bearing>
    Placed(PlanPosition position, Bearing design) : at{position} {
      if constexpr (requires { design.weight; }) weight = design.weight;
      add_to = [design](Model& model, const Names& names, DiaphragmId under, PlanPosition place_at, Force load,
                        std::optional<BearingOnSlab> on_slab) {
        Bearing bearing = design;
        // A table may give another one.
        if constexpr (requires { bearing.weight = load; }) bearing.weight = load;
        if (on_slab)
          on_slab = bearing_on_slab(bearing, on_slab->at, load, on_slab->vertical_stiffness * units::N / units::m);
        // Reports show the law as the script gave it.
        std::optional<LawAsGiven> as_given;
        if constexpr (!PlanarLaw<Bearing> && requires { requires std::is_pointer_v<decltype(&Bearing::name)>; }) {
          as_given = LawAsGiven{std::string{name_of(bearing)}, parameters_of(bearing)};
          if constexpr (requires { bearing.weight; })
            as_given->parameters.push_back({on_slab ? "static_weight" : "weight", load.si(), "N"});
        }
        const auto place = [&](const auto& law) {
          add(model, PlanBearing<std::remove_cvref_t<decltype(law)>>{.name = names.name,
                                                                     .under = under,
                                                                     .at = place_at,
                                                                     .law = law,
                                                                     .place = names.place,
                                                                     .law_as_given = as_given,
                                                                     .on_slab = on_slab});
        };
        if constexpr (requires { in_plan_under_changing_weight(bearing, load); }) {
          if (on_slab) {
            check_rising_friction(Check{"PlanBearing", names.name}, bearing, load);
            return place(in_plan_under_changing_weight(bearing, load));
          }
        }
        if constexpr (PlanarLaw<Bearing>)
          place(bearing);
        else if constexpr (requires { in_plan(bearing); })
          place(in_plan(bearing));
        else
          place(in_plan(bearing, load));
      };
    }

    PlanPosition at;     ///< Place on the floor, m.
    std::string name{};  ///< Unique in its building; left out: its number.
    std::string type{};  ///< Common to equal bearings; left out: "bearings".
    Force weight{};      ///< > 0 N on it; left out: the same share of the building's weight for every bearing.
    Stiffness vertical_stiffness{};  ///< > 0 N/m, for AxialForces; left out: the same for all bearings.
    /// Adds it to a model at a position, under this weight; `on_slab` where it changes.
    std::function<void(Model&, const Names&, DiaphragmId under, PlanPosition at, Force weight,
                       std::optional<BearingOnSlab> on_slab)>
        add_to;
  };

  PlanBearings() = default;  ///< None: the building stands on the ground.
  /// Equal bearings on a grid.
  template <class Law>
  PlanBearings(Grid<Law> bearings)
      : along_x_{bearings.along_x}, along_y_{bearings.along_y}, list_{Placed{PlanPosition{}, bearings.item}} {}
  /// Bearings anywhere, and remarks about their file.
  PlanBearings(std::vector<Placed> list, std::vector<std::string> notes = {})
      : list_{std::move(list)}, notes_{std::move(notes)} {}
  PlanBearings(std::initializer_list<Placed> list) : list_{list} {}  ///< Bearings anywhere.

  explicit operator bool() const { return !list_.empty(); }                       ///< Whether there are any.
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }  ///< Remarks, sentences.
  /// At their positions on the outline. Throws InputError for a grid of less than 1 x 1.
  [[nodiscard]] std::vector<Placed> placed(const Check& check, const PlanOutline& outline) const;
  /// Adds them between the ground and a floor of a building whose parts begin with `prefix`. Throws InputError for a
  /// grid of less than 1 x 1, a bad law, a weight that is not > 0 N, and a name that is taken.
  void add_under(Model& model, const Check& check, const std::string& prefix, DiaphragmId floor,
                 const PlanOutline& outline, Force weight_of_building,
                 const std::optional<AxialForces>& axial_forces = {}, PlanVector centre_of_mass = {}) const;

 private:
  int along_x_ = 0, along_y_ = 0;  // of a grid
  std::vector<Placed> list_;
  std::vector<std::string> notes_;
};

}  // namespace moat
