// Two quantities of different dimension are added.
#include "base/units.hpp"

using namespace moat;
using namespace moat::units;

#ifdef MOAT_CORRECTED
const Length sum = 10 * cm + 2 * m;
#else
const auto sum = 10 * cm + 2 * s;
#endif
