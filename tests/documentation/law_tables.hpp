// The tables of laws in the guide.
#pragma once

#include <string>

namespace moat::testing {

/// One table for each form of contact, with a row for every law of AllImpactLaws.
std::string impact_law_tables();

/// One table for each folder of other laws, with a row for every law of AllSpringLaws.
std::string spring_law_tables();

}  // namespace moat::testing
