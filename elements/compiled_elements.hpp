// Elements with moat's own laws that are compiled in the library, so that a script with them compiles faster.
#pragma once

#include "elements/line/isolator.hpp"
#include "elements/plan/plan_spring.hpp"
#include "elements/plan/planar_spring.hpp"
#include "materials/linear.hpp"
#include "materials/plan/planar_laws.hpp"
#include "materials/spring_laws.hpp"
#include "materials/viscous.hpp"
#include "model/model.hpp"

namespace moat {

extern template void add(Model&, const Isolator<BoucWen>&);
extern template void add(Model&, const Isolator<DoublePendulum>&);
extern template void add(Model&, const Isolator<FlatSlider>&);
extern template void add(Model&, const Isolator<FrictionPendulum>&);
extern template void add(Model&, const Isolator<GrantRubber>&);
extern template void add(Model&, const Isolator<HeatedFrictionPendulum>&);
extern template void add(Model&, const Isolator<HeatedLeadRubber>&);
extern template void add(Model&, const Isolator<KikuchiAikenRubber>&);
extern template void add(Model&, const Isolator<StiffeningSpring>&);
extern template void add(Model&, const Isolator<TriplePendulum>&);

extern template void add(Model&, const PlanarSpring<BiaxialBilinear>&);
extern template void add(Model&, const PlanarSpring<BiaxialBoucWen>&);
extern template void add(Model&, const PlanarSpring<BiaxialFrictionPendulum>&);
extern template void add(Model&, const PlanarSpring<BiaxialGrantRubber>&);
extern template void add(Model&, const PlanarSpring<BiaxialLinear>&);
extern template void add(Model&, const PlanSpring<Linear>&);
extern template void add(Model&, const PlanSpring<Viscous>&);

}  // namespace moat
