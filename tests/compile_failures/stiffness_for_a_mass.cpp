// A stiffness is given where a mass is asked for.
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
