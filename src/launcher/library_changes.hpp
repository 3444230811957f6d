// Whether the library must be looked at.
#pragma once

#include <filesystem>

#include "launcher/places.hpp"

namespace moat::launcher {

/// Whether a source of the library, the commit, a list of the build, or the set of files in the folders of the built
/// library changed since `stamp` was written, or there is no stamp. It looks at dates alone: a script that starts need
/// not wait until Ninja has read the lists of the whole build. The folders of sources must exist.
bool library_may_have_changed(const Places& places, const std::filesystem::path& stamp);

}  // namespace moat::launcher
