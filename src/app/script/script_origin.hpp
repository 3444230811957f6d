// Where the results of a script come from, and the inputs on which the numbers of its studies depend.
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "app/command_line.hpp"
#include "output/files/provenance.hpp"
#include "study/file/store.hpp"

namespace moat {

/// Version, commit, date, and the command line of this process. The launcher gives the path of the script's source in
/// the environment variable MOAT_SCRIPT; without it path and hash of the program stand in its place.
Provenance origin_of_script(const std::vector<std::string>& arguments);

/// The command that goes on with a study of this process, on the same number of ranks, for a shell in any folder:
///
///     cd /home/me && /opt/moat/moat run --ranks 4 /home/me/gap.cpp --out 'my study'
///
/// The launcher gives its own path in MOAT_LAUNCHER; without it the program itself is named. ranks: 0 for a process by
/// itself. --retry and --accept-changes are left out: they have been done.
std::string command_to_go_on(const std::vector<std::string>& arguments, int ranks);

/// The command that goes on with a single run of this process from the checkpoint in its results folder.
std::string command_to_resume(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// Hashes of script, program and library; the values of all options; hashes of the files that options name and of those
/// that moat has read outside of cases. An option whose value is a file or folder that exists counts with its absolute
/// path, however it was written. left_out: options of moat on which no number depends; a script may own any other
/// name.
StudyIdentity identity_of_script(const CommandLine& line, const Provenance& origin,
                                 const std::set<std::string>& left_out);

}  // namespace moat
