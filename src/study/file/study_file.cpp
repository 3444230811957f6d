#include "study/file/study_file.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <string>
#include <utility>

#include "base/error.hpp"
#include "study/file/study_tables.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

const fs::path& with_folder(const fs::path& file) {
  std::error_code ignored;  // opening the file says more
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  return file;
}

const fs::path& no_link(const fs::path& file) {
  std::error_code none;
  if (fs::is_symlink(fs::symlink_status(file, none)))
    throw InputError{"study " + file.string() + ": this is a link, and moat writes through none. Give its target."};
  return file;
}

/// The number of the file in its file system; 0 where there is no file.
std::uintmax_t inode_at(const fs::path& file) {
  struct stat found {};
  return ::stat(file.c_str(), &found) == 0 ? found.st_ino : 0;
}

// Another process may have removed the file between its opening and its locking.
bool is_file_at(int descriptor, const std::filesystem::path& path) {
  struct stat locked {
  }, there{};
  return ::fstat(descriptor, &locked) == 0 && ::stat(path.c_str(), &there) == 0 && locked.st_ino == there.st_ino &&
         locked.st_dev == there.st_dev;
}

}  // namespace

FileLock::FileLock(const std::filesystem::path& file) : path_{file} {
  path_ += ".lock";
  while (true) {
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw FileError{"study " + file.string() + ": " + path_.string() +
                      " cannot be made. Give a file in a folder that exists and can be written."};
    const bool locked = ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0;
    if (locked && is_file_at(descriptor_, path_)) return;
    ::close(descriptor_);
    if (!locked)
      throw InputError{"study " + file.string() +
                       ": another process computes it now. Wait for its end, or give another file."};
  }
}

FileLock::~FileLock() {
  ::unlink(path_.c_str());
  ::close(descriptor_);
}

StudyFile::StudyFile(const fs::path& file, StudyCases cases, const std::string& title)
    : lock_{with_folder(file)}, cases_{std::move(cases)}, database_{no_link(file), sqlite::Database::Access::write} {
  const bool has_tables = study_tables::exist_in(database_);  // before anything is written to another database
  database_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  // A process that was killed before its first transaction left an empty file.
  if (!has_tables) {
    sqlite::Transaction transaction{database_};
    study_tables::create(database_, cases_, title);
    transaction.commit();
  }
  // One that was killed before its second left a file without session.
  is_new_ = study_tables::sessions_of(database_).empty();
  axis_differences_ = differences(study_tables::cases_of(database_), cases_);
  place_ = fs::absolute(file);
  inode_ = inode_at(place_);
  rows_.emplace(database_, cases_);
}

void StudyFile::require_in_its_place() const {
  if (inode_at(place_) == inode_) return;
  fs::path kept = fs::path{place_}.replace_extension(".kept.db");
  for (int number = 2; fs::exists(fs::symlink_status(kept)); ++number)
    kept = fs::path{place_}.replace_extension(".kept_" + std::to_string(number) + ".db");
  database_.prepare("VACUUM INTO ?").run(with_folder(kept).native());
  throw FileError{"study " + database_.file().string() +
                  ": the file was removed or replaced while the study ran. All finished cases are in " + kept.string() +
                  ". Put it in the place of the former and run the same command again."};
}

StudyFile::~StudyFile() {
  rows_.reset();
  database_.become_one_file();
}

void StudyFile::refuse(const std::string& differences, bool can_be_accepted) const {
  throw InputError{"study " + database_.file().string() + " was begun with something else, and results are not mixed:" +
                   differences + "\nGive another folder (--out), " +
                   (can_be_accepted ? "go on with --accept-changes (earlier cases stay as they are), " : "") +
                   "restore the former state, or remove the file and start again."};
}

}  // namespace moat
