#include "elements/compiled_blocks.hpp"

namespace moat {

template PlanarBlock<BiaxialBilinear>& Model::block();
template PlanarBlock<BiaxialBoucWen>& Model::block();
template PlanarBlock<BiaxialFrictionPendulum>& Model::block();
template PlanarBlock<BiaxialGrantRubber>& Model::block();
template LinkBlock<Linear, PlanEnds>& Model::block();
template LinkBlock<Viscous, PlanEnds>& Model::block();

}  // namespace moat
