#include "study/store.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <tuple>

#include "base/check.hpp"
#include "base/error.hpp"
#include "base/sha256.hpp"
#include "study/sqlite.hpp"

namespace moat {
namespace {

namespace fs = std::filesystem;
using sqlite::Database;
using sqlite::Statement;
using sqlite::Transaction;

constexpr const char* format = "1";
constexpr const char* identity_key = "identity.";

constexpr const char* schema = R"(
CREATE TABLE study (key TEXT PRIMARY KEY, value TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE axes (axis INTEGER PRIMARY KEY, name TEXT NOT NULL, unit TEXT NOT NULL, cases_group INTEGER NOT NULL);
CREATE TABLE axis_values (axis INTEGER, position INTEGER, value REAL NOT NULL, label TEXT, sha256 TEXT,
                          PRIMARY KEY (axis, position)) WITHOUT ROWID;
CREATE TABLE sessions (session INTEGER PRIMARY KEY, date TEXT, command TEXT, moat_version TEXT, git_commit TEXT,
                       engine TEXT, host TEXT);
CREATE TABLE records (path TEXT PRIMARY KEY, sha256 TEXT NOT NULL) WITHOUT ROWID;
CREATE TABLE cases (number INTEGER PRIMARY KEY, parameters TEXT NOT NULL, state TEXT NOT NULL, reason TEXT NOT NULL,
                    record TEXT NOT NULL, steps INTEGER NOT NULL, energy_error REAL, seconds REAL NOT NULL,
                    session INTEGER NOT NULL);
CREATE TABLE result_names (result INTEGER PRIMARY KEY, quantity TEXT NOT NULL, place TEXT NOT NULL, unit TEXT NOT NULL,
                           UNIQUE (quantity, place, unit));
CREATE TABLE results (number INTEGER, position INTEGER, result INTEGER NOT NULL, value REAL,
                      PRIMARY KEY (number, position)) WITHOUT ROWID;
CREATE VIEW case_results AS SELECT number, quantity, place, unit, value FROM results JOIN result_names USING (result);
)";

CaseState state_named(const std::string& name, const fs::path& file) {
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged})
    if (name_of(state) == name) return state;
  throw FileError{"study " + file.string() + ": a case has the unknown state \"" + name + "\". Give another file."};
}

