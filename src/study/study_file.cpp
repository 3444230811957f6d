#include "study/study_file.hpp"

#include <unistd.h>

#include <array>
#include <utility>

#include "base/error.hpp"
#include "study/study_tables.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

const fs::path& with_folder(const fs::path& file) {
  std::error_code ignored;  // opening the file says more
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  return file;
}

}  // namespace

StudyFile::StudyFile(const fs::path& file, StudyCases cases, const std::string& title)
    : lock_{with_folder(file)}, cases_{std::move(cases)}, database_{file, sqlite::Database::Access::write} {
  database_.run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  // A process that was killed before its first transaction left an empty file.
  if (!study_tables::exist_in(database_)) {
    sqlite::Transaction transaction{database_};
    study_tables::create(database_, cases_, title);
    transaction.commit();
  }
  // One that was killed before its second left a file without session.
  is_new_ = study_sessions::all_of(database_).empty();
  axis_differences_ = differences(study_tables::cases_of(database_), cases_);
  read_rows_again();
}

StudyFile::~StudyFile() {
  rows_.reset();
  database_.become_one_file();
}

void StudyFile::refuse(const std::string& differences) const {
  throw InputError{"study " + database_.file().string() +
                   " was begun with something else, and results are not mixed:" + differences +
                   "\nGive another file or folder, restore the former state, or remove the file and start again."};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace moat
