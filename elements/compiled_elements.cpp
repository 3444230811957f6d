#include "elements/compiled_elements.hpp"

namespace moat {

template void add(Model&, const Isolator<BoucWen>&);
template void add(Model&, const Isolator<DoublePendulum>&);
template void add(Model&, const Isolator<FlatSlider>&);
template void add(Model&, const Isolator<FrictionPendulum>&);
template void add(Model&, const Isolator<GrantRubber>&);
template void add(Model&, const Isolator<HeatedFrictionPendulum>&);
template void add(Model&, const Isolator<HeatedLeadRubber>&);
template void add(Model&, const Isolator<KikuchiAikenRubber>&);
template void add(Model&, const Isolator<StiffeningSpring>&);
template void add(Model&, const Isolator<TriplePendulum>&);

template void add(Model&, const PlanarSpring<BiaxialBilinear>&);
template void add(Model&, const PlanarSpring<BiaxialBoucWen>&);
template void add(Model&, const PlanarSpring<BiaxialFrictionPendulum>&);
template void add(Model&, const PlanarSpring<BiaxialGrantRubber>&);
template void add(Model&, const PlanarSpring<BiaxialLinear>&);
template void add(Model&, const PlanSpring<Linear>&);
template void add(Model&, const PlanSpring<Viscous>&);

}  // namespace moat