std::string host_name() {
  std::array<char, 256> name{};
  return ::gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

/// {"gap [cm]": 12.5, "record": "KBU000"}
std::string parameters_of(const StudyCases& cases, std::size_t number) {
  nlohmann::ordered_json parameters;
  const StudyCase each{cases, number};
  for (const StudyAxis& axis : cases.axes()) {
    const std::string name = axis.unit.empty() || !axis.labels.empty() ? axis.name : axis.name + " [" + axis.unit + "]";
    if (axis.labels.empty())
      parameters[name] = each.value(axis.name);
    else
      parameters[name] = each.label(axis.name);
  }
  return parameters.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

/// Held until the process ends, however it ends.
class FileLock {
 public:
  explicit FileLock(const fs::path& file) {
    fs::path path = file;
    path += ".lock";
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
    if (descriptor_ < 0)
      throw FileError{"study " + file.string() + ": " + path.string() +
                      " cannot be made. Give a file in a folder that exists and can be written."};
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      ::close(descriptor_);
      throw InputError{"study " + file.string() +
                       ": another process computes it now. Wait for its end, or give another file."};
    }
  }
  ~FileLock() { ::close(descriptor_); }
  FileLock(const FileLock&) = delete;
  FileLock& operator=(const FileLock&) = delete;

 private:
  int descriptor_;
};

bool holds_study(const Database& database) {
  Statement tables = database.prepare("SELECT count(*) FROM sqlite_master");
  tables.step();
  if (tables.integer(0) == 0) return false;
  Statement known = database.prepare("SELECT count(*) FROM sqlite_master WHERE name IN ('study', 'cases', 'results')");
  known.step();
  if (known.integer(0) != 3)
    throw FileError{"study " + database.file().string() + ": this is another database. Give another file."};
  return true;
}

std::vector<std::pair<std::string, std::string>> properties_of(const Database& database) {
  std::vector<std::pair<std::string, std::string>> list;
  Statement rows = database.prepare("SELECT key, value FROM study ORDER BY key");
  while (rows.step()) list.emplace_back(rows.text(0), rows.text(1));
  return list;
}

struct Layout {
  std::vector<StudyAxis> axes;
  std::vector<std::size_t> groups;
};

Layout layout_of(const Database& database) {
  Layout layout;
  Statement axes = database.prepare("SELECT axis, name, unit, cases_group FROM axes ORDER BY axis");
  while (axes.step()) {
    StudyAxis axis{.name = axes.text(1), .unit = axes.text(2), .values = {}};
    Statement values =
        database.prepare("SELECT value, label, sha256 FROM axis_values WHERE axis = ? ORDER BY position");
    values.bind(1, axes.integer(0));
    while (values.step()) {
      axis.values.push_back(values.real(0));
      axis.labels.push_back(values.text(1));
      axis.hashes.push_back(values.text(2));
    }
    const auto all_empty = [](const std::vector<std::string>& texts) {
      return std::ranges::all_of(texts, &std::string::empty);
    };
    if (all_empty(axis.labels)) axis.labels.clear();
    if (all_empty(axis.hashes)) axis.hashes.clear();
    layout.axes.push_back(std::move(axis));
    layout.groups.push_back(static_cast<std::size_t>(axes.integer(3)));
  }
  return layout;
}

StudyCases cases_of(const Database& database) {
  Layout layout = layout_of(database);
  std::optional<StudyCases> cases;
  for (std::size_t i = 0; i < layout.axes.size();) {
    std::vector<StudyAxis> together;
    const std::size_t group = layout.groups[i];
    for (; i < layout.axes.size() && layout.groups[i] == group; ++i) together.push_back(std::move(layout.axes[i]));
    const StudyCases part = StudyCases::list(std::move(together));
    cases = cases ? cases->times(part) : part;
  }
  if (!cases) throw FileError{"study " + database.file().string() + ": it has no axes. Give another file."};
  return *cases;
}

void create(const Database& database, const StudyCases& cases, const StudyIdentity& identity,
            const std::string& title) {
  Transaction transaction{database};
  database.run(schema);
  Statement property = database.prepare("INSERT INTO study VALUES (?, ?)");
  const auto put = [&](const std::string& key, const std::string& value) {
    property.bind(1, key).bind(2, value).run();
  };
  put("format", format);
  put("title", title);
  put("cases", std::to_string(cases.count()));
  for (const auto& [name, value] : identity) put(identity_key + name, value);
  Statement row = database.prepare("INSERT INTO axes VALUES (?, ?, ?, ?)");
  Statement entry = database.prepare("INSERT INTO axis_values VALUES (?, ?, ?, ?, ?)");
  for (std::size_t i = 0; i < cases.axes().size(); ++i) {
    const StudyAxis& axis = cases.axes()[i];
    const auto number = static_cast<std::int64_t>(i);
    row.bind(1, number).bind(2, axis.name).bind(3, axis.unit);
    row.bind(4, static_cast<std::int64_t>(cases.groups()[i])).run();
    for (std::size_t position = 0; position < axis.values.size(); ++position) {
      entry.bind(1, number).bind(2, static_cast<std::int64_t>(position)).bind(3, axis.values[position]);
      entry.bind(4, axis.labels.empty() ? "" : axis.labels[position]);
      entry.bind(5, axis.hashes.empty() ? "" : axis.hashes[position]).run();
    }
  }
  transaction.commit();
}

std::string shortened(const std::string& value) {
  constexpr std::size_t hash_length = 64, shown = 12;
  if (value.empty()) return "none";
  return value.size() == hash_length ? value.substr(0, shown) + "..." : value;
}

/// One line for each difference.
std::string axis_differences(const StudyCases& stored, const StudyCases& wanted) {
  const auto names = [](const StudyCases& cases) {
    std::string text;
    for (const StudyAxis& axis : cases.axes()) text += (text.empty() ? "" : ", ") + axis.name;
    return text;
  };
  if (names(stored) != names(wanted)) return "\n  axes: " + names(stored) + " -> " + names(wanted);
  std::string text;
  for (std::size_t i = 0; i < stored.axes().size(); ++i) {
    const StudyAxis &before = stored.axes()[i], &now = wanted.axes()[i];
    if (before.unit != now.unit) text += "\n  axis " + now.name + ": unit " + before.unit + " -> " + now.unit;
    if (before.values != now.values || before.labels != now.labels)
      text += "\n  axis " + now.name + ": its values (" + std::to_string(before.values.size()) + " -> " +
              std::to_string(now.values.size()) + ")";
    else if (before.hashes != now.hashes)
      for (std::size_t v = 0; v < now.values.size(); ++v)
        if (before.hashes.empty() || now.hashes.empty() || before.hashes[v] != now.hashes[v])
          text += "\n  " + now.name + " " + (now.labels.empty() ? to_text(now.values[v]) : now.labels[v]) +
                  ": the content of its file";
  }
  if (text.empty() && stored.groups() != wanted.groups()) text = "\n  the way in which axes are combined";
  return text;
}

std::string identity_differences(const std::vector<std::pair<std::string, std::string>>& properties,
                                 const StudyIdentity& wanted) {
  std::map<std::string, std::string> before, now{wanted.begin(), wanted.end()};
  for (const auto& [key, value] : properties)
    if (key.starts_with(identity_key)) before[key.substr(std::string{identity_key}.size())] = value;
  std::string text;
  for (const auto& [name, value] : now)
    if (!before.contains(name) || before[name] != value)
      text += "\n  " + name + ": " + shortened(before[name]) + " -> " + shortened(value);
  for (const auto& [name, value] : before)
    if (!now.contains(name)) text += "\n  " + name + ": " + shortened(value) + " -> none";
  return text;
}

std::string record_differences(const Database& database) {
  std::string text;
  Statement rows = database.prepare("SELECT path, sha256 FROM records ORDER BY path");
  while (rows.step())
    if (const auto now = sha256_of_file(rows.text(0)); now && *now != rows.text(1))
      text += "\n  record " + rows.text(0) + ": " + shortened(rows.text(1)) + " -> " + shortened(*now);
  return text;
}

[[noreturn]] void refuse(const fs::path& file, const std::string& differences) {
  throw InputError{"study " + file.string() +
                   " was begun with something else, and results are not mixed:" + differences +
                   "\nGive another file or folder, restore the former state, or remove the file and begin anew."};
}

void require_same_format(const Database& database) {
  for (const auto& [key, value] : properties_of(database))
    if (key == "format" && value != format)
      throw FileError{"study " + database.file().string() + ": its format is " + value + ", and this moat reads " +
                      format + ". Use the moat that made it, or begin anew in another file."};
}

std::vector<CaseOutcome> read_outcomes(const Database& database, std::size_t count) {
  std::vector<CaseOutcome> outcomes(count);
  const auto outcome_of_number = [&](std::int64_t number) -> CaseOutcome& {
    if (number < 0 || static_cast<std::size_t>(number) >= count)
      throw FileError{"study " + database.file().string() + ": it holds the case " + std::to_string(number) +
                      ", which its axes do not have. Give another file."};
    return outcomes[static_cast<std::size_t>(number)];
  };
  Statement rows = database.prepare(
      "SELECT number, state, reason, record, steps, energy_error, seconds, sha256 FROM cases "
      "LEFT JOIN records ON record = path");
  while (rows.step()) {
    CaseOutcome& outcome = outcome_of_number(rows.integer(0));
    outcome.state = state_named(rows.text(1), database.file());
    outcome.reason = rows.text(2);
    outcome.record = rows.text(3);
    outcome.steps = rows.integer(4);
    outcome.energy_error = rows.real(5);
    outcome.seconds = rows.real(6);
    outcome.record_sha256 = rows.text(7);
  }
  std::map<std::int64_t, NamedNumber> names;
  Statement name = database.prepare("SELECT result, quantity, place, unit FROM result_names");
  while (name.step()) names[name.integer(0)] = {name.text(1), name.text(2), name.text(3)};
  Statement values = database.prepare("SELECT number, result, value FROM results ORDER BY number, position");
  while (values.step()) {
    NamedNumber result = names[values.integer(1)];
    result.value = values.real(2);
    outcome_of_number(values.integer(0)).results.push_back(std::move(result));
  }
  return outcomes;
}

// A database made by a process that was killed before its first table existed is empty.
std::unique_ptr<Database> open_to_write(const fs::path& file) {
  std::error_code ignored;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  auto database = std::make_unique<Database>(file, Database::Access::write);
  database->run("PRAGMA journal_mode = WAL; PRAGMA synchronous = NORMAL;");
  return database;
}

}  // namespace

