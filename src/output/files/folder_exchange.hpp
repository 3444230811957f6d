// Files of moat and of others in results folders, their list, and the exchange of two folders.
#pragma once

#include <sys/file.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>

namespace moat {

/// Where a results folder cannot be used. Throws FileError.
[[noreturn]] void refuse_folder(const std::filesystem::path& path, const std::string& problem,
                                const std::string& reason);

/// Begins the file `unfinished`.
inline constexpr const char* about_unfinished = "moat computes here, or was killed before its results were complete.\n";

/// Whether there is anything of this name; links are not followed.
bool is_there(const std::filesystem::path& path);
bool is_link(const std::filesystem::path& path);         ///< Also true without a target.
std::string text_in(const std::filesystem::path& path);  ///< Empty where there is no such file.

/// Opens a file and locks it until the returned descriptor is closed. -1 with errno where that cannot be: ENOENT or
/// ESTALE where the file was removed or replaced meanwhile. The kernel gives up the lock of a program that was killed.
int lock_file(const std::filesystem::path& path, int how_to_lock = LOCK_EX | LOCK_NB, int how_to_open = 0);

/// Whether moat computes in a folder, or was killed there. The mark is empty for a moment, and on a full disk.
bool is_unfinished(const std::filesystem::path& folder);
/// Whether the list of files stands in a folder: its results are complete.
bool has_list(const std::filesystem::path& folder);
/// Lists all files that have names of results. Throws FileError.
void write_list(const std::filesystem::path& folder);
/// Waits until all that was written to the file system of a folder is on the disk: one call is faster than one for each
/// of hundreds of files. Throws FileError.
void wait_for_disk(const std::filesystem::path& folder);

/// Paths of the files that moat wrote there, relative to the folder: those of the list, or after a run that was killed
/// all that have names of results; links of such names, which are not followed; list and mark. Null where moat did not
/// write there.
std::optional<std::set<std::filesystem::path>> files_of_moat(const std::filesystem::path& folder);

/// Gives the files in `from` that moat did not write to the folder `to` as well, as hard links. Returns false where
/// that cannot be: new results have such a name, or the file system has no links.
bool link_foreign_files(const std::filesystem::path& from, const std::filesystem::path& to);
/// Removes the files that moat wrote into a folder, and others that `kept` has too; then empty folders. The list and
/// the mark go last, so that a run that was killed can go on.
void remove_results(const std::filesystem::path& folder, const std::filesystem::path& kept);

/// Two folders change their names at one moment. File systems that cannot do this, such as NFS, rename `second` to
/// "<first>.old" in between. Returns false where nothing could be renamed. Throws FileError where old results keep that
/// name.
bool exchange_folders(const std::filesystem::path& first, const std::filesystem::path& second);
/// Gives "<first>.old" of a run that was killed in between its old name, or that of `first` where `second` is new.
void restore_name(const std::filesystem::path& first, const std::filesystem::path& second);

}  // namespace moat
