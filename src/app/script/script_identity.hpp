// The inputs on which the numbers of a script's studies depend.
#pragma once

#include "app/command_line.hpp"
#include "output/files/provenance.hpp"
#include "study/file/study_version.hpp"

namespace moat {

/// Hashes of script, program and library; the values of all options; hashes of the files that options name and of those
/// that moat has read outside of cases. An option whose value is a file or folder that exists counts with its absolute
/// path, however it was written.
StudyIdentity identity_of_script(const CommandLine& line, const Provenance& origin);

}  // namespace moat
