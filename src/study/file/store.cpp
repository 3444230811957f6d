#include "study/file/store.hpp"

#include <unistd.h>

#include <array>
#include <iterator>
#include <utility>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "study/file/study_file.hpp"
#include "study/file/study_tables.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using sqlite::Database;
using sqlite::Transaction;

/// Returns the name of this machine.
std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

}  // namespace

struct StudyStore::Parts {
  StudyFile file;
  std::int64_t session = 0;

  Parts(const fs::path& path, const StudyCases& cases, const std::string& title) : file{path, cases, title} {}

  void begin(const StudyIdentity& identity, const StudySession& from, StudyChanges changes) {
    const Database& database = file.database();
    const std::vector<FileRead> changed = changed_files(identity, changes);
    Transaction transaction{database};
    StoredSession stored;
    static_cast<StudySession&>(stored) = from;
    stored.host = host_name();
    stored.version = study_tables::version_with(database, identity);
    study_tables::set_current_version(database, stored.version);
    case_rows::accept_files(database, changed);
    session = study_tables::add_session(database, stored);
    transaction.commit();
  }

 private:
  /// Returns the files that cases have read, as they are now. Refuses every change that is not accepted.
  std::vector<FileRead> changed_files(const StudyIdentity& identity, StudyChanges changes) const {
    if (file.is_new()) return {};
    const Database& database = file.database();
    StudyIdentity before = study_tables::versions_of(database)[study_tables::current_version(database)];
    StudyIdentity now = identity;
    std::vector<FileRead> changed;
    for (const FileRead& known : case_rows::files_of(database)) {
      const FileRead on_disk{known.path, sha256_of_file(known.path).value_or("")};
      if (on_disk != known) changed.push_back(on_disk);
      // A file that was read outside of cases too is a part of the identity.
      const std::string name = "file " + known.path;
      if (identity.contains(name)) continue;
      before[name] = known.sha256;
      now[name] = on_disk.sha256;
    }
    const std::string all = differences(before, now);
    if (!file.axis_differences().empty() || (!all.empty() && changes == StudyChanges::refuse))
      file.refuse(file.axis_differences() + all, file.axis_differences().empty());
    return changed;
  }
};

StudyStore::StudyStore(const fs::path& file, const StudyCases& cases, const StudyIdentity& identity,
                       const StudySession& session, StudyChanges changes)
    : parts_{std::make_unique<Parts>(file, cases, session.title)} {
  parts_->begin(with_hashes_of_axes(identity, cases), session, changes);
}

StudyStore::~StudyStore() = default;

StudyResult StudyStore::result() const { return case_rows::read(parts_->file.database(), parts_->file.cases()).result; }

void StudyStore::write(std::size_t number, const CaseOutcome& outcome) {
  parts_->file.rows().write(number, outcome, parts_->session);
  parts_->file.require_in_its_place();
}

void StudyStore::forget_failures() { parts_->file.rows().forget_failures(); }

void StudyStore::end_session(const std::string& ending) {
  study_tables::set_ending(parts_->file.database(), parts_->session, ending);
  parts_->file.require_in_its_place();
}

StoredStudy read_study(const fs::path& file) {
  if (!fs::is_regular_file(file)) throw FileError{"study " + file.string() + ": there is no such file."};
  const Database database{file, Database::Access::read};
  // So that cases, sessions and results are those of one moment, also while the study runs.
  database.run("BEGIN");
  if (!study_tables::exist_in(database))
    throw FileError{"study " + file.string() + ": the file is empty. Give another file."};
  const StudyCases cases = study_tables::cases_of(database);
  StoredCases stored = case_rows::read(database, cases);
  StoredStudy study{.title = study_tables::property(database, "title"),
                    .versions = study_tables::versions_of(database),
                    .current_version = study_tables::current_version(database),
                    .sessions = study_tables::sessions_of(database),
                    .session_of_case = {},
                    .result = std::move(stored.result)};
  // Sessions count from 1 in the file.
  for (const std::int64_t session : stored.sessions) {
    study.session_of_case.push_back(session > 0 ? static_cast<std::size_t>(session - 1) : 0);
    if (session > std::ssize(study.sessions))
      throw FileError{"study " + file.string() + ": it lacks session " + std::to_string(session) +
                      ", which computed a case. The file is damaged: restore a copy, or start again in another file."};
  }
  return study;
}

}  // namespace moat
