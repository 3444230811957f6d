#include "elements/line/compiled_elements.hpp"

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

}  // namespace moat
