// A number without a unit is given in the place of a length.
#include "base/units.hpp"

using namespace moat;
using namespace moat::units;

struct Wall {
  Length clearance;
};

#ifdef MOAT_CORRECTED
const Wall wall{.clearance = 0.95 * m};
#else
const Wall wall{.clearance = 0.95};
#endif
