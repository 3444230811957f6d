// Whether the library must be looked at.
#pragma once

#include <filesystem>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Whether a source of the library, the commit, a list of the build or the built library changed or went away since
/// `stamp` was written. It looks at dates alone, which takes a tenth of the time in which Ninja reads its lists.
bool library_may_have_changed(const Places& places, const std::filesystem::path& stamp);

}  // namespace moat::launcher
