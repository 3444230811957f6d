// moat doctor
#pragma once

#include "launcher/places.hpp"

namespace moat::launcher {

/// Prints installed and missing packages. Returns 1 if a package is missing that moat needs.
int doctor(const Places& places);

}  // namespace moat::launcher
