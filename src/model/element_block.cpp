#include "model/element_block.hpp"

namespace moat {

void ElementBlock::scan_regimes(double, RegimeScan&) const {}

void ElementBlock::change_regimes(std::size_t, std::vector<RegimeChange>&) {}

ContactView ElementBlock::contact(std::size_t) const { return {}; }

}  // namespace moat
