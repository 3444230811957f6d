#include <cstdint>
#include <optional>

#include "base/check.hpp"
#include "base/error.hpp"
#include "study/file/store.hpp"
#include "study/file/study_file.hpp"
#include "study/file/study_tables.hpp"
#include "study/outcome_bytes.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;

/// In every bit but those of the computation itself: its steps, their error and its time.
bool equal(CaseOutcome a, const CaseOutcome& b) {
  a.steps = b.steps;
  a.energy_error = b.energy_error;
  a.seconds = b.seconds;
  return to_bytes(a) == to_bytes(b);
}

const StudyIdentity& identity_of(const StoredStudy& study) { return study.versions[study.current_version]; }

/// The file that gives each case: its index, or nothing for open cases. Refuses files of another study, and a case that
/// differs from file to file.
std::vector<std::optional<std::size_t>> file_of_every_case(const std::vector<fs::path>& files) {
  const StoredStudy first = read_study(files.front());
  StudyResult merged{first.result.cases()};
  std::vector<std::optional<std::size_t>> file_of_case(merged.cases().count());
  for (std::size_t i = 0; i < files.size(); ++i) {
    const StoredStudy part = read_study(files[i]);
    const std::string others =
        differences(first.result.cases(), part.result.cases()) + differences(identity_of(first), identity_of(part));
    if (!others.empty())
      throw InputError{"merge: " + files[i].string() + " is not of the same study as " + files.front().string() + ":" +
                       others + "\nGive parts of one study."};
    for (std::size_t number = 0; number < file_of_case.size(); ++number) {
      CaseOutcome outcome = part.result.outcome(number);
      if (outcome.state == CaseState::open) continue;
      if (!file_of_case[number]) {
        merged.set(number, std::move(outcome));
        file_of_case[number] = i;
      } else if (!equal(merged.outcome(number), outcome)) {
        throw InputError{"merge: case " + std::to_string(number) + " of " + files[i].string() +
                         " differs from the one in " + files[*file_of_case[number]].string() +
                         ". Equal cases have equal results: find out which file is wrong."};
      }
    }
  }
  return file_of_case;
}

/// Writes those cases of a part that it gives, with the sessions that computed them.
void write(StudyFile& file, const StoredStudy& part, const std::vector<std::size_t>& numbers) {
  std::vector<std::optional<std::int64_t>> sessions(part.sessions.size());
  for (const std::size_t number : numbers) {
    const std::size_t from = part.session_of_case[number];
    if (!sessions.at(from)) {
      StoredSession session = part.sessions[from];
      session.version = study_tables::version_with(file.database(), part.versions[session.version]);
      sessions[from] = study_tables::add_session(file.database(), session);
    }
    file.rows().write(number, part.result.outcome(number), *sessions[from]);
  }
}

}  // namespace

void merge_studies(const fs::path& into, const std::vector<fs::path>& parts) {
  Check{"merge", ""}.that(!parts.empty(), "there is nothing to merge.", "Give the files of the parts.");
  std::error_code missing;
  const bool goes_on = fs::file_size(into, missing) > 0 && !missing;
  std::vector<fs::path> files = parts;
  if (goes_on) files.insert(files.begin(), into);
  const std::vector<std::optional<std::size_t>> file_of_case = file_of_every_case(files);
  const StoredStudy first = read_study(parts.front());
  StudyFile file{into, first.result.cases(), first.title};
  if (file.is_new())
    study_tables::set_current_version(file.database(), study_tables::version_with(file.database(), identity_of(first)));
  for (std::size_t i = goes_on ? 1 : 0; i < files.size(); ++i) {
    std::vector<std::size_t> numbers;
    for (std::size_t number = 0; number < file_of_case.size(); ++number)
      if (file_of_case[number] == i) numbers.push_back(number);
    if (!numbers.empty()) write(file, read_study(files[i]), numbers);
  }
}

}  // namespace moat
