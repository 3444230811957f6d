// All impact laws.
#pragma once

#include "materials/impact/bilinear_impact.hpp"
#include "materials/impact/exact_hertz_damp.hpp"
#include "materials/impact/exact_kelvin.hpp"
#include "materials/impact/gonthier.hpp"
#include "materials/impact/hertz.hpp"
#include "materials/impact/hertz_damp.hpp"
#include "materials/impact/hu_guo.hpp"
#include "materials/impact/hunt_crossley.hpp"
#include "materials/impact/kelvin.hpp"
#include "materials/impact/kelvin_by_damping_ratio.hpp"
#include "materials/impact/linear_elastic.hpp"
#include "materials/impact/modified_hertz_damp_printed.hpp"
#include "materials/impact/modified_linear_viscoelastic.hpp"
#include "materials/impact/nonlinear_viscoelastic.hpp"
#include "materials/impact/ye_2009.hpp"
#include "materials/law_list.hpp"

namespace moat {

/// Every impact law, in the order of the guide. A law in this list has its name in NamedImpactLaw, passes the tests of
/// all laws, and stands in the table of docs/reference/impact_laws.md. CONTRIBUTING.md shows how to add one.
using AllImpactLaws = LawList<Hertz, HertzDamp, HuntCrossley, Gonthier, Ye2009, HuGuo, ExactHertzDamp,
                              NonlinearViscoelastic, ModifiedHertzDampPrinted, LinearElastic, Kelvin,
                              KelvinByDampingRatio, ModifiedLinearViscoelastic, ExactKelvin, BilinearImpact>;

}  // namespace moat
