#include "study/file/study_tables.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <utility>
#include <vector>

#include "base/error.hpp"

namespace moat::study_tables {
namespace {

using sqlite::Database;
using sqlite::Statement;

constexpr const char* format = "4";
constexpr std::size_t most_versions = 10'000;

constexpr const char* schema = R"(
CREATE TABLE study (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE axes (axis INTEGER PRIMARY KEY, name TEXT NOT NULL, unit TEXT NOT NULL, cases_group INTEGER NOT NULL);
CREATE TABLE axis_values (axis INTEGER, position INTEGER, value REAL NOT NULL, label TEXT NOT NULL,
                          PRIMARY KEY (axis, position)) WITHOUT ROWID;
CREATE TABLE versions (version INTEGER, name TEXT, value TEXT NOT NULL, PRIMARY KEY (version, name)) WITHOUT ROWID;
CREATE TABLE sessions (session INTEGER PRIMARY KEY, date TEXT, command TEXT, moat_version TEXT, git_commit TEXT,
                       engine TEXT, host TEXT, version INTEGER NOT NULL, ending TEXT NOT NULL);
CREATE TABLE files (file INTEGER PRIMARY KEY, path TEXT NOT NULL, sha256 TEXT NOT NULL);
CREATE TABLE cases (number INTEGER PRIMARY KEY, parameters TEXT NOT NULL, state TEXT NOT NULL, reason TEXT NOT NULL,
                    steps INTEGER NOT NULL, energy_error REAL, seconds REAL NOT NULL, session INTEGER NOT NULL,
                    checksum TEXT NOT NULL);
CREATE TABLE case_files (number INTEGER, file INTEGER, PRIMARY KEY (number, file)) WITHOUT ROWID;
CREATE TABLE result_names (result INTEGER PRIMARY KEY, quantity TEXT NOT NULL, place TEXT NOT NULL, unit TEXT NOT NULL,
                           UNIQUE (quantity, place, unit));
CREATE TABLE results (number INTEGER, position INTEGER, result INTEGER NOT NULL, value REAL,
                      PRIMARY KEY (number, position)) WITHOUT ROWID;
CREATE VIEW case_results AS SELECT number, quantity, place, unit, value FROM results JOIN result_names USING (result);
CREATE VIEW case_versions AS SELECT number, version, session, date, moat_version, git_commit FROM cases
                             JOIN sessions USING (session);
)";

constexpr std::string_view remedy_of_damage = ". The file is damaged: restore a copy, or start again in another file.";

[[noreturn]] void refuse(const Database& database, const std::string& problem) {
  throw FileError{"study " + database.file().string() + ": " + problem};
}

}  // namespace

bool exist_in(const Database& database) {
  Statement tables = database.prepare("SELECT count(*) FROM sqlite_master");
  tables.step();
  if (tables.integer(0) == 0) return false;
  Statement known = database.prepare("SELECT count(*) FROM sqlite_master WHERE name IN ('study', 'cases', 'results')");
  known.step();
  if (known.integer(0) != 3) refuse(database, "this is another database. Give another file.");
  if (const std::string found = property(database, "format"); found != format)
    refuse(database, "its format is " + found + ", and this moat reads " + format +
                         ". Use the moat that made it, or start again in another file.");
  return true;
}

void create(const Database& database, const StudyCases& cases, const std::string& title) {
  database.run(schema);
  set_property(database, "format", format);
  set_property(database, "title", title);
  set_property(database, "cases", std::to_string(cases.count()));
  Statement row = database.prepare("INSERT INTO axes VALUES (?, ?, ?, ?)");
  Statement entry = database.prepare("INSERT INTO axis_values VALUES (?, ?, ?, ?)");
  for (std::size_t i = 0; i < cases.axes().size(); ++i) {
    const StudyAxis& axis = cases.axes()[i];
    row.run(i, axis.name, axis.unit, cases.groups()[i]);
    for (std::size_t position = 0; position < axis.values.size(); ++position)
      entry.run(i, position, axis.values[position], axis.labels.empty() ? std::string{} : axis.labels[position]);
  }
}

StudyCases cases_of(const Database& database) {
  std::vector<StudyAxis> together;
  std::optional<StudyCases> cases;
  const auto end_group = [&] {
    if (together.empty()) return;
    const StudyCases group = StudyCases::list(std::exchange(together, {}));
    cases = cases ? cases->times(group) : group;
  };
  Statement axes = database.prepare("SELECT axis, name, unit, cases_group FROM axes ORDER BY axis");
  for (std::int64_t group = 0; axes.step();) {
    if (std::exchange(group, axes.integer(3)) != axes.integer(3)) end_group();
    StudyAxis axis{.name = axes.text(1), .unit = axes.text(2), .values = {}};
    Statement values = database.prepare("SELECT value, label FROM axis_values WHERE axis = ? ORDER BY position");
    values.bind(axes.integer(0));
    while (values.step()) {
      axis.values.push_back(values.real(0));
      axis.labels.push_back(values.text(1));
    }
    if (std::ranges::all_of(axis.labels, &std::string::empty)) axis.labels.clear();
    together.push_back(std::move(axis));
  }
  end_group();
  if (!cases) refuse(database, "it has no axes. Give another file.");
  return *cases;
}

std::string property(const Database& database, const std::string& key) {
  Statement row = database.prepare("SELECT value FROM study WHERE key = ?");
  row.bind(key);
  return row.step() ? row.text(0) : "";
}

void set_property(const Database& database, const std::string& key, const std::string& value) {
  database.prepare("INSERT INTO study VALUES (?, ?) ON CONFLICT (key) DO UPDATE SET value = excluded.value")
      .run(key, value);
}

std::vector<StudyIdentity> versions_of(const Database& database) {
  // A version may have no rows: a study may depend on its axes alone.
  std::vector<StudyIdentity> versions(current_version(database) + 1);
  Statement rows = database.prepare(
      "SELECT version, name, value FROM versions UNION SELECT version, '', '' FROM sessions ORDER BY version, name");
  while (rows.step()) {
    const auto version = static_cast<std::size_t>(rows.integer(0));  // above all if it is negative
    if (version > most_versions) refuse(database, "it has a version " + rows.text(0) + std::string{remedy_of_damage});
    if (version >= versions.size()) versions.resize(version + 1);
    if (const std::string name = rows.text(1); !name.empty()) versions[version].emplace(name, rows.text(2));
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
  const std::string text = property(database, "version");
  std::size_t version = 0;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), version);
  if (text.empty() || (failure == std::errc{} && end == text.data() + text.size() && version <= most_versions))
    return version;
  refuse(database,
         "its version is \"" + text + "\"; it must be a whole number up to 10000" + std::string{remedy_of_damage});
}

void set_current_version(const Database& database, std::size_t version) {
  set_property(database, "version", std::to_string(version));
}

std::int64_t add_session(const Database& database, const StoredSession& session) {
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

std::vector<StoredSession> sessions_of(const Database& database) {
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

}  // namespace moat::study_tables
