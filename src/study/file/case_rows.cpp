#include "study/file/case_rows.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <tuple>

#include "base/error.hpp"
#include "base/sha256.hpp"
#include "study/outcome_bytes.hpp"

namespace moat {
namespace {

using sqlite::Database;
using sqlite::Statement;
using sqlite::Transaction;

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

/// It covers everything that the rows of a case hold.
std::string checksum_of(std::size_t number, const std::string& parameters, CaseOutcome outcome, std::int64_t session) {
  // They are read in this order.
  std::ranges::sort(outcome.files, {}, [](const FileRead& file) { return std::tie(file.path, file.sha256); });
  outcome.files.erase(std::unique(outcome.files.begin(), outcome.files.end()), outcome.files.end());
  return sha256_of(parameters + "\n" + std::to_string(session) + "\n" + std::to_string(number) + "\n" +
                   to_bytes(outcome));
}

StoredCases read_rows(const Database& database, const StudyCases& cases) {
  StoredCases stored{.result = StudyResult{cases}, .sessions = std::vector<std::int64_t>(cases.count(), 0)};
  const auto change = [&](std::int64_t number, const auto& make_change) {
    if (number < 0 || static_cast<std::size_t>(number) >= cases.count()) {
      stored.changed.insert(number);
      return;
    }
    CaseOutcome outcome = stored.result.outcome(static_cast<std::size_t>(number));
    make_change(outcome);
    stored.result.set(static_cast<std::size_t>(number), std::move(outcome));
  };
  Statement files = database.prepare(
      "SELECT number, path, sha256 FROM case_files JOIN files USING (file) ORDER BY number, path, sha256");
  while (files.step())
    change(files.integer(0), [&](CaseOutcome& outcome) { outcome.files.push_back({files.text(1), files.text(2)}); });
  std::map<std::int64_t, NamedNumber> names;
  Statement name = database.prepare("SELECT result, quantity, place, unit FROM result_names");
  while (name.step()) names[name.integer(0)] = {name.text(1), name.text(2), name.text(3)};
  Statement values = database.prepare("SELECT number, result, value FROM results ORDER BY number, position");
  for (bool more = values.step(); more;) {
    const std::int64_t number = values.integer(0);
    StudyRecord of_case;
    for (; more && values.integer(0) == number; more = values.step()) {
      of_case.push_back(names[values.integer(1)]);
      of_case.back().value = values.real(2);
    }
    change(number, [&](CaseOutcome& outcome) { std::ranges::move(of_case, std::back_inserter(outcome.results)); });
  }
  // The rows come last, so that each is compared with all that belongs to it.
  Statement rows = database.prepare(
      "SELECT number, state, reason, steps, energy_error, seconds, session, parameters, checksum FROM cases");
  while (rows.step())
    change(rows.integer(0), [&](CaseOutcome& outcome) {
      for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged})
        if (name_of(state) == rows.text(1)) outcome.state = state;
      outcome.reason = rows.text(2);
      outcome.steps = rows.integer(3);
      outcome.energy_error = rows.real(4);
      outcome.seconds = rows.real(5);
      const auto number = static_cast<std::size_t>(rows.integer(0));
      stored.sessions[number] = rows.integer(6);
      const std::string parameters = parameters_of(cases, number);
      if (outcome.state == CaseState::open || rows.text(7) != parameters ||
          rows.text(8) != checksum_of(number, parameters, outcome, rows.integer(6)))
        stored.changed.insert(rows.integer(0));
    });
  // A case without a row has neither results nor files.
  for (std::size_t number = 0; number < cases.count(); ++number)
    if (stored.result.state(number) == CaseState::open)
      if (const CaseOutcome outcome = stored.result.outcome(number); !outcome.results.empty() || !outcome.files.empty())
        stored.changed.insert(static_cast<std::int64_t>(number));
  return stored;
}

}  // namespace

