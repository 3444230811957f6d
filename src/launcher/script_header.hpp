// <moat.hpp>, precompiled for scripts.
#pragma once

#include <filesystem>

#include "launcher/places.hpp"
#include "launcher/process.hpp"

namespace moat::launcher {

/// The precompiled header of a checkout, which is built with the library. An installed package has none: it is made at
/// the first script, in <work>/script_header, and again after the package or the compiler was installed again;
/// `compile` then gets this folder in front of its own. Empty where the compiler makes none.
std::filesystem::path precompiled_header(const Places& places, Command& compile);

}  // namespace moat::launcher
