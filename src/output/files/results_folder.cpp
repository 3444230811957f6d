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
#include "output/files/provenance.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

bool is_frame_name(std::string name) {
  name.resize(std::min(name.size(), name.find(".unfinished-")));  // of a run that was killed
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

bool holds(const fs::path& path, const char* text) {
  std::ifstream file{path, std::ios::binary};
  return std::string{std::istreambuf_iterator<char>{file}, {}}.find(text) != std::string::npos;
}

constexpr const char* about_unfinished = "moat computes here, or was killed before its results were complete.\n";

/// Makes or takes the file `unfinished`, and locks it until the returned descriptor is closed; -1 where another run has
/// it. The kernel gives up the lock of a program that was killed.
int mark(const fs::path& folder, const std::string& command, int flags = 0) {
  const fs::path path = folder / results_file::unfinished;
  if (std::error_code error; fs::is_symlink(fs::symlink_status(path, error))) fs::remove(path, error);
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
    dprintf(file, "%scommand: %s\nhost: %s\nprocess: %d\nstart: %s\n", about_unfinished, command.c_str(), host.data(),
            getpid(), provenance_of_library().date.c_str());
  return file;
}

/// Takes an empty folder, as mark() does.
int claim(const fs::path& folder, const std::string& command) {
  const int file = holds_nothing(folder) ? mark(folder, command, O_EXCL) : -1;
  // A whole run may have come between.
  if (file < 0 || entries(folder).size() == 1) return file;
  std::error_code error;
  fs::remove(folder / results_file::unfinished, error);
  close(file);
  return -1;
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
  if (is_file(results_file::summary) && holds(folder / results_file::summary, "\"moat_version\"")) return;
  std::error_code error;
  const fs::path mark = folder / results_file::unfinished;
  // It is empty for a moment, and on a full disk.
  if (is_file(results_file::unfinished) && (fs::is_empty(mark, error) || holds(mark, about_unfinished))) return;
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

/// The first of results_2, results_3 ... that does not exist, and that `take` gets.
fs::path next_number(const fs::path& results, const std::function<bool(const fs::path&)>& take) {
  for (int number = 2;; ++number) {
    fs::path numbered = results;
    numbered += "_" + std::to_string(number);
    std::error_code error;
    if (!fs::exists(fs::symlink_status(numbered, error)) && take(numbered)) return numbered;
  }
}

/// All but the mark.
void remove_results(const fs::path& folder) {
  for (const fs::path& path : entries(folder)) {
    std::error_code error;
    const fs::path name = path.filename();
    if (name == results_file::unfinished) continue;
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

ResultsFolder::ResultsFolder(const fs::path& wanted, WhenFolderExists when_exists, const std::string& command)
    : final_{with_name(wanted)} {
  create(final_);
  mark_ = claim(final_, command);
  if (mark_ >= 0) return;
  if (when_exists == WhenFolderExists::overwrite) {
    require_results_of_moat(final_);
    make_folder_beside(command);
    return;
  }
  if (when_exists == WhenFolderExists::refuse)
    throw InputError{"results folder " + final_.string() +
                     " exists and is not empty. Choose another folder, remove this one, or allow overwriting or a "
                     "new number."};
  final_ = next_number(final_, [&](const fs::path& numbered) {
    if (create(numbered)) mark_ = claim(numbered, command);
    return mark_ >= 0;
  });
}

void ResultsFolder::make_folder_beside(const std::string& command) {
  for (int number = 1; mark_ < 0; ++number) {
    beside_ = final_;
    *beside_ += number == 1 ? ".new" : ".new_" + std::to_string(number);
    create(*beside_);
    std::error_code error;
    if (!fs::is_symlink(fs::symlink_status(*beside_, error))) mark_ = mark(*beside_, command);
  }
  remove_results(*beside_);  // of a run that was killed
}

void ResultsFolder::finish() {
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
  if (mark_ < 0) return;
  std::error_code error;
  fs::remove(final_ / results_file::unfinished, error);
  if (error) fail(final_, "cannot be marked as finished", error.message());
  close(std::exchange(mark_, -1));
}

void ResultsFolder::replace_old_results(const fs::path& from) {
  std::error_code error;
  // First the old results go, with the summary by which the folder is known; the new summary comes last.
  remove_results(final_);
  std::vector<fs::path> names;
  for (const fs::path& path : entries(from)) {
    const fs::path name = path.filename();
    if (name == results_file::summary || name == results_file::unfinished) continue;
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
  fs::remove(from / results_file::unfinished, error);
  fs::remove(from, error);
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
