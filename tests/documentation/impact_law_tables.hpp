// The tables of impact laws in the guide.
#pragma once

#include <string>

namespace moat::testing {

/// One table for each form of contact, with a row for every law of AllImpactLaws.
std::string impact_law_tables();

}  // namespace moat::testing
