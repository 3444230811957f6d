#include "structures/plan_storeys.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "elements/plan/plan_spring.hpp"
#include "elements/plan/rotation_link.hpp"
#include "materials/linear.hpp"
#include "materials/viscous.hpp"

namespace moat {
namespace {

// A law between two floors, at a place along a direction.
template <class Law>
PlanSpring<Law> unreported(const std::string& name, NodeId lower, NodeId upper, PlanPosition at, PlanVector direction,
                           const Law& law) {
  return {.name = name,
          .lower = PlanPoint{lower, at},
          .upper = PlanPoint{upper, at},
          .direction = direction,
          .law = law,
          .deformation_quantity = "",
          .force_quantity = ""};
}

// The forces of springs between two floors that are sums over their displacements: each spring counts with a factor.
class StoreyForce {
 public:
  StoreyForce(const Model& model, NodeId lower, DiaphragmId upper) : model_{model}, lower_{lower}, upper_{upper} {}

  void add(const StoreySpring& spring, double factor) {
    for (const auto& [body, sign] : {std::pair{lower_, -1.0}, {upper_.x, 1.0}}) {
      const PlacedDiaphragm* floor = body == ground ? nullptr : model_.diaphragm_of(body);
      if (floor == nullptr) continue;
      const PlanVector arm = PlanVector{spring.at.x.si(), spring.at.y.si()} - floor->centre_of_mass;
      const double force = sign * factor * spring.stiffness;
      weights_[floor->id.x] += force * spring.direction.x;
      weights_[floor->id.y] += force * spring.direction.y;
      weights_[floor->id.r] += force * (spring.turns() ? 1.0 : cross(arm, spring.direction)) / floor->gyration;
    }
  }
  void append_to(std::vector<MotionShare>& list, double factor) const {
    for (const auto& [node, weight] : weights_) list.push_back({node, factor * weight});
  }
  [[nodiscard]] std::vector<MotionShare> shares() const {
    std::vector<MotionShare> list;
    append_to(list, 1.0);
    return list;
  }

 private:
  const Model& model_;
  NodeId lower_;
  DiaphragmId upper_;
  std::map<NodeId, double> weights_;
};

}  // namespace

std::vector<StoreySpring> springs_of_storey(const Check& check, const PlanColumns& columns, const PlanOutline& outline,
                                            const std::string& storey) {
  std::vector<StoreySpring> springs;
  const auto add_both = [&](PlanPosition at, Stiffness x, Stiffness y, const std::string& name) {
    if (x.si() > 0.0) springs.push_back({name + " x", x.si(), at, {1.0, 0.0}});
    if (y.si() > 0.0) springs.push_back({name + " y", y.si(), at, {0.0, 1.0}});
  };
  if (const StoreyStiffness* whole = columns.whole()) {
    check.positive(storey + " columns.x", whole->x);
    check.positive(storey + " columns.y", whole->y);
    check.positive(storey + " columns.rotation", whole->rotation.si(), "N m/rad");
    add_both(whole->centre_of_rigidity, whole->x, whole->y, storey);
    springs.push_back({storey + " rotation", whole->rotation.si()});
    return springs;
  }
  int number = 0;
  for (const ColumnLine& line : columns.lines(check, outline)) {
    const std::string name = storey + " column " + std::to_string(++number);
    check.that(line.column.stiffness == Stiffness{} ||
                   (line.column.stiffness_x == Stiffness{} && line.column.stiffness_y == Stiffness{}),
               name + ": stiffness is given, and stiffness_x or stiffness_y too.",
               "Give one for both directions, or each.");
    check.not_negative(name + " stiffness along x", line.column.along_x());
    check.not_negative(name + " stiffness along y", line.column.along_y());
    add_both(line.at, line.column.along_x(), line.column.along_y(), name);
  }
  return springs;
}

void add_springs(Model& model, const PlanStorey& storey) {
  for (const StoreySpring& spring : storey.springs) {
    if (spring.turns())
      add(model, RotationSpring{spring.name, storey.lower, storey.upper, Energy{spring.stiffness}});
    else
      add(model, unreported(spring.name, storey.lower, storey.upper, spring.at, spring.direction,
                            Linear{.stiffness = Stiffness{spring.stiffness}}));
  }
}

void add_dashpots(Model& model, const PlanStorey& storey, double factor) {
  for (const StoreySpring& spring : storey.springs) {
    const std::string name = spring.name + " damping";
    const double damping = factor * spring.stiffness;
    if (spring.turns())
      add(model, RotationDamper{name, storey.lower, storey.upper, Quantity<1, 4, -1>{damping}});
    else
      add(model, unreported(name, storey.lower, storey.upper, spring.at, spring.direction,
                            Viscous{.damping = DampingCoefficient{damping}}));
  }
}

void add_mass_damping(Model& model, NodeId base, DiaphragmId id, double factor) {
  const PlacedDiaphragm floor = model.diaphragm(id);
  const PlanPosition centre{Length{floor.centre_of_mass.x}, Length{floor.centre_of_mass.y}};
  const std::string name = floor.name + " damping";
  for (const auto& [component, direction] :
       {std::pair{" x", PlanVector{1.0, 0.0}}, std::pair{" y", PlanVector{0.0, 1.0}}})
    add(model, unreported(name + component, base, floor.id, centre, direction,
                          Viscous{.damping = DampingCoefficient{factor * floor.mass}}));
  add(model, RotationDamper{name + " rotation", base, floor.id,
                            Quantity<1, 4, -1>{factor * floor.mass * floor.gyration * floor.gyration}});
}

std::vector<StoreyResult> storey_results(const Model& model, const std::vector<PlanStorey>& storeys,
                                         PlanVector origin) {
  std::vector<StoreyResult> results;
  std::vector<MotionShare> moment_x, moment_y;
  for (std::size_t i = storeys.size(); i-- > 0;) {
    const PlanStorey& storey = storeys[i];
    StoreyForce shear_x{model, storey.lower, storey.upper}, shear_y = shear_x, torque = shear_x;
    for (const StoreySpring& spring : storey.springs) {
      const PlanVector arm = PlanVector{spring.at.x.si(), spring.at.y.si()} - origin;
      shear_x.add(spring, spring.direction.x);
      shear_y.add(spring, spring.direction.y);
      torque.add(spring, spring.turns() ? 1.0 : cross(arm, spring.direction));
    }
    shear_x.append_to(moment_x, storey.height);
    shear_y.append_to(moment_y, storey.height);
    const auto add = [&](const char* quantity, const char* unit, std::vector<MotionShare> shares) {
      results.push_back({.quantity = quantity, .place = storey.name, .unit = unit, .displacements = std::move(shares)});
    };
    add("overturning_moment_y", "N m", moment_y);
    add("overturning_moment_x", "N m", moment_x);
    add("storey_torque", "N m", torque.shares());
    add("storey_shear_y", "N", shear_y.shares());
    add("storey_shear_x", "N", shear_x.shares());
  }
  std::ranges::reverse(results);
  return results;
}

}  // namespace moat
