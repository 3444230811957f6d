// The isolators under a building, of any kind.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "elements/line/isolator.hpp"
#include "elements/line/lead_rubber_bearing.hpp"
#include "elements/line/spring.hpp"
#include "model/model.hpp"
#include "structures/static_weights.hpp"

namespace moat {

/// A damper beside isolators: `static constexpr bool is_damper = true` in the law.
template <class Law>
concept DamperLaw = ForceLaw<Law> && Law::is_damper;

/// The isolators of a building: lead-rubber bearings, an Isolator with any law, or the law itself, also one of the
/// script's own; or several of them side by side, among them dampers.
///
///     .isolation = LeadRubberBearing{...}
///     .isolation = FrictionPendulum{...}
///     .isolation = BearingDesign{.strength_ratio = 0.06, ...}
///     .isolation = Isolator{.name = "pendulums", .law = MyPendulum{...}, .count = 20}
///     .isolation = Isolation{LeadRubberBearing{...}, NonlinearViscous{...}}
///
/// A law alone is named "bearings"; a BearingDesign gives lead-rubber bearings for the weight of the building.
///
/// The building puts them between the ground and its base; `lower` and `upper` must not be given. It gives its weight
/// to laws that need it, all of it to each: bearings of several kinds side by side need their own `weight`. Dampers are
/// named "dampers" and report `damper_force` [N] and `damper_deformation` [m]. Names that repeat are numbered.
class Isolation {
 public:
  Isolation(LeadRubberBearing bearing);  ///< Lead-rubber bearings.
  /// An isolator of any law.
  template <IsolatorLaw Law>
  Isolation(Isolator<Law> isolator) {
    take(std::move(isolator));
  }
  /// Takes a law alone.
  template <IsolatorLaw Law>
  Isolation(Law law) {
    if constexpr (DamperLaw<Law>)
      take(Spring<Law>{.name = "dampers",
                       .lower = ground,
                       .upper = NodeId{},
                       .law = std::move(law),
                       .deformation_quantity = "damper_deformation",
                       .force_quantity = "damper_force"});
    else
      take(Isolator<Law>{.law = std::move(law)});
  }
  /// Several side by side.
  template <class First, class Second, class... More>
  Isolation(First first, Second second, More... more) {
    join(Isolation{std::move(first)});
    join(Isolation{std::move(second)});
    (join(Isolation{std::move(more)}), ...);
  }

  /// Adds them below `base`, with their names behind `prefix`, under this weight. With axial forces each has its share
  /// of it, which changes, and needs its place. Throws InputError as the elements would.
  void add_to(Model& model, const std::string& prefix, NodeId base, Force weight,
              const std::optional<AxialForces>& axial_forces = {}) const;
  /// Whether ends are given, which the building sets.
  [[nodiscard]] bool has_lower() const { return has_lower_; }
  [[nodiscard]] bool has_upper() const { return has_upper_; }  ///< Whether the script gave its upper node.

 private:
  using Add = std::function<void(Model&, const std::string& name, NodeId base, Force weight, bool weight_changes)>;
  struct Part {
    std::string name;
    Add add;
    std::optional<BearingPlace> place{};  // of one that carries a weight and has a position
    bool carries = false;                 // a weight
  };

  template <class Element>
  void take(Element element) {
    take(element.name, element.lower, element.upper,
         [element](Model& model, const std::string& name, NodeId base, Force weight, bool weight_changes) {
           Element placed = element;
           placed.name = name;
           placed.lower = ground;
           placed.upper = base;
           if constexpr (requires { placed.weight; })
             if (placed.weight.si() == 0.0) placed.weight = weight;
           if constexpr (requires { placed.weight_changes; }) placed.weight_changes = weight_changes;
           moat::add(model, placed);
         });
    parts_.back().carries = !requires { element.force_quantity; };
    if constexpr (requires { element.at; })
      parts_.back().place =
          BearingPlace{{element.at.si(), 0.0}, element.own_weight(), element.vertical_stiffness, element.count};
  }
  void take(const std::string& name, NodeId lower, NodeId upper, Add add);
  void join(Isolation other);

  std::vector<Part> parts_;
  bool has_lower_ = false, has_upper_ = false;
};

}  // namespace moat