CaseRows::CaseRows(const Database& database, const StudyCases& cases)
    : database_{&database},
      cases_{&cases},
      row_{database.prepare("INSERT INTO cases VALUES (?, ?, ?, ?, ?, ?, ?, ?, ?)")},
      name_{database.prepare("INSERT INTO result_names SELECT ifnull(max(result) + 1, 0), ?, ?, ? FROM result_names "
                             "WHERE true ON CONFLICT DO NOTHING")},
      value_{database.prepare("INSERT INTO results SELECT ?, ?, result, ? FROM result_names "
                              "WHERE quantity = ? AND place = ? AND unit = ?")},
      file_{database.prepare("INSERT INTO files (path, sha256) VALUES (?, ?)")},
      known_file_{database.prepare("SELECT file, sha256 FROM files WHERE path = ? ORDER BY file DESC LIMIT 1")},
      case_file_{database.prepare("INSERT INTO case_files VALUES (?, ?) ON CONFLICT DO NOTHING")} {}

void CaseRows::write(std::size_t number, const CaseOutcome& outcome, std::int64_t session) {
  Transaction transaction{*database_};
  put(number, outcome, session);
  for (const FileRead& file : outcome.files) case_file_.run(number, number_of(file));
  transaction.commit();
}

void CaseRows::put(std::size_t number, const CaseOutcome& outcome, std::int64_t session) {
  const std::string parameters = parameters_of(*cases_, number);
  row_.run(number, parameters, name_of(outcome.state), outcome.reason, outcome.steps, outcome.energy_error,
           outcome.seconds, session, checksum_of(number, parameters, outcome, session));
  for (std::size_t i = 0; i < outcome.results.size(); ++i) {
    const NamedNumber& result = outcome.results[i];
    name_.run(result.quantity, result.where, result.unit);
    value_.run(number, i, result.value, result.quantity, result.where, result.unit);
  }
}

void CaseRows::forget_failures() {
  const StoredCases stored = read_rows(*database_, *cases_);
  Transaction transaction{*database_};
  if (stored.changed.empty()) {
    database_->run("DELETE FROM cases WHERE state <> 'done'");
  } else {
    // A key that was damaged is not found by its number: the tables are written again with the cases that stay.
    database_->run("DELETE FROM results; DELETE FROM cases; DELETE FROM result_names");
    for (std::size_t number = 0; number < cases_->count(); ++number)
      if (stored.result.state(number) == CaseState::done && !stored.changed.contains(static_cast<std::int64_t>(number)))
        put(number, stored.result.outcome(number), stored.sessions[number]);
  }
  database_->run("DELETE FROM case_files WHERE number NOT IN (SELECT number FROM cases)");
  transaction.commit();
}

std::int64_t CaseRows::number_of(const FileRead& file) {
  known_file_.bind(file.path);
  if (!known_file_.step()) {
    file_.run(file.path, file.sha256);
    known_file_.step();
  }
  const std::int64_t number = known_file_.integer(0);
  const std::string known = known_file_.text(1);
  known_file_.step();  // to its end
  if (known != file.sha256)
    throw InputError{"study " + database_->file().string() + ": " + file.path +
                     " changed while the study ran, and results are not mixed. Restore the file and run the same "
                     "command again, or start again in another file."};
  return number;
}

namespace case_rows {

StoredCases read(const Database& database, const StudyCases& cases) {
  StoredCases stored = read_rows(database, cases);
  if (stored.changed.empty()) return stored;
  constexpr std::size_t most_named = 20;
  std::string numbers;
  for (std::size_t named = 0; const std::int64_t number : stored.changed)
    if (++named <= most_named) numbers += (named > 1 ? ", " : " ") + std::to_string(number);
  if (stored.changed.size() > most_named) numbers += " ... (" + std::to_string(stored.changed.size()) + " cases)";
  throw FileError{"study " + database.file().string() + ": the results of case" + numbers +
                  " are not those that were written: the file was changed or damaged. Run the script on this file with "
                  "--retry; it computes these cases again and keeps the others."};
}

std::vector<FileRead> files_of(const Database& database) {
  std::vector<FileRead> files;
  Statement rows = database.prepare(
      "SELECT path, sha256 FROM files WHERE file IN (SELECT max(file) FROM files GROUP BY path) ORDER BY path");
  while (rows.step()) files.push_back({rows.text(0), rows.text(1)});
  return files;
}

void accept_files(const Database& database, const std::vector<FileRead>& files) {
  // The row with the largest number is the one that the study goes on with.
  Statement row = database.prepare("INSERT INTO files (path, sha256) VALUES (?, ?)");
  for (const FileRead& file : files) row.run(file.path, file.sha256);
}

}  // namespace case_rows
}  // namespace moat
