// Where the results of a script come from.
#pragma once

#include <string>
#include <vector>

#include "output/provenance.hpp"

namespace moat {

/// Version, commit, date, and the command line of this process. The launcher gives the path of the script's source in
/// the environment variable MOAT_SCRIPT; without it the path of the program stands in its place, without hash.
Provenance origin_of_script(const std::vector<std::string>& arguments);

}  // namespace moat
