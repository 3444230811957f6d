// All laws of isolators, dampers, storeys and soil.
#pragma once

#include "materials/dampers/maxwell_damper.hpp"
#include "materials/dampers/nonlinear_viscous.hpp"
#include "materials/isolation/bouc_wen.hpp"
#include "materials/isolation/double_pendulum.hpp"
#include "materials/isolation/flat_slider.hpp"
#include "materials/isolation/friction_pendulum.hpp"
#include "materials/isolation/grant_rubber.hpp"
#include "materials/isolation/heated_friction_pendulum.hpp"
#include "materials/isolation/heated_lead_rubber.hpp"
#include "materials/isolation/kikuchi_aiken_rubber.hpp"
#include "materials/isolation/stiffening_spring.hpp"
#include "materials/isolation/triple_pendulum.hpp"
#include "materials/law_list.hpp"
#include "materials/soil/hyperbolic_backfill.hpp"
#include "materials/storeys/baber_noori.hpp"
#include "materials/storeys/imk_bilinear.hpp"
#include "materials/storeys/p_delta.hpp"
#include "materials/storeys/yielding_storey.hpp"

namespace moat {

/// Every law of isolators, dampers, storeys and soil with a folder of its own, in the order of the guide. A law in this
/// list stands in the table of docs/reference/isolators_and_storeys.md. CONTRIBUTING.md shows how to add one.
using AllSpringLaws =
    LawList<BoucWen, HeatedLeadRubber, GrantRubber, KikuchiAikenRubber, FrictionPendulum, HeatedFrictionPendulum,
            DoublePendulum, TriplePendulum, FlatSlider, StiffeningSpring, NonlinearViscous, MaxwellDamper,
            YieldingStorey, BaberNoori, ImkBilinear, PDelta, HyperbolicBackfill>;

}  // namespace moat
