// The tables of isolators, dampers, storeys and soil in the guide.
#pragma once

#include <set>
#include <string>

namespace moat::testing {

/// One table for each folder of laws, with a row for every law of AllSpringLaws.
std::string spring_law_tables();

/// The headers in the folders of laws, without .hpp; and the laws of AllSpringLaws under such names.
std::set<std::string> spring_law_headers();
std::set<std::string> spring_law_names();

}  // namespace moat::testing
