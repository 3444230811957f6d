#include "elements/line/compiled_elements.hpp"

namespace moat {

template void add(Model&, const PlanarSpring<BiaxialBilinear>&);
template void add(Model&, const PlanarSpring<BiaxialBoucWen>&);
template void add(Model&, const PlanarSpring<BiaxialFrictionPendulum>&);
template void add(Model&, const PlanarSpring<BiaxialGrantRubber>&);
template void add(Model&, const PlanBearing<BiaxialBilinear>&);
template void add(Model&, const PlanBearing<BiaxialBoucWen>&);
template void add(Model&, const PlanBearing<BiaxialFrictionPendulum>&);
template void add(Model&, const PlanBearing<BiaxialGrantRubber>&);
template void add(Model&, const PlanSpring<Linear>&);
template void add(Model&, const PlanSpring<Viscous>&);

}  // namespace moat
