#include "study/file/study_sessions.hpp"

#include <algorithm>
#include <charconv>

#include "base/error.hpp"
#include "study/file/sqlite.hpp"
#include "study/study_tables.hpp"

namespace moat::study_sessions {

using sqlite::Database;
using sqlite::Statement;

std::vector<StudyIdentity> versions_of(const Database& database) {
  // The current version may have no rows: a study may depend on its axes alone.
  std::vector<StudyIdentity> versions(current_version(database) + 1);
  Statement rows = database.prepare("SELECT version, name, value FROM versions ORDER BY version, name");
  while (rows.step()) {
    const auto version = static_cast<std::size_t>(rows.integer(0));
    if (version >= versions.size()) versions.resize(version + 1);
    versions[version].emplace_back(rows.text(1), rows.text(2));
  }
  return versions;
}

std::size_t version_with(const Database& database, const StudyIdentity& identity) {
  const std::vector<StudyIdentity> versions = versions_of(database);
  const auto known = std::ranges::find(versions, identity);
  if (known != versions.end()) return static_cast<std::size_t>(known - versions.begin());
  Statement row = database.prepare("INSERT INTO versions VALUES (?, ?, ?)");
  // versions_of() returns one empty version for a file without sessions.
  Statement sessions = database.prepare("SELECT count(*) FROM sessions");
  sessions.step();
  const std::size_t version = sessions.integer(0) == 0 ? 0 : versions.size();
  for (const auto& [name, value] : identity) row.run(version, name, value);
  return version;
}

std::size_t current_version(const Database& database) {
  const std::string text = study_tables::property(database, "version");
  constexpr std::size_t most = 1'000'000;
  std::size_t version = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), version);
  if (text.empty() || (failure == std::errc{} && end == text.data() + text.size() && version <= most)) return version;
  throw FileError{
      "study " + database.file().string() + ": its version is \"" + text +
      "\"; it must be a whole number. The file is damaged: restore a copy, or start again in another file."};
}

void set_current_version(const Database& database, std::size_t version) {
  study_tables::set_property(database, "version", std::to_string(version));
}

std::int64_t add(const Database& database, const StoredSession& session) {
  Statement row = database.prepare(
      "INSERT INTO sessions (date, command, moat_version, git_commit, engine, host, version, ending) "
      "VALUES (?, ?, ?, ?, ?, ?, ?, ?) RETURNING session");
  row.bind(session.date, session.command_line, session.moat_version, session.git_commit, session.engine, session.host,
           session.version, session.ending);
  row.step();
  const std::int64_t number = row.integer(0);
  row.step();  // to its end
  return number;
}

void set_ending(const Database& database, std::int64_t session, const std::string& ending) {
  database.prepare("UPDATE sessions SET ending = ? WHERE session = ?").run(ending, session);
}

std::vector<StoredSession> all_of(const Database& database) {
  std::vector<StoredSession> list;
  Statement rows = database.prepare(
      "SELECT date, command, moat_version, git_commit, engine, host, version, ending, ifnull(cases, 0) FROM sessions "
      "LEFT JOIN (SELECT session, count(*) AS cases FROM cases GROUP BY session) USING (session) ORDER BY session");
  while (rows.step()) {
    StoredSession& session = list.emplace_back();
    session.date = rows.text(0);
    session.command_line = rows.text(1);
    session.moat_version = rows.text(2);
    session.git_commit = rows.text(3);
    session.engine = rows.text(4);
    session.host = rows.text(5);
    session.version = static_cast<std::size_t>(rows.integer(6));
    session.ending = rows.text(7);
    session.cases = static_cast<std::size_t>(rows.integer(8));
  }
  return list;
}

}  // namespace moat::study_sessions
