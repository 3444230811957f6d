// All laws of two components.
#pragma once

#include "materials/law_list.hpp"
#include "materials/plan/biaxial_bilinear.hpp"
#include "materials/plan/biaxial_bouc_wen.hpp"
#include "materials/plan/biaxial_friction_pendulum.hpp"
#include "materials/plan/biaxial_grant_rubber.hpp"
#include "materials/plan/biaxial_linear.hpp"
#include "materials/plan/planar_heated_pendulum.hpp"
#include "materials/plan/planar_series_of_sliders.hpp"
#include "materials/plan/planar_slider_under_weight.hpp"

namespace moat {

/// Every law of two components. A law in this list passes the tests of all of them. CONTRIBUTING.md shows how to add
/// one.
using AllPlanarLaws =
    LawList<BiaxialBilinear, BiaxialBoucWen, BiaxialFrictionPendulum, BiaxialGrantRubber, BiaxialLinear,
            Carrying<PlanarHeatedPendulum>, Carrying<PlanarSeriesOfSliders>, Carrying<PlanarSliderUnderWeight>>;

}  // namespace moat