struct StudyStore::Parts {
  FileLock lock;
  StudyCases cases;
  std::unique_ptr<Database> database;
  std::int64_t session = 0;
  std::map<std::tuple<std::string, std::string, std::string>, std::int64_t> names{};
  std::optional<Statement> row{}, value{}, name{}, record{};

  Parts(const fs::path& file, const StudyCases& wanted) : lock{file}, cases{wanted}, database{open_to_write(file)} {}

  void open(const StudyIdentity& identity, const StudySession& from) {
    if (!holds_study(*database)) {
      create(*database, cases, identity, from.title);
    } else {
      require_same_format(*database);
      const std::string differences = axis_differences(cases_of(*database), cases) +
                                      identity_differences(properties_of(*database), identity) +
                                      record_differences(*database);
      if (!differences.empty()) refuse(database->file(), differences);
    }
    Statement begin = database->prepare(
        "INSERT INTO sessions (date, command, moat_version, git_commit, engine, host) VALUES (?, ?, ?, ?, ?, ?)");
    begin.bind(1, from.date).bind(2, from.command_line).bind(3, from.moat_version).bind(4, from.git_commit);
    begin.bind(5, from.engine).bind(6, host_name()).run();
    Statement last = database->prepare("SELECT max(session) FROM sessions");
    last.step();
    session = last.integer(0);
    Statement known = database->prepare("SELECT result, quantity, place, unit FROM result_names");
    while (known.step()) names[{known.text(1), known.text(2), known.text(3)}] = known.integer(0);
    row.emplace(database->prepare("INSERT INTO cases VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)"));
    value.emplace(database->prepare("INSERT INTO results VALUES (?, ?, ?, ?)"));
    name.emplace(database->prepare("INSERT INTO result_names VALUES (?, ?, ?, ?)"));
    record.emplace(database->prepare("INSERT INTO records VALUES (?, ?) ON CONFLICT DO NOTHING"));
  }

