#include "study/result.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "base/check.hpp"

namespace moat {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

void add_axes(Table& table, const StudyCases& cases) {
  for (std::size_t i = 0; i < cases.axes().size(); ++i) {
    const StudyAxis& axis = cases.axes()[i];
    Column column{axis.name, "", axis.unit.empty() ? "1" : axis.unit, {}};
    for (std::size_t number = 0; number < cases.count(); ++number) {
      const std::size_t position = cases.position(i, number);
      column.values.push_back(axis.values[position]);
      if (!axis.labels.empty()) column.labels.push_back(axis.labels[position]);
    }
    table.columns.push_back(std::move(column));
  }
}

// Cases may have different results (buildings of different height): a column for each that any case has, and one for
// each unit, so that no numbers of two units are mixed.
void add_results(Table& table, const std::vector<CaseOutcome>& outcomes) {
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> column_of;
  for (std::size_t number = 0; number < outcomes.size(); ++number) {
    for (const NamedNumber& each : outcomes[number].results) {
      const auto [found, added] = column_of.try_emplace({each.quantity, each.where, each.unit}, table.columns.size());
      if (added) table.columns.push_back({each.quantity, each.where, each.unit, std::vector(outcomes.size(), unknown)});
      table.columns[found->second].values[number] = each.value;
    }
  }
}

Table table_of(const StudyCases& cases, const std::vector<CaseOutcome>& outcomes) {
  Table table;
  add_axes(table, cases);
  add_results(table, outcomes);
  return table;
}

std::string stopped_message(const StudyResult& result) {
  const std::size_t all = result.cases().count();
  return "The study was stopped: " + std::to_string(all - result.count(CaseState::open)) + " of " +
         std::to_string(all) + " cases are computed.";
}

}  // namespace

std::string_view name_of(CaseState state) {
  switch (state) {
    case CaseState::done:
      return "done";
    case CaseState::failed:
      return "failed";
    case CaseState::not_converged:
      return "not converged";
    case CaseState::open:
      break;
  }
  return "open";
}

double value_of(const StudyRecord& record, std::string_view quantity, std::string_view where) {
  for (const NamedNumber& each : record)
    if (each.quantity == quantity && each.where == where) return each.value;
  throw InputError{"There is no result \"" + std::string{quantity} + "\" of \"" + std::string{where} +
                   "\". Give quantity and place as the table of results writes them."};
}

StudyResult::StudyResult(const StudyResult& other) = default;
StudyResult::StudyResult(StudyResult&& other) noexcept = default;
StudyResult& StudyResult::operator=(const StudyResult& other) = default;
StudyResult& StudyResult::operator=(StudyResult&& other) noexcept = default;
StudyResult::~StudyResult() = default;

StudyResult::StudyResult(StudyCases cases, std::vector<CaseOutcome> outcomes)
    : cases_{std::move(cases)}, outcomes_{std::move(outcomes)}, table_{table_of(cases_, outcomes_)} {}

Table StudyResult::case_table() const {
  Table table;
  table.columns.push_back({"case", "", "1", {}});
  for (std::size_t number = 0; number < outcomes_.size(); ++number)
    table.columns.front().values.push_back(static_cast<double>(number));
  add_axes(table, cases_);
  Column state{"state", "", "1", {}}, reason{"reason", "", "1", {}}, steps{"steps", "", "1", {}},
      error{"energy_error", "", "1", {}}, seconds{"seconds", "", "s", {}};
  for (const CaseOutcome& outcome : outcomes_) {
    state.values.push_back(static_cast<double>(outcome.state));
    state.labels.emplace_back(name_of(outcome.state));
    reason.values.push_back(unknown);
    reason.labels.push_back(outcome.reason);
    steps.values.push_back(static_cast<double>(outcome.steps));
    error.values.push_back(outcome.energy_error);
    seconds.values.push_back(outcome.seconds);
  }
  for (Column* column : {&state, &reason, &steps, &error, &seconds}) table.columns.push_back(std::move(*column));
  add_results(table, outcomes_);
  return table;
}

std::size_t StudyResult::count(CaseState state) const {
  return static_cast<std::size_t>(std::ranges::count(outcomes_, state, &CaseOutcome::state));
}

std::vector<std::size_t> StudyResult::numbers(const Fixed& fixed) const {
  std::vector<std::pair<std::size_t, std::size_t>> held;  // axis, position
  for (const auto& [name, position] : fixed) held.emplace_back(cases_.index_of(name), position);
  std::vector<std::size_t> chosen;
  for (std::size_t number = 0; number < outcomes_.size(); ++number)
    if (std::ranges::all_of(held, [&](const auto& each) { return cases_.position(each.first, number) == each.second; }))
      chosen.push_back(number);
  return chosen;
}

std::vector<double> StudyResult::values(std::string_view quantity, std::string_view where, const Fixed& fixed) const {
  const auto is_meant = [&](const Column& each) { return each.quantity == quantity && each.where == where; };
  const auto column =
      std::find_if(table_.columns.begin() + static_cast<std::ptrdiff_t>(axes().size()), table_.columns.end(), is_meant);
  const std::string name = "\"" + std::string{quantity} + "\" of \"" + std::string{where} + "\"";
  if (column == table_.columns.end()) throw InputError{"The study has no result " + name + "."};
  if (const auto other = std::find_if(column + 1, table_.columns.end(), is_meant); other != table_.columns.end())
    throw InputError{"The result " + name + " has the unit " + column->unit + " in some cases and " + other->unit +
                     " in others. Give it one unit, or two names."};
  std::vector<double> chosen;
  for (const std::size_t number : numbers(fixed)) chosen.push_back(column->values[number]);
  return chosen;
}

std::vector<StudyError::Failure> failures_of(const StudyResult& result) {
  std::vector<StudyError::Failure> failures;
  for (std::size_t number = 0; number < result.outcomes().size(); ++number) {
    const CaseOutcome& outcome = result.outcomes()[number];
    if (outcome.state == CaseState::failed || outcome.state == CaseState::not_converged)
      failures.push_back({number, StudyCase{result.cases(), number}.description(), outcome.reason});
  }
  return failures;
}

std::string failure_message(const StudyResult& result) {
  constexpr std::size_t most_listed = 5;
  const std::vector<StudyError::Failure> failures = failures_of(result);
  if (failures.empty()) return "";
  const std::size_t without_solution = result.count(CaseState::not_converged);
  std::string text =
      std::to_string(failures.size()) + " of " + std::to_string(result.cases().count()) + " cases failed";
  if (without_solution > 0) text += ", " + std::to_string(without_solution) + " of them did not converge";
  text += ".";
  for (std::size_t i = 0; i < std::min(most_listed, failures.size()); ++i)
    text +=
        "\n  case " + std::to_string(failures[i].number) + ", " + failures[i].description + ": " + failures[i].message;
  if (failures.size() > most_listed) text += "\n  ... and " + std::to_string(failures.size() - most_listed) + " more";
  return text;
}

StudyError::StudyError(StudyResult computed)
    : Error{failure_message(computed)}, failures{failures_of(computed)}, result{std::move(computed)} {}

StudyStopped::StudyStopped(StudyResult computed) : Error{stopped_message(computed)}, result{std::move(computed)} {}

}  // namespace moat
