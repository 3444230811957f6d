#include "output/results_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

bool is_frame_name(const std::string& name) {
  const std::string front = "frame_";
  const std::string back = ".vtu";
  if (name.size() < front.size() + 6 + back.size() || !name.starts_with(front) || !name.ends_with(back)) return false;
  return std::all_of(name.begin() + static_cast<std::ptrdiff_t>(front.size()),
                     name.end() - static_cast<std::ptrdiff_t>(back.size()),
                     [](char c) { return c >= '0' && c <= '9'; });
}

// A chart is a picture and its numbers; one without the other may be the user's own work.
bool is_chart(const fs::path& path, const std::vector<fs::path>& beside) {
  const std::string name = path.stem().string();
  const bool plain =
      std::ranges::all_of(name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_'; });
  const fs::path extension = path.extension();
  if (!plain || (extension != ".svg" && extension != ".csv")) return false;
  fs::path other = path;
  other.replace_extension(extension == ".svg" ? ".csv" : ".svg");
  return std::ranges::find(beside, other) != beside.end();
}

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

bool holds_nothing(const fs::path& path) {
  std::error_code error;
  const bool empty = fs::is_empty(path, error);
  if (error) fail(path, "cannot be read", error.message());
  return empty;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (fs::directory_iterator entry{folder, error}, end; !error && entry != end; entry.increment(error))
    found.push_back(entry->path());
  if (error) fail(folder, "cannot be read", error.message());
  return found;
}

/// Whether write_summary_json() wrote the file.
bool is_summary_of_moat(const fs::path& path) {
  std::ifstream file{path, std::ios::binary};
  const std::string text{std::istreambuf_iterator<char>{file}, {}};
  return text.find("\"moat_version\"") != std::string::npos;
}

/// Throws InputError if files have the names of results and moat may not have written them. Frames do not count: they
/// are written during a run, the summary at its end.
void require_results_of_moat(const fs::path& folder) {
  const auto is_file = [&](const char* name) {
    std::error_code error;
    return std::string_view{name} != results_file::frames &&
           fs::is_regular_file(fs::symlink_status(folder / name, error));
  };
  if (std::ranges::none_of(results_file::all_at_top, is_file)) return;
  if (is_file(results_file::summary) && is_summary_of_moat(folder / results_file::summary)) return;
  throw InputError{"results folder " + folder.string() +
                   " has files with the names of results, but no summary.json of moat beside them: they may not be "
                   "results. Choose another folder, or remove them."};
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

/// Makes the first of results_2, results_3 ... that does not exist.
fs::path create_next_number(const fs::path& results) {
  for (int number = 2;; ++number) {
    fs::path numbered = results;
    numbered += "_" + std::to_string(number);
    std::error_code error;
    if (!fs::exists(fs::symlink_status(numbered, error)) && create(numbered)) return numbered;
  }
}

void remove_results(const fs::path& folder) {
  for (const fs::path& path : entries(folder)) {
    std::error_code error;
    const fs::path name = path.filename();
    const fs::file_status status = fs::symlink_status(path, error);
    const bool is_folder = std::ranges::find(results_file::all_folders, name) != results_file::all_folders.end();
    const bool is_file = std::ranges::find(results_file::all_at_top, name) != results_file::all_at_top.end();
    // The target of a link is not in this folder and stays. The link goes: results would be written to its target.
    if (fs::is_symlink(status) && (is_file || is_folder)) fs::remove(path, error);
    if (fs::is_regular_file(status) && is_file) fs::remove(path, error);
    if (fs::is_directory(status) && is_folder) {
      const std::vector<fs::path> inside = entries(path);
      for (const fs::path& each : inside)
        if (name == results_file::frames_folder ? is_frame_name(each.filename().string()) : is_chart(each, inside))
          if (!error && !fs::is_directory(fs::symlink_status(each, error))) fs::remove(each, error);
      if (!error && holds_nothing(path)) fs::remove(path, error);
    }
    if (error) fail(path, "cannot be removed", error.message());
  }
}

}  // namespace

ResultsFolder::ResultsFolder(const fs::path& wanted, WhenFolderExists when_exists) : final_{with_name(wanted)} {
  if (create(final_) || holds_nothing(final_)) return;
  if (when_exists == WhenFolderExists::overwrite) {
    require_results_of_moat(final_);
    make_folder_beside();
    return;
  }
  if (when_exists == WhenFolderExists::refuse)
    throw InputError{"results folder " + final_.string() +
                     " exists and is not empty. Choose another folder, remove this one, or allow overwriting or a "
                     "new number."};
  final_ = create_next_number(final_);
}

void ResultsFolder::make_folder_beside() {
  for (int number = 1;; ++number) {
    fs::path beside = final_;
    beside += number == 1 ? ".new" : ".new_" + std::to_string(number);
    const bool is_new = create(beside);
    lock_ = open(beside.c_str(), O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (lock_ < 0) fail(beside, "cannot be opened", std::strerror(errno));
    // The kernel gives up the lock of a program that was killed; its folder is taken over.
    if (flock(lock_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) {
      if (!is_new) remove_results(beside);
      beside_ = beside;
      return;
    }
    close(std::exchange(lock_, -1));
  }
}

void ResultsFolder::finish() {
  if (!beside_) return;
  const fs::path from = *beside_;
  // First the old results go, with the summary by which the folder is known; the new summary comes last.
  remove_results(final_);
  std::vector<fs::path> names;
  std::error_code error;
  for (const fs::path& path : entries(from)) {
    const fs::path name = path.filename();
    if (name == results_file::summary) continue;
    // As a whole, unless foreign files stayed in the old folder.
    if (!fs::is_directory(path, error) || !fs::exists(fs::symlink_status(final_ / name, error)))
      names.push_back(name);
    else
      for (const fs::path& each : entries(path)) names.push_back(name / each.filename());
  }
  if (fs::exists(from / results_file::summary, error)) names.emplace_back(results_file::summary);
  for (const fs::path& name : names) {
    fs::rename(from / name, final_ / name, error);
    if (error) fail(final_ / name, "cannot be put in its place", error.message());
  }
  for (const char* folder : results_file::all_folders) fs::remove(from / folder, error);
  fs::remove(from, error);
  release_folder_beside();
}

bool ResultsFolder::finish_incomplete() {
  if (!beside_) return false;
  const fs::path numbered = create_next_number(final_);
  std::error_code error;
  fs::rename(*beside_, numbered, error);  // takes the place of the empty folder
  if (error) fail(numbered, "cannot take the results of " + beside_->string(), error.message());
  final_ = numbered;
  release_folder_beside();
  return true;
}

void ResultsFolder::release_folder_beside() {
  close(std::exchange(lock_, -1));
  beside_.reset();
}

ResultsFolder::~ResultsFolder() {
  if (lock_ >= 0) close(lock_);
}

}  // namespace moat
