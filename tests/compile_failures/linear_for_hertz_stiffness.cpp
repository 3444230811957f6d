// N/m is given in the place of N/m^1.5, the unit of a Hertz contact.
#include "base/units.hpp"

using namespace moat;
using namespace moat::units;

struct Contact {
  HertzStiffness stiffness;
};

#ifdef MOAT_CORRECTED
const Contact contact{.stiffness = 2.95e9 * N / m_3_2};
#else
const Contact contact{.stiffness = 2.95e9 * N / m};
#endif
