#include "study/case_rows.hpp"

#include <nlohmann/json.hpp>

#include "base/error.hpp"

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

CaseState state_named(const std::string& name, const Database& database) {
  for (const CaseState state : {CaseState::done, CaseState::failed, CaseState::not_converged})
    if (name_of(state) == name) return state;
  throw FileError{"study " + database.file().string() + ": a case has the unknown state \"" + name +
                  "\". Give another file."};
}

std::size_t index_of(std::int64_t number, std::size_t count, const Database& database) {
  if (number < 0 || static_cast<std::size_t>(number) >= count)
    throw FileError{"study " + database.file().string() + ": it holds the case " + std::to_string(number) +
                    ", which its axes do not have. Give another file."};
  return static_cast<std::size_t>(number);
}

}  // namespace

CaseRows::CaseRows(const Database& database, const StudyCases& cases)
    : database_{&database},
      cases_{&cases},
      row_{database.prepare("INSERT INTO cases VALUES (?, ?, ?, ?, ?, ?, ?, ?)")},
      value_{database.prepare("INSERT INTO results VALUES (?, ?, ?, ?)")},
      name_{database.prepare("INSERT INTO result_names VALUES (?, ?, ?, ?)")},
      file_{database.prepare("INSERT INTO files VALUES (?, ?, ?)")},
      case_file_{database.prepare("INSERT INTO case_files VALUES (?, ?) ON CONFLICT DO NOTHING")} {
  read_known();
}

void CaseRows::read_known() {
  names_.clear();
  files_.clear();
  Statement names = database_->prepare("SELECT result, quantity, place, unit FROM result_names");
  while (names.step()) names_[{names.text(1), names.text(2), names.text(3)}] = names.integer(0);
  Statement files = database_->prepare("SELECT file, path, sha256 FROM files ORDER BY file");
  while (files.step()) files_[files.text(1)] = {files.integer(0), files.text(2)};
}

void CaseRows::write(std::size_t number, const CaseOutcome& outcome, std::int64_t session) {
  Transaction transaction{*database_};
  const std::size_t names = names_.size(), files = files_.size();
  try {
    put(number, outcome, session);
    transaction.commit();
  } catch (...) {
    transaction.undo();
    // Names and files of a transaction that was undone are not in the file.
    if (names_.size() > names || files_.size() > files) read_known();
    throw;
  }
}

void CaseRows::put(std::size_t number, const CaseOutcome& outcome, std::int64_t session) {
  const auto id = static_cast<std::int64_t>(number);
  row_.bind(1, id).bind(2, parameters_of(*cases_, number)).bind(3, name_of(outcome.state)).bind(4, outcome.reason);
  row_.bind(5, static_cast<std::int64_t>(outcome.steps)).bind(6, outcome.energy_error).bind(7, outcome.seconds);
  row_.bind(8, session).run();
  for (const FileRead& file : outcome.files) case_file_.bind(1, id).bind(2, number_of(file)).run();
  for (std::size_t i = 0; i < outcome.results.size(); ++i) {
    const NamedNumber& result = outcome.results[i];
    value_.bind(1, id).bind(2, static_cast<std::int64_t>(i)).bind(3, number_of(result)).bind(4, result.value).run();
  }
}

std::int64_t CaseRows::number_of(const NamedNumber& result) {
  const auto next = static_cast<std::int64_t>(names_.size());
  const auto [found, added] = names_.try_emplace({result.quantity, result.where, result.unit}, next);
  if (added) name_.bind(1, next).bind(2, result.quantity).bind(3, result.where).bind(4, result.unit).run();
  return found->second;
}

std::int64_t CaseRows::number_of(const FileRead& file) {
  const auto known = files_.find(file.path);
  if (known == files_.end()) {
    Statement last = database_->prepare("SELECT ifnull(max(file), 0) FROM files");
    last.step();
    const std::int64_t number = last.integer(0) + 1;
    file_.bind(1, number).bind(2, file.path).bind(3, file.sha256).run();
    files_[file.path] = {number, file.sha256};
    return number;
  }
  if (known->second.sha256 != file.sha256)
    throw InputError{"study " + database_->file().string() + ": " + file.path +
                     " changed while the study ran, and results are not mixed. Restore the file and run the same "
                     "command again, or start again in another file."};
  return known->second.number;
}

namespace case_rows {

std::vector<CaseOutcome> read_outcomes(const Database& database, std::size_t count) {
  std::vector<CaseOutcome> outcomes(count);
  const auto outcome_of_number = [&](std::int64_t number) -> CaseOutcome& {
    return outcomes[index_of(number, count, database)];
  };
  Statement rows = database.prepare("SELECT number, state, reason, steps, energy_error, seconds FROM cases");
  while (rows.step()) {
    CaseOutcome& outcome = outcome_of_number(rows.integer(0));
    outcome.state = state_named(rows.text(1), database);
    outcome.reason = rows.text(2);
    outcome.steps = rows.integer(3);
    outcome.energy_error = rows.real(4);
    outcome.seconds = rows.real(5);
  }
  Statement files =
      database.prepare("SELECT number, path, sha256 FROM case_files JOIN files USING (file) ORDER BY number, file");
  while (files.step()) outcome_of_number(files.integer(0)).files.push_back({files.text(1), files.text(2)});
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

std::vector<std::int64_t> sessions_of_cases(const Database& database, std::size_t count) {
  std::vector<std::int64_t> sessions(count, 0);
  Statement rows = database.prepare("SELECT number, session FROM cases");
  while (rows.step()) sessions[index_of(rows.integer(0), count, database)] = rows.integer(1);
  return sessions;
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
  for (const FileRead& file : files) row.bind(1, file.path).bind(2, file.sha256).run();
}

void forget_failures(const Database& database) {
  Transaction transaction{database};
  database.run(
      "DELETE FROM case_files WHERE number IN (SELECT number FROM cases WHERE state <> 'done');"
      "DELETE FROM cases WHERE state <> 'done'");
  transaction.commit();
}

}  // namespace case_rows
}  // namespace moat