  std::int64_t number_of(const NamedNumber& result) {
    const auto next = static_cast<std::int64_t>(names.size());
    const auto [found, added] = names.try_emplace({result.quantity, result.where, result.unit}, next);
    if (added) {
      name->bind(1, next).bind(2, result.quantity).bind(3, result.where).bind(4, result.unit).run();
      added_names.push_back(found->first);
    }
    return found->second;
  }

  void put(std::size_t number, const CaseOutcome& outcome) {
    const auto id = static_cast<std::int64_t>(number);
    if (!outcome.record.empty()) put_record(outcome);
    row->bind(1, id).bind(2, parameters_of(cases, number)).bind(3, name_of(outcome.state)).bind(4, outcome.reason);
    row->bind(5, outcome.record).bind(6, static_cast<std::int64_t>(outcome.steps)).bind(7, outcome.energy_error);
    row->bind(8, outcome.seconds).bind(9, session).run();
    for (std::size_t i = 0; i < outcome.results.size(); ++i) {
      const NamedNumber& result = outcome.results[i];
      value->bind(1, id).bind(2, static_cast<std::int64_t>(i)).bind(3, number_of(result)).bind(4, result.value).run();
    }
  }

  // Names of a transaction that was undone are not in the file.
  std::vector<std::tuple<std::string, std::string, std::string>> added_names{};

 private:
  std::map<std::string, std::string> known_records_{};

  void put_record(const CaseOutcome& outcome) {
    const auto known = known_records_.find(outcome.record);
    if (known == known_records_.end()) {
      record->bind(1, outcome.record).bind(2, outcome.record_sha256).run();
      Statement stored = database->prepare("SELECT sha256 FROM records WHERE path = ?");
      stored.bind(1, outcome.record);
      stored.step();
      known_records_[outcome.record] = stored.text(0);
    }
    if (known_records_[outcome.record] != outcome.record_sha256)
      refuse(database->file(), "\n  record " + outcome.record + ": " + shortened(known_records_[outcome.record]) +
                                   " -> " + shortened(outcome.record_sha256));
  }
};

