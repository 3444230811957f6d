// moat doctor
#pragma once

#include "launcher/places.hpp"

namespace moat::launcher {

/// Prints what is installed and what is missing. Returns 1 if a package is missing that moat cannot do without.
int doctor(const Places& places);

}  // namespace moat::launcher
