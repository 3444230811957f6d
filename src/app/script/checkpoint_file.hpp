// The checkpoint of a run on disk.
#pragma once

#include <filesystem>
#include <functional>

#include "base/state_archive.hpp"
#include "study/file/store.hpp"

namespace moat {

/// Writes the identity of a script's run (identity_of_script) and its state, with their checksum, whole or not at all.
/// Throws FileError where it cannot.
void write_checkpoint(const std::filesystem::path& path, StudyIdentity identity,
                      const std::function<void(StateArchive&)>& write_state);

/// Returns the state, to read. Throws InputError where there is none, it is damaged, it has another format, or its
/// identity is another one: the message says which parts differ.
StateArchive read_checkpoint(const std::filesystem::path& path, const StudyIdentity& identity);

}  // namespace moat
