#include "output/files/folder_exchange.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "output/files/file_io.hpp"
#include "output/files/results_folder.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

constexpr const char* about_files = "moat wrote these files. Overwriting the results replaces them and no others.\n";

/// Paths of everything in a folder, relative to it; folders before their files. Links are not followed.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::recursive_directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error))
    found.push_back(entry->path().lexically_relative(folder));
  if (error) refuse_folder(folder, "cannot be read", error.message());
  return found;
}

bool is_folder(const fs::path& path) {
  std::error_code error;
  return fs::is_directory(fs::symlink_status(path, error));
}

/// fs::equivalent() follows links.
bool are_one(const fs::path& first, const fs::path& second) {
  struct stat a {
  }, b{};
  return lstat(first.c_str(), &a) == 0 && lstat(second.c_str(), &b) == 0 && a.st_dev == b.st_dev &&
         a.st_ino == b.st_ino;
}

/// True also for a file that write_file() had not ended when the run was killed.
bool has_known_name(const fs::path& name) {
  const std::string first = name.begin()->string();
  return std::ranges::find(results_file::all_names, first.substr(0, first.find(unfinished_ending))) !=
         results_file::all_names.end();
}

/// Whether a folder has its place in results, so that an empty one is no folder of the user.
bool is_folder_of_results(const fs::path& name) {
  return name == results_file::frames_folder || name == results_file::charts_folder;
}

/// Paths of the files with names of results.
std::set<fs::path> files_in(const fs::path& folder) {
  std::set<fs::path> files;
  for (const fs::path& name : entries_of(folder))
    if (!is_folder(folder / name) && has_known_name(name) && name != results_file::unfinished) files.insert(name);
  return files;
}

}  // namespace

void refuse_folder(const fs::path& path, const std::string& problem, const std::string& reason) {
  throw FileError{"results folder " + path.string() + ": " + problem + " (" + reason +
                  "). Choose another folder, or make this one writable."};
}

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

bool is_link(const fs::path& path) {
  std::error_code error;
  return fs::is_symlink(fs::symlink_status(path, error));
}

std::string text_in(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  return {std::istreambuf_iterator<char>{file}, {}};
}

int lock_file(const fs::path& path, int how_to_lock, int how_to_open) {
  const int file = open(path.c_str(), O_RDWR | O_NOFOLLOW | O_CLOEXEC | how_to_open, 0666);
  struct stat locked {
  }, present{};
  int reason =
      file < 0 || flock(file, how_to_lock) != 0 || fstat(file, &locked) != 0 || stat(path.c_str(), &present) != 0
          ? errno
          : 0;
  if (reason == 0 && locked.st_ino != present.st_ino) reason = ESTALE;
  if (reason == 0) return file;
  close(file);
  errno = reason;
  return -1;
}

bool is_unfinished(const fs::path& folder) {
  std::error_code error;
  const fs::path mark = folder / results_file::unfinished;
  return fs::is_regular_file(fs::symlink_status(mark, error)) &&
         (fs::is_empty(mark, error) || text_in(mark).starts_with(about_unfinished));
}

bool has_list(const fs::path& folder) { return text_in(folder / results_file::list).starts_with(about_files); }

void write_list(const fs::path& folder) {
  std::string list{about_files};
  for (const fs::path& name : files_in(folder)) list += name.string() + "\n";
  write_file(folder / results_file::list, list + results_file::list + "\n");
}

void wait_for_disk(const fs::path& folder) {
  const int file = open(folder.c_str(), O_RDONLY | O_CLOEXEC);
  const int reason = file < 0 || syncfs(file) != 0 ? errno : 0;
  close(file);
  if (reason != 0) refuse_folder(folder, "cannot be written to the disk", std::strerror(reason));
}

std::optional<std::set<fs::path>> files_of_moat(const fs::path& folder) {
  const auto with_mark = [&](std::set<fs::path> files) {
    const fs::path mark = results_file::unfinished;
    if (is_unfinished(folder) || is_link(folder / mark)) files.insert(mark);
    return std::optional{std::move(files)};
  };
  if (!has_list(folder)) return is_unfinished(folder) ? with_mark(files_in(folder)) : std::nullopt;
  std::istringstream list{text_in(folder / results_file::list)};
  std::set<std::string> listed;
  for (std::string name; std::getline(list, name);) listed.insert(name);
  std::set<fs::path> files = files_in(folder);
  std::erase_if(files, [&](const fs::path& name) { return !listed.contains(name) && !is_link(folder / name); });
  return with_mark(files);
}

bool link_foreign_files(const fs::path& from, const fs::path& to) {
  const std::set<fs::path> old = files_of_moat(from).value_or(std::set<fs::path>{}),
                           results = files_of_moat(to).value_or(std::set<fs::path>{});
  std::vector<fs::path> made;
  std::error_code error;
  const auto give = [&](const fs::path& name) {
    if (is_folder(from / name)) return fs::create_directory(to / name, from / name, error);
    // One that differs is an earlier link to a file that the user replaced meanwhile.
    if (are_one(from / name, to / name)) return false;
    if (!results.contains(name)) fs::remove(to / name, error);
    if (!error) fs::create_directories((to / name).parent_path(), error);
    if (!error) fs::create_hard_link(from / name, to / name, error);
    return !error;
  };
  for (const fs::path& name : entries_of(from)) {
    if (old.contains(name) || is_folder_of_results(name)) continue;
    if (give(name)) made.push_back(name);
    if (!error) continue;
    for (auto each = made.rbegin(); each != made.rend(); ++each) fs::remove(to / *each, error);
    return false;
  }
  return true;
}

void remove_results(const fs::path& folder, const fs::path& kept) {
  const std::set<fs::path> old = files_of_moat(folder).value_or(std::set<fs::path>{});
  std::vector<fs::path> entries = entries_of(folder);
  std::ranges::reverse(entries);  // files before their folders
  const std::array<fs::path, 2> marks{results_file::list, results_file::unfinished};
  std::error_code others_stay;
  for (const fs::path& name : entries)
    if (std::ranges::find(marks, name) == marks.end() &&
        (old.contains(name) || is_folder(folder / name) || are_one(folder / name, kept / name)))
      fs::remove(folder / name, others_stay);
  for (const fs::path& mark : marks)
    if (old.contains(mark)) fs::remove(folder / mark, others_stay);
  fs::remove(folder, others_stay);
}

bool exchange_folders(const fs::path& first, const fs::path& second) {
  if (renameat2(AT_FDCWD, first.c_str(), AT_FDCWD, second.c_str(), RENAME_EXCHANGE) == 0) return true;
  if (errno != EINVAL && errno != ENOSYS && errno != EOPNOTSUPP) return false;
  std::error_code error, not_back;
  fs::path old = first;
  old += ".old";
  fs::rename(second, old, error);
  if (error) return false;
  fs::rename(first, second, error);
  fs::rename(old, error ? second : first, not_back);
  if (not_back) refuse_folder(old, "has the old results now", not_back.message());
  return !error;
}

void restore_name(const fs::path& first, const fs::path& second) {
  fs::path old = first;
  old += ".old";
  std::error_code stays;
  if (!is_there(old)) return;
  if (!is_there(second) && is_unfinished(first)) fs::rename(old, second, stays);
  if (!is_there(first) && is_unfinished(second)) fs::rename(old, first, stays);
}

}  // namespace moat
