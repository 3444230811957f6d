// A stiffness is given in the place of a mass.
#include "base/units.hpp"

using namespace moat;
using namespace moat::units;

struct Floor {
  Mass mass;
};

#ifdef MOAT_CORRECTED
const Floor floor_1{.mass = 500 * tonne};
#else
const Floor floor_1{.mass = 1 * GN / m};
#endif
