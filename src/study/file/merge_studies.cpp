#include <cstdint>
#include <optional>
#include <utility>

#include "base/check.hpp"
#include "base/error.hpp"
#include "study/file/store.hpp"
#include "study/file/study_file.hpp"
#include "study/outcome_bytes.hpp"
#include "study/study_tables.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using sqlite::Database;

/// A file to merge, without the table of its results: there may be one file for every case.
struct Part {
  std::string title;
  StudyCases cases;
  std::vector<StudyIdentity> versions;
  std::size_t version;  ///< current one
  std::vector<StoredSession> sessions;
  std::vector<std::int64_t> session_of_case;  ///< from 1
  std::vector<CaseOutcome> outcomes;
};

Part read_part(const fs::path& file) {
  if (!fs::is_regular_file(file)) throw FileError{"study " + file.string() + ": there is no such file."};
  const Database database{file, Database::Access::read};
  database.run("BEGIN");
  if (!study_tables::exist_in(database))
    throw FileError{"study " + file.string() + ": the file is empty. Give another file."};
  StudyCases cases = study_tables::cases_of(database);
  StoredCases stored = case_rows::read(database, cases);
  return {.title = study_tables::property(database, "title"),
          .cases = std::move(cases),
          .versions = study_sessions::versions_of(database),
          .version = study_sessions::current_version(database),
          .sessions = study_sessions::all_of(database),
          .session_of_case = std::move(stored.sessions),
          .outcomes = std::move(stored.outcomes)};
}

/// In every bit but those of the computation itself: its steps, their error and its time.
bool equal(CaseOutcome a, const CaseOutcome& b) {
  a.steps = b.steps;
  a.energy_error = b.energy_error;
  a.seconds = b.seconds;
  return to_bytes(0, a) == to_bytes(0, b);
}

/// Which file gives each case. Refuses files of another study, and a case that differs from file to file.
class Agreement {
 public:
  void include(const Part& part, const fs::path& file) {
    if (files_.empty()) {
      cases_ = part.cases;
      identity_ = part.versions[part.version];
      outcomes_.resize(part.outcomes.size());
      file_of_case_.resize(part.outcomes.size());
    }
    const std::string others = differences(*cases_, part.cases) + differences(identity_, part.versions[part.version]);
    if (!others.empty())
      throw InputError{"merge: " + file.string() + " is not of the same study as " + files_.front().string() + ":" +
                       others + "\nGive parts of one study."};
    for (std::size_t number = 0; number < outcomes_.size(); ++number) {
      const CaseOutcome& outcome = part.outcomes[number];
      if (outcome.state == CaseState::open) continue;
      if (outcomes_[number].state == CaseState::open) {
        outcomes_[number] = outcome;
        file_of_case_[number] = files_.size();
      } else if (!equal(outcomes_[number], outcome)) {
        throw InputError{"merge: case " + std::to_string(number) + " of " + file.string() +
                         " differs from the one in " + files_[file_of_case_[number]].string() +
                         ". Equal cases have equal results: find out which file is wrong."};
      }
    }
    files_.push_back(file);
  }

  /// Numbers of the cases that a file gives, by its place in the order of include().
  [[nodiscard]] std::vector<std::size_t> cases_of(std::size_t file) const {
    std::vector<std::size_t> numbers;
    for (std::size_t number = 0; number < outcomes_.size(); ++number)
      if (outcomes_[number].state != CaseState::open && file_of_case_[number] == file) numbers.push_back(number);
    return numbers;
  }

 private:
  std::vector<fs::path> files_;
  std::optional<StudyCases> cases_;
  StudyIdentity identity_;
  std::vector<CaseOutcome> outcomes_;
  std::vector<std::size_t> file_of_case_;
};

void write(StudyFile& file, const Part& part, const std::vector<std::size_t>& numbers) {
  std::vector<std::optional<std::int64_t>> sessions(part.sessions.size() + 1);
  for (const std::size_t number : numbers) {
    const auto from = static_cast<std::size_t>(part.session_of_case[number]);
    if (!sessions.at(from)) {
      StoredSession session = part.sessions.at(from - 1);
      session.version = study_sessions::version_with(file.database(), part.versions[session.version]);
      sessions[from] = study_sessions::add(file.database(), session);
    }
    file.rows().write(number, part.outcomes[number], *sessions[from]);
  }
}

}  // namespace

void merge_studies(const fs::path& into, const std::vector<fs::path>& parts) {
  Check{"merge", ""}.that(!parts.empty(), "there is nothing to merge.", "Give the files of the parts.");
  Agreement agreement;
  std::error_code missing;
  const bool goes_on = fs::file_size(into, missing) > 0 && !missing;
  if (goes_on) agreement.include(read_part(into), into);
  for (const fs::path& part : parts) agreement.include(read_part(part), part);
  const Part first = read_part(parts.front());
  StudyFile file{into, first.cases, first.title};
  file.prepare_rows();
  if (file.is_new())
    study_sessions::set_current_version(file.database(),
                                        study_sessions::version_with(file.database(), first.versions[first.version]));
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<std::size_t> numbers = agreement.cases_of(i + (goes_on ? 1 : 0));
    if (!numbers.empty()) write(file, read_part(parts[i]), numbers);
  }
}

}  // namespace moat
