// A field that has no sensible default is left out.
#include "base/required.hpp"
#include "base/units.hpp"

using namespace moat;
using namespace moat::units;

struct Node {
  const char* name = "";
  Required<Mass> mass;
};

#ifdef MOAT_CORRECTED
const Node node{.name = "base", .mass = 550 * tonne};
#else
const Node node{.name = "base"};
#endif
