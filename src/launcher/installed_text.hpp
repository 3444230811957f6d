// Texts of the launcher in an installed package.
#pragma once

#include <string>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Texts are written for a checkout: "./moat run examples/...". In an installed package the command is `moat`, and the
/// examples get their whole path. A text of a checkout stays as it is.
std::string as_installed(const std::string& text, const Places& places);

}  // namespace moat::launcher
