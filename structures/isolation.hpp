// The isolators under a building, of any kind.
#pragma once

#include <functional>
#include <string>
#include <utility>

#include "elements/isolator.hpp"
#include "elements/lead_rubber_bearing.hpp"
#include "model/model.hpp"

namespace moat {

/// The isolators of a building: lead-rubber bearings, an Isolator with any law, or the law itself, also one of the
/// script's own.
///
///     .isolation = LeadRubberBearing{...}
///     .isolation = Isolator{.name = "pendulums", .law = MyPendulum{...}}
///     .isolation = MyPendulum{...}                  named "bearings"
///
/// The building puts them between the ground and its base; `lower` and `upper` must not be given.
class Isolation {
 public:
  Isolation(LeadRubberBearing bearing) { take(std::move(bearing)); }
  template <ForceLaw Law>
  Isolation(Isolator<Law> isolator) {
    take(std::move(isolator));
  }
  template <ForceLaw Law>
  Isolation(Law law) {
    take(Isolator<Law>{.law = std::move(law)});
  }

  /// Adds them below `base`, with their name behind `prefix`. Throws InputError as the element would.
  void add_to(Model& model, const std::string& prefix, NodeId base) const { add_(model, prefix, base); }
  /// Whether ends are given, which the building sets.
  [[nodiscard]] bool has_lower() const { return has_lower_; }
  [[nodiscard]] bool has_upper() const { return has_upper_; }

 private:
  template <class Element>
  void take(Element element) {
    has_lower_ = element.lower != ground;
    has_upper_ = element.upper.specified();
    add_ = [element](Model& model, const std::string& prefix, NodeId base) {
      Element placed = element;
      placed.name = prefix + placed.name;
      placed.lower = ground;
      placed.upper = base;
      add(model, placed);
    };
  }

  std::function<void(Model&, const std::string& prefix, NodeId base)> add_;
  bool has_lower_ = false, has_upper_ = false;
};

}  // namespace moat
