#include "output/files/results_folder.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstdio>
#include <cstring>
#include <exception>
#include <functional>
#include <iterator>
#include <set>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/error.hpp"
#include "output/files/file_io.hpp"
#include "output/files/folder_exchange.hpp"
#include "output/files/provenance.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

/// True if this call made the folder, so that two programs started together never share one.
bool create(const fs::path& path) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  const bool is_new = !error && fs::create_directory(path, error);
  if (error) refuse_folder(path, "cannot be created", error.message());
  return is_new;
}

std::size_t entries_in(const fs::path& folder) {
  std::error_code error;
  const auto count = std::distance(fs::directory_iterator{folder, error}, {});
  if (error) refuse_folder(folder, "cannot be read", error.message());
  return static_cast<std::size_t>(count);
}

/// Makes the file `unfinished`, and locks it as lock_file() does.
int mark(const fs::path& folder, const std::string& command) {
  const int file = lock_file(folder / results_file::unfinished, LOCK_EX | LOCK_NB, O_CREAT | O_EXCL);
  if (file < 0 && errno != EEXIST && errno != ENOENT && errno != ESTALE && errno != EWOULDBLOCK)
    refuse_folder(folder, "cannot be written to", std::strerror(errno));
  if (file < 0) return file;
  std::array<char, HOST_NAME_MAX + 1> host{};
  gethostname(host.data(), host.size() - 1);
  dprintf(file, "%scommand: %s\nhost: %s\nprocess: %d\nstart: %s\nfolder: %s\n", about_unfinished, command.c_str(),
          host.data(), getpid(), provenance_of_library().date.c_str(), folder.filename().c_str());
  return file;
}

/// Takes an empty folder, as mark() does.
int claim(const fs::path& folder, const std::string& command) {
  const int file = entries_in(folder) == 0 ? mark(folder, command) : -1;
  // A whole run may have come between.
  if (file < 0 || entries_in(folder) == 1) return file;
  std::error_code error;
  fs::remove(folder / results_file::unfinished, error);
  close(file);
  return -1;
}

fs::path beside(const fs::path& results, int number) {
  fs::path path = results;
  path += number == 1 ? ".new" : ".new_" + std::to_string(number);
  return path;
}

/// Removes the old results, which stand beside the new ones under the name that is in the mark of these, and then the
/// mark.
void end_exchange(const fs::path& results) {
  const fs::path mark = results / results_file::unfinished;
  const std::string text = text_in(mark), key = "\nfolder: ";
  const std::size_t at = text.rfind(key), begin = at + key.size();
  const std::string name = at == text.npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
  // A mark with another name removes nothing.
  if (name.starts_with(beside(results, 1).filename().string()) && name.find('/') == name.npos) {
    const fs::path old = results.parent_path() / name;
    restore_name(old, results);
    // Another run may have taken the name meanwhile.
    const int lock = is_unfinished(old) ? lock_file(old / results_file::unfinished) : -1;
    if (is_there(old) && (lock >= 0 || !is_unfinished(old))) {
      wait_for_disk(results);
      link_foreign_files(old, results);
      remove_results(old, results);
    }
    close(lock);
  }
  std::error_code error;
  fs::remove(mark, error);
  if (error) refuse_folder(results, "cannot be marked as finished", error.message());
}

/// Locks complete results, or those of a run that was killed, and ends the exchange of such a run. Waits while another
/// run exchanges them. -1 where there are none, or where a run computes.
int lock_results(const fs::path& results) {
  while (true) {
    const bool complete = has_list(results), marked = is_unfinished(results);
    if (!complete && !marked) return -1;
    const int lock = lock_file(results / (marked ? results_file::unfinished : results_file::list),
                               complete ? LOCK_EX : LOCK_EX | LOCK_NB);
    if (lock < 0 && errno != ENOENT && errno != ESTALE) return -1;
    if (lock >= 0 && is_unfinished(results) == marked) {
      if (!complete || !marked) return lock;
      end_exchange(results);
    }
    close(lock);
  }
}

/// Gives complete results beside others the name of these. Returns false where a run computes there, and where files of
/// the user cannot stay in that folder.
bool put_in_place(const fs::path& from, const fs::path& results) {
  std::error_code error;
  fs::rename(from, results, error);  // where there is nothing, or an empty folder
  if (error) {
    const int old = lock_results(results);
    const bool done = old >= 0 && link_foreign_files(results, from) && exchange_folders(from, results);
    close(old);
    if (!done) return false;
  }
  return true;
}

/// Complete results of killed runs beside these take their place; incomplete ones are removed.
void end_killed_runs(const fs::path& results) {
  for (int number = 1; is_there(beside(results, number)); ++number) {
    const fs::path from = beside(results, number);
    const bool is_of_moat = !is_link(from) && is_unfinished(from);
    const int lock = is_of_moat ? lock_file(from / results_file::unfinished) : -1;
    if (lock < 0) continue;
    restore_name(from, results);
    if (!has_list(from))
      remove_results(from, results);
    else
      put_in_place(from, results);
    close(lock);
  }
  close(lock_results(results));
}

