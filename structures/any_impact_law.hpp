// A law of pounding of any kind, on a line and in plan.
#pragma once

#include <functional>
#include <utility>

#include "elements/contact/corner_gap.hpp"
#include "elements/contact/gap.hpp"

namespace moat {

/// Any law for a Gap: `ExactHertzDamp`, `NamedImpactLaw`, one of the script's own.
class AnyImpactLaw {
 public:
  /// A copy of the law.
  template <ImpactLaw Law>
  AnyImpactLaw(Law law)
      : on_line_{[law](Model& model, const GapPlace& gap) {
          add(model, Gap<Law>{.name = gap.name,
                              .place = gap.place,
                              .left = gap.left,
                              .right = gap.right,
                              .clearance = gap.clearance,
                              .law = law});
        }},
        in_plan_{[law](Model& model, const CornerPlace& gap) { add(model, gap, law); }} {}

  /// Adds a gap of a model on a line. Throws InputError as it does.
  void add_on_line(Model& model, const GapPlace& gap) const { on_line_(model, gap); }
  /// Adds a gap between a corner and an edge. Throws InputError as it does.
  void add_in_plan(Model& model, const CornerPlace& gap) const { in_plan_(model, gap); }

 private:
  std::function<void(Model&, const GapPlace&)> on_line_;
  std::function<void(Model&, const CornerPlace&)> in_plan_;
};

}  // namespace moat
