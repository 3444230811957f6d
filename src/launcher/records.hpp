// The folder of recorded ground motions.
#pragma once

#include <string>

namespace moat::launcher {

/// Makes the folder that the environment variable MOAT_RECORDS names absolute, since programs may run in folders of
/// their own. Returns false if it is not set. Throws Stop, with a hint at the help of `command`, if there is no such
/// folder.
bool find_records(const std::string& command);

}  // namespace moat::launcher