/// `wanted` without a slash at its end, and with its own name where it ends in . or ..
fs::path with_name(fs::path wanted) {
  // "results/x/" would otherwise become "results/x/_2", and "." a hidden "._2".
  if (!wanted.empty() && !wanted.has_filename()) wanted = wanted.parent_path();
  if (wanted.empty()) throw InputError{"results folder: the path is empty. Give a folder, for example results/run."};
  if (wanted.filename() == "." || wanted.filename() == "..") {
    std::error_code error;
    wanted = fs::weakly_canonical(wanted, error);
    if (error) refuse_folder(wanted, "cannot be read", error.message());
  }
  if (!wanted.has_filename())
    throw InputError{"results folder " + wanted.string() +
                     ": this is the root of all folders. Give a folder in it, for example results/run."};
  return wanted;
}

/// Not a link is exchanged, but its target.
fs::path without_link(fs::path folder) {
  std::error_code error;
  const fs::path target = fs::canonical(folder, error);
  return is_link(folder) && !error ? target : folder;
}

/// The first of results_2, results_3 ... that does not exist, and that `take` gets.
fs::path next_number(const fs::path& results, const std::function<bool(const fs::path&)>& take) {
  for (int number = 2;; ++number) {
    fs::path numbered = results;
    numbered += "_" + std::to_string(number);
    if (!is_there(numbered) && take(numbered)) return numbered;
  }
}

}  // namespace

ResultsFolder::ResultsFolder(const fs::path& wanted, WhenFolderExists when_exists, const std::string& command)
    : final_{when_exists == WhenFolderExists::use_new_number ? with_name(wanted) : without_link(with_name(wanted))} {
  if (when_exists == WhenFolderExists::go_on) {
    go_on(command);
    return;
  }
  const bool replaces = when_exists == WhenFolderExists::overwrite;
  if (replaces) end_killed_runs(final_);
  create(final_);
  mark_ = claim(final_, command);
  if (mark_ >= 0) return;
  if (replaces) {
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

fs::path folder_with_checkpoint(const fs::path& wanted) {
  const fs::path results = without_link(with_name(wanted));
  std::vector<fs::path> folders{results};
  for (int number = 1; is_there(beside(results, number)); ++number) folders.push_back(beside(results, number));
  for (const fs::path& folder : folders)
    if (!is_link(folder) && is_there(folder / results_file::checkpoint)) return folder;
  throw InputError{"results folder " + results.string() +
                   " has no checkpoint of a run that was killed or stopped. Give the folder of that run with --out, or "
                   "leave out --resume."};
}

void ResultsFolder::go_on(const std::string& command) {
  if (const fs::path folder = folder_with_checkpoint(final_); folder != final_) beside_ = folder;
  // Results of a run that was stopped are complete. Another run may replace them now, or have done so.
  const bool was_killed = is_unfinished(path());
  const int list = was_killed ? -1 : lock_file(path() / results_file::list);
  if (was_killed)
    mark_ = lock_file(path() / results_file::unfinished);
  else if (list >= 0 ? is_there(path() / results_file::checkpoint) : errno == ENOENT)
    mark_ = mark(path(), command);
  if (const int reason = errno; mark_ < 0) {
    close(list);
    if (reason != EWOULDBLOCK && reason != EEXIST) refuse_folder(path(), "cannot be locked", std::strerror(reason));
    throw InputError{"results folder " + path().string() + ": another run computes there. Wait for its end."};
  }
  // Charts of the stopped run may have names that the whole run has not.
  std::error_code error;
  for (const fs::path& name : files_of_moat(path()).value_or(std::set<fs::path>{}))
    if (*name.begin() == results_file::charts_folder || name.string().find(unfinished_ending) != std::string::npos)
      fs::remove(path() / name, error);
  fs::remove(path() / results_file::list, error);
  close(list);
}

void ResultsFolder::make_folder_beside(const std::string& command) {
  for (int number = 1; mark_ < 0; ++number)
    if (create(*(beside_ = beside(final_, number))) || !is_link(*beside_)) mark_ = claim(*beside_, command);
  std::error_code those_of_new_folders;
  fs::permissions(*beside_, fs::status(final_, those_of_new_folders).permissions(), those_of_new_folders);
}

void ResultsFolder::finish() {
  if (mark_ < 0) return;
  try {
    // A power cut shall lose neither old results nor hours of computing.
    constexpr std::chrono::seconds worth_waiting{10};
    if (beside_ || std::chrono::steady_clock::now() - start_ > worth_waiting) wait_for_disk(path());
    write_list(path());
  } catch (const FileError&) {
    // A full disk: old results stay, and these have no list.
    if (!finish_incomplete()) throw;
    return;
  }
  if (beside_ && !put_in_place(*beside_, final_)) return static_cast<void>(finish_incomplete());
  beside_.reset();
  end_exchange(final_);
  close(std::exchange(mark_, -1));
}

bool ResultsFolder::finish_incomplete() {
  if (!beside_) return false;
  final_ = next_number(final_, [&](const fs::path& numbered) {
    std::error_code error;
    fs::rename(*beside_, numbered, error);
    if (error && error != std::errc::directory_not_empty && error != std::errc::file_exists)
      refuse_folder(numbered, "cannot take the results of " + beside_->string(), error.message());
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
