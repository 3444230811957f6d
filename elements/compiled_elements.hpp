// Blocks of laws that are compiled in the library, so that a script with such laws compiles faster.
#pragma once

#include "elements/link_block.hpp"
#include "elements/plan_ends.hpp"
#include "elements/planar_block.hpp"
#include "materials/biaxial_bilinear.hpp"
#include "materials/biaxial_bouc_wen.hpp"
#include "materials/biaxial_friction_pendulum.hpp"
#include "materials/biaxial_grant_rubber.hpp"
#include "materials/heated_sliding_isolator.hpp"
#include "materials/isolation/bouc_wen.hpp"
#include "materials/isolation/grant_rubber.hpp"
#include "materials/isolation/heated_lead_rubber.hpp"
#include "materials/isolation/kikuchi_aiken_rubber.hpp"
#include "materials/isolation/stiffening_spring.hpp"
#include "materials/linear.hpp"
#include "materials/repeated.hpp"
#include "materials/series_of_sliders.hpp"
#include "materials/sliding_isolator.hpp"
#include "materials/viscous.hpp"
#include "model/model.hpp"

namespace moat {

// Where a block is made, all its functions are compiled.
extern template LinkBlock<BoucWen>& Model::block();
extern template LinkBlock<Repeated<BoucWen>>& Model::block();
extern template LinkBlock<GrantRubber>& Model::block();
extern template LinkBlock<Repeated<GrantRubber>>& Model::block();
extern template LinkBlock<HeatedLeadRubber>& Model::block();
extern template LinkBlock<Repeated<HeatedLeadRubber>>& Model::block();
extern template LinkBlock<HeatedSlidingIsolator>& Model::block();
extern template LinkBlock<Repeated<HeatedSlidingIsolator>>& Model::block();
extern template LinkBlock<KikuchiAikenRubber>& Model::block();
extern template LinkBlock<Repeated<KikuchiAikenRubber>>& Model::block();
extern template LinkBlock<SeriesOfSliders>& Model::block();
extern template LinkBlock<Repeated<SeriesOfSliders>>& Model::block();
extern template LinkBlock<SlidingIsolator>& Model::block();
extern template LinkBlock<Repeated<SlidingIsolator>>& Model::block();
extern template LinkBlock<StiffeningSpring>& Model::block();
extern template LinkBlock<Repeated<StiffeningSpring>>& Model::block();

extern template PlanarBlock<BiaxialBilinear>& Model::block();
extern template PlanarBlock<BiaxialBoucWen>& Model::block();
extern template PlanarBlock<BiaxialFrictionPendulum>& Model::block();
extern template PlanarBlock<BiaxialGrantRubber>& Model::block();
extern template LinkBlock<Linear, PlanEnds>& Model::block();
extern template LinkBlock<Viscous, PlanEnds>& Model::block();

}  // namespace moat
