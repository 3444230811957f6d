#include "output/files/results_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <climits>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "output/files/file_io.hpp"
#include "output/files/provenance.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const fs::path& path, const std::string& what, const std::string& reason) {
  throw FileError{"results folder " + path.string() + ": " + what + " (" + reason +
                  "). Choose another folder, or make this one writable."};
}

/// True if this call made the folder, so that two programs started together never share one.
bool create(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  const bool is_new = !error && fs::create_directory(path, error);
  if (error) fail(path, "cannot be created", error.message());
  return is_new;
}

std::size_t entries_in(const fs::path& folder) {
  std::error_code error;
  const auto count = std::distance(fs::directory_iterator{folder, error}, {});
  if (error) fail(folder, "cannot be read", error.message());
  return static_cast<std::size_t>(count);
}

/// Paths of the files that moat may have written there, relative to the folder. Links are not followed.
std::vector<fs::path> files_in(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error)) {
    const fs::path name = entry->path().lexically_relative(folder);
    const auto begins = [&](const char* known) { return *name.begin() == known; };
    if ((entry->is_symlink() || !entry->is_directory()) && name != results_file::unfinished &&
        std::ranges::any_of(results_file::all_names, begins))
      found.push_back(name);
  }
  if (error) fail(folder, "cannot be read", error.message());
  return found;
}

bool is_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(fs::symlink_status(path, error));
}

/// Removes one of these files (of a link not its target), and the folder above it where that is empty then.
void remove_file(const fs::path& folder, const fs::path& name) {
  std::error_code error, not_empty;
  fs::remove(folder / name, error);
  if (error) fail(folder / name, "cannot be removed", error.message());
  if (name.has_parent_path()) fs::remove((folder / name).parent_path(), not_empty);
}

std::string text_in(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

constexpr std::string_view about_unfinished = "moat computes here, or was killed before its results were complete.\n";
constexpr std::string_view about_files =
    "moat wrote these files. Overwriting the results replaces them and no others.\n";

/// Whether moat computes in a folder, or was killed there. The mark is empty for a moment, and on a full disk.
bool is_unfinished(const fs::path& folder) {
  std::error_code error;
  const fs::path mark = folder / results_file::unfinished;
  return fs::is_regular_file(fs::symlink_status(mark, error)) &&
         (fs::is_empty(mark, error) || text_in(mark).starts_with(about_unfinished));
}

/// The files that moat wrote into a folder: those that it listed, or after a run that was killed all that have their
/// places. None where moat did not write there.
std::optional<std::vector<fs::path>> files_of_moat(const fs::path& folder) {
  const std::string list = text_in(folder / results_file::list);
  if (!list.starts_with(about_files)) return is_unfinished(folder) ? std::optional{files_in(folder)} : std::nullopt;
  std::vector<fs::path> files = files_in(folder);
  std::erase_if(files, [&](const fs::path& name) { return list.find("\n" + name.string() + "\n") == list.npos; });
  return files;
}

/// Makes or takes the file `unfinished`, and locks it until the returned descriptor is closed; -1 where another run has
/// it. The kernel gives up the lock of a program that was killed.
int mark(const fs::path& folder, const std::string& command, int flags = 0) {
  const fs::path path = folder / results_file::unfinished;
  if (std::error_code error; is_link(path)) fs::remove(path, error);
  const int file = open(path.c_str(), O_WRONLY | O_CREAT | O_NOFOLLOW | O_CLOEXEC | flags, 0666);
  if (file < 0 && errno != EEXIST && errno != ENOENT) fail(folder, "cannot be written to", std::strerror(errno));
  struct stat locked {
  }, present{};
  // The run that had it may have ended meanwhile, and removed it.
  if (file < 0 || (flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) || fstat(file, &locked) != 0 ||
      stat(path.c_str(), &present) != 0 || locked.st_ino != present.st_ino) {
    close(file);
    return -1;
  }
  std::array<char, HOST_NAME_MAX + 1> host{};
  gethostname(host.data(), host.size() - 1);
  if (ftruncate(file, 0) == 0)
    dprintf(file, "%scommand: %s\nhost: %s\nprocess: %d\nstart: %s\n", about_unfinished.data(), command.c_str(),
            host.data(), getpid(), provenance_of_library().date.c_str());
  return file;
}

/// Takes an empty folder, as mark() does.
int claim(const fs::path& folder, const std::string& command) {
  const int file = entries_in(folder) == 0 ? mark(folder, command, O_EXCL) : -1;
  // A whole run may have come between.
  if (file < 0 || entries_in(folder) == 1) return file;
  std::error_code error;
  fs::remove(folder / results_file::unfinished, error);
  close(file);
  return -1;
}

/// `wanted` without a slash at its end, and with its own name where it ends in . or ..
fs::path with_name(fs::path wanted) {
  // "results/x/" would otherwise become "results/x/_2", and "." a hidden "._2".
  if (!wanted.empty() && !wanted.has_filename()) wanted = wanted.parent_path();
  if (wanted.empty()) throw InputError{"results folder: the path is empty. Give a folder, for example results/run."};
  if (wanted.filename() == "." || wanted.filename() == "..") {
    std::error_code error;
    wanted = fs::weakly_canonical(wanted, error);
    if (error) fail(wanted, "cannot be read", error.message());
  }
  if (!wanted.has_filename())
    throw InputError{"results folder " + wanted.string() +
                     ": this is the root of all folders. Give a folder in it, for example results/run."};
  return wanted;
}

/// The first of results_2, results_3 ... that does not exist, and that `take` gets.
fs::path next_number(const fs::path& results, const std::function<bool(const fs::path&)>& take) {
  for (int number = 2;; ++number) {
    fs::path numbered = results;
    numbered += "_" + std::to_string(number);
    std::error_code error;
    if (!fs::exists(fs::symlink_status(numbered, error)) && take(numbered)) return numbered;
  }
}

}  // namespace

