// Libraries of moat that are loaded only where they are used.
#pragma once

#include <string>

namespace moat {

/// The function of this name in a library that lies beside that of moat, and that is loaded at the first call. Throws
/// InputError where there is none: `failure`, the reason of the system, and `remedy`.
void* loaded_function(const std::string& library, const char* function, const std::string& failure,
                      const std::string& remedy);

}  // namespace moat
