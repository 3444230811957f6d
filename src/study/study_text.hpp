// A stored study in words.
#pragma once

#include <string>

#include "study/file/store.hpp"

namespace moat {

/// Title, axes, progress, failures with their reasons, slowest cases and sessions, for the terminal.
std::string description_of(const StoredStudy& study);

/// The responses of every case (responses_of()) in columns, six at most. Empty for studies of more than 24 cases.
std::string case_lines(const StudyResult& study);

}  // namespace moat
