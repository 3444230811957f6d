#include "model/element_block.hpp"

namespace moat {

void ElementBlock::scan_regimes(double, RegimeScan&) const {}

void ElementBlock::change_regimes(std::size_t, std::vector<RegimeChange>&) {}

bool ElementBlock::change_regimes_inside(double, double, std::size_t, std::vector<RegimeChange>&) { return true; }

void ElementBlock::open_gaps(std::size_t, std::vector<RegimeChange>&) {}

double ElementBlock::delivered_restitution(std::size_t, double) const {
  return std::numeric_limits<double>::quiet_NaN();
}

ContactView ElementBlock::contact(std::size_t) const { return {}; }

}  // namespace moat
