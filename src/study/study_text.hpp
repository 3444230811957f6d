// A stored study in words.
#pragma once

#include <string>

#include "study/file/store.hpp"

namespace moat {

/// Title, axes, progress, failures with their reasons, slowest cases and sessions, for the terminal.
std::string description_of(const StoredStudy& study);

}  // namespace moat