ResultsFolder::ResultsFolder(const fs::path& wanted, WhenFolderExists when_exists, const std::string& command)
    : final_{with_name(wanted)} {
  create(final_);
  mark_ = claim(final_, command);
  if (mark_ >= 0) return;
  if (when_exists == WhenFolderExists::overwrite) {
    if (!files_of_moat(final_))
      throw InputError{"results folder " + final_.string() + " has no list of files that moat wrote (" +
                       results_file::list + "), and is not replaced. Choose another folder, or remove this one."};
    make_folder_beside(command);
    return;
  }
  final_ = next_number(final_, [&](const fs::path& numbered) {
    if (create(numbered)) mark_ = claim(numbered, command);
    return mark_ >= 0;
  });
}

void ResultsFolder::make_folder_beside(const std::string& command) {
  for (int number = 1; mark_ < 0; ++number) {
    beside_ = final_;
    *beside_ += number == 1 ? ".new" : ".new_" + std::to_string(number);
    // One that exists is that of a run that was killed, or of one that goes on.
    if (create(*beside_) || (!is_link(*beside_) && is_unfinished(*beside_))) mark_ = mark(*beside_, command);
  }
  for (const fs::path& name : files_in(*beside_)) remove_file(*beside_, name);
}

void ResultsFolder::finish() {
  if (mark_ < 0) return;
  std::string list{about_files};
  for (const fs::path& name : files_in(path())) list += name.string() + "\n";
  try {
    write_file(path() / results_file::list, list + results_file::list + "\n");
  } catch (const FileError&) {
    // On a full disk the results have no list, and will not be replaced.
  }
  if (beside_) {
    // Another run may put its results in their place, which takes milliseconds, or compute there, which may take hours.
    int old = -1;
    for (int tries = 0; old < 0 && tries < 100; ++tries) {
      if (tries > 0) std::this_thread::sleep_for(std::chrono::milliseconds{10});
      old = mark(final_, "exchange of results");
    }
    if (old < 0) return static_cast<void>(finish_incomplete());
    replace_old_results(*beside_);
    beside_.reset();
    close(std::exchange(mark_, old));
  }
  std::error_code error;
  fs::remove(final_ / results_file::unfinished, error);
  if (error) fail(final_, "cannot be marked as finished", error.message());
  close(std::exchange(mark_, -1));
}

void ResultsFolder::replace_old_results(const fs::path& from) {
  const std::optional old = files_of_moat(final_);
  for (const fs::path& name : *old) remove_file(final_, name);
  std::vector<fs::path> names = files_in(from);
  std::ranges::stable_partition(names, [](const fs::path& name) { return name != results_file::summary; });
  for (const fs::path& name : names) {
    std::error_code error;
    const fs::path above = (final_ / name).parent_path();
    if (name.has_parent_path() && is_link(above)) fs::remove(above, error);
    fs::create_directory(above, error);
    fs::rename(from / name, final_ / name, error);
    if (error) fail(final_ / name, "cannot be put in its place", error.message());
  }
  for (const char* name : {results_file::frames_folder, results_file::charts_folder, results_file::unfinished, ""}) {
    std::error_code foreign_files_stay;
    fs::remove(from / name, foreign_files_stay);
  }
}

bool ResultsFolder::finish_incomplete() {
  if (!beside_) return false;
  final_ = next_number(final_, [&](const fs::path& numbered) {
    std::error_code error;
    fs::rename(*beside_, numbered, error);
    if (error && error != std::errc::directory_not_empty && error != std::errc::file_exists)
      fail(numbered, "cannot take the results of " + beside_->string(), error.message());
    return !error;
  });
  beside_.reset();
  finish();
  return true;
}

ResultsFolder::~ResultsFolder() {
  if (mark_ < 0) return;
  std::error_code error;
  if (!beside_ && std::uncaught_exceptions() == 0) fs::remove(final_ / results_file::unfinished, error);
  close(mark_);
}

}  // namespace moat