StudyStore::StudyStore(const fs::path& file, const StudyCases& cases, const StudyIdentity& identity,
                       const StudySession& session) {
  std::error_code ignored;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), ignored);
  parts_ = std::make_unique<Parts>(file, cases);
  parts_->open(identity, session);
}

StudyStore::~StudyStore() = default;

std::vector<CaseOutcome> StudyStore::outcomes() const {
  return read_outcomes(*parts_->database, parts_->cases.count());
}

void StudyStore::write(std::size_t number, const CaseOutcome& outcome) {
  Transaction transaction{*parts_->database};
  parts_->added_names.clear();
  try {
    parts_->put(number, outcome);
    transaction.commit();
  } catch (...) {
    for (const auto& name : parts_->added_names) parts_->names.erase(name);
    throw;
  }
}

void StudyStore::forget_failures() {
  Transaction transaction{*parts_->database};
  parts_->database->run("DELETE FROM cases WHERE state <> 'done'");
  transaction.commit();
}

StoredStudy read_study(const fs::path& file) {
  if (!fs::is_regular_file(file)) throw FileError{"study " + file.string() + ": there is no such file."};
  const Database database{file, Database::Access::read};
  if (!holds_study(database)) throw FileError{"study " + file.string() + ": the file is empty. Give another file."};
  require_same_format(database);
  const StudyCases cases = cases_of(database);
  StoredStudy study{properties_of(database), {}, StudyResult{cases, read_outcomes(database, cases.count())}};
  Statement rows =
      database.prepare("SELECT date, command, moat_version, git_commit, engine FROM sessions ORDER BY session");
  while (rows.step())
    study.sessions.push_back({.title = {},
                              .command_line = rows.text(1),
                              .moat_version = rows.text(2),
                              .git_commit = rows.text(3),
                              .date = rows.text(0),
                              .engine = rows.text(4)});
  return study;
}

namespace {

bool same_bits(double a, double b) { return (std::isnan(a) && std::isnan(b)) || a == b; }

bool equal(const CaseOutcome& a, const CaseOutcome& b) {
  if (a.state != b.state || a.reason != b.reason || a.results.size() != b.results.size()) return false;
  return std::ranges::all_of(a.results, [&](const NamedNumber& result) {
    return std::ranges::any_of(b.results, [&](const NamedNumber& other) {
      return result.quantity == other.quantity && result.where == other.where && same_bits(result.value, other.value);
    });
  });
}

StudyIdentity identity_of(const StoredStudy& study) {
  StudyIdentity identity;
  for (const auto& [key, value] : study.properties)
    if (key.starts_with(identity_key)) identity.emplace_back(key.substr(std::string{identity_key}.size()), value);
  return identity;
}

}  // namespace

void merge_studies(const fs::path& into, const std::vector<fs::path>& parts) {
  Check{"merge", ""}.that(!parts.empty(), "there is nothing to merge.", "Give the files of the parts.");
  for (const fs::path& file : parts) {
    const StoredStudy part = read_study(file);
    StudySession session = part.sessions.empty() ? StudySession{} : part.sessions.back();
    for (const auto& [key, value] : part.properties)
      if (key == "title") session.title = value;
    StudyStore store{into, part.result.cases(), identity_of(part), session};
    const std::vector<CaseOutcome> known = store.outcomes();
    for (std::size_t number = 0; number < known.size(); ++number) {
      const CaseOutcome& outcome = part.result.outcomes()[number];
      if (outcome.state == CaseState::open) continue;
      if (known[number].state == CaseState::open)
        store.write(number, outcome);
      else if (!equal(known[number], outcome))
        throw InputError{"merge: case " + std::to_string(number) + " of " + file.string() +
                         " differs from the one in " + into.string() +
                         ". Equal cases have equal results: find out which file is wrong."};
    }
  }
}

}  // namespace moat
