#include "performance/equal_accuracy.hpp"

namespace moat::performance {

void equal_accuracy(Record& record, const Options&) { record.section("equal-accuracy", "Equal accuracy"); }

}  // namespace moat::performance
