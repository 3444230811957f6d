#include "study/result.hpp"

#include <algorithm>
#include <boost/flyweight.hpp>
#include <limits>
#include <map>
#include <ostream>
#include <span>
#include <tuple>

#include "base/check.hpp"
#include "output/files/csv_writer.hpp"
#include "output/files/file_io.hpp"

namespace moat {

/// For boost::flyweight, which keeps equal lists of files once.
static std::size_t hash_value(const FileRead& file) { return boost::hash_value(file.sha256); }

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

// The outcome of a case, whose results are in the table.
struct KeptOutcome {
  CaseOutcome rest{};
  boost::flyweight<std::vector<FileRead>> files{};
  std::size_t results = 0;  // index of a list of them
};

// A result that any case has.
struct KnownResult {
  std::pair<std::size_t, std::size_t> first;  // case with it, and the place among its results
  std::size_t column = 0;                     // of the table
};

Table table_of_axes(const StudyCases& cases) {
  Table table;
  for (std::size_t i = 0; i < cases.axes().size(); ++i) {
    const StudyAxis& axis = cases.axes()[i];
    Column column{axis.name, "", axis.unit.empty() ? "1" : axis.unit, {}};
    column.values.reserve(cases.count());
    column.labels.reserve(axis.labels.empty() ? 0 : cases.count());
    for (std::size_t number = 0; number < cases.count(); ++number) {
      const std::size_t position = cases.position(i, number);
      column.values.push_back(axis.values[position]);
      if (!axis.labels.empty()) column.labels.push_back(axis.labels[position]);
    }
    table.columns.push_back(std::move(column));
  }
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

struct StudyResult::Contents {
  explicit Contents(StudyCases all)
      : cases{std::move(all)}, table{table_of_axes(cases)}, outcomes(cases.count()), lists(1) {}

  // Cases may have different results (buildings of different height), and one result for each unit, so that no numbers
  // of two units are mixed.
  std::size_t index_of(const NamedNumber& result) {
    const auto [found, added] = indices.try_emplace({result.quantity, result.where, result.unit}, known.size());
    if (added) {
      known.push_back({{cases.count(), 0}, table.columns.size()});
      table.columns.push_back({result.quantity, result.where, result.unit, std::vector(cases.count(), unknown)});
    }
    return found->second;
  }

  // The columns stand as the cases bring them in their order, whichever case ended first.
  void arrange_columns() {
    std::vector<KnownResult*> in_order;
    for (KnownResult& each : known) in_order.push_back(&each);
    std::ranges::stable_sort(in_order, {}, &KnownResult::first);
    std::vector<Column> results;
    for (KnownResult* each : in_order) {
      results.push_back(std::move(table.columns[each->column]));
      each->column = cases.axes().size() + results.size() - 1;
    }
    std::ranges::move(results, table.columns.end() - std::ssize(results));
  }

  StudyCases cases;
  Table table;
  std::vector<KeptOutcome> outcomes;
  std::vector<KnownResult> known;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> indices;  // of known results
  std::vector<std::vector<std::size_t>> lists;  // of their indices, as cases have them; the first one is empty
};

StudyResult::StudyResult(StudyCases cases) : contents_{std::make_shared<Contents>(std::move(cases))} {}

StudyResult::StudyResult(StudyCases cases, const std::vector<CaseOutcome>& outcomes) : StudyResult{std::move(cases)} {
  for (std::size_t number = 0; number < outcomes.size(); ++number) set(number, outcomes[number]);
}

void StudyResult::set(std::size_t number, CaseOutcome outcome) {
  if (contents_.use_count() > 1) contents_ = std::make_shared<Contents>(*contents_);
  Contents& all = *contents_;
  KeptOutcome& kept = all.outcomes.at(number);
  for (const std::size_t i : all.lists[kept.results]) all.table.columns[all.known[i].column].values[number] = unknown;
  std::vector<std::size_t> results;
  bool earlier = false;
  for (const NamedNumber& each : outcome.results) {
    const std::pair place{number, results.size()};
    results.push_back(all.index_of(each));
    KnownResult& known = all.known[results.back()];
    all.table.columns[known.column].values[number] = each.value;
    if (place >= known.first) continue;
    known.first = place;
    earlier = true;
  }
  if (earlier) all.arrange_columns();
  auto list = std::ranges::find(all.lists, results);
  if (list == all.lists.end()) list = all.lists.insert(list, std::move(results));
  kept.results = static_cast<std::size_t>(list - all.lists.begin());
  kept.files = std::exchange(outcome.files, {});
  outcome.results = StudyRecord{};
  kept.rest = std::move(outcome);
}

CaseOutcome StudyResult::outcome(std::size_t number) const {
  const KeptOutcome& kept = contents_->outcomes.at(number);
  CaseOutcome outcome = kept.rest;
  outcome.files = kept.files;
  for (const std::size_t i : contents_->lists[kept.results]) {
    const Column& column = table().columns[contents_->known[i].column];
    outcome.results.push_back({column.quantity, column.where, column.unit, column.values[number]});
  }
  return outcome;
}

const StudyCases& StudyResult::cases() const { return contents_->cases; }
const Table& StudyResult::table() const { return contents_->table; }
CaseState StudyResult::state(std::size_t number) const { return contents_->outcomes.at(number).rest.state; }
double StudyResult::seconds(std::size_t number) const { return contents_->outcomes.at(number).rest.seconds; }

Table StudyResult::case_table(std::size_t first, std::size_t last) const {
  Column number{"case", "", "1", {}}, state{"state", "", "1", {}}, reason{"reason", "", "1", {}},
      steps{"steps", "", "1", {}}, error{"energy_error", "", "1", {}}, seconds{"seconds", "", "s", {}};
  for (std::size_t i = first; i < last; ++i) {
    const CaseOutcome& outcome = contents_->outcomes.at(i).rest;
    number.values.push_back(static_cast<double>(i));
    state.values.push_back(static_cast<double>(outcome.state));
    state.labels.emplace_back(name_of(outcome.state));
    reason.values.push_back(unknown);
    reason.labels.push_back(outcome.reason);
    steps.values.push_back(static_cast<double>(outcome.steps));
    error.values.push_back(outcome.energy_error);
    seconds.values.push_back(outcome.seconds);
  }
  Table part;
  const auto add_rows = [&](const auto& from, auto& to) {
    const auto rows = std::span{from}.subspan(first, last - first);
    to.assign(rows.begin(), rows.end());
  };
  const auto add = [&](std::span<const Column> columns) {
    for (const Column& column : columns) {
      Column& rows = part.columns.emplace_back(Column{column.quantity, column.where, column.unit, {}});
      add_rows(column.values, rows.values);
      if (!column.labels.empty()) add_rows(column.labels, rows.labels);
    }
  };
  const std::span<const Column> columns{table().columns};
  part.columns.push_back(std::move(number));
  add(columns.first(axes().size()));
  for (Column* column : {&state, &reason, &steps, &error, &seconds}) part.columns.push_back(std::move(*column));
  add(columns.subspan(axes().size()));
  return part;
}

std::size_t StudyResult::count(CaseState state) const {
  return static_cast<std::size_t>(
      std::ranges::count(contents_->outcomes, state, [](const KeptOutcome& each) { return each.rest.state; }));
}

std::vector<std::size_t> StudyResult::numbers(const Fixed& fixed) const {
  std::vector<std::pair<std::size_t, std::size_t>> held;  // axis, position
  for (const auto& [name, position] : fixed) held.emplace_back(cases().index_of(name), position);
  std::vector<std::size_t> chosen;
  for (std::size_t number = 0; number < cases().count(); ++number)
    if (std::ranges::all_of(held,
                            [&](const auto& each) { return cases().position(each.first, number) == each.second; }))
      chosen.push_back(number);
  return chosen;
}

std::vector<double> StudyResult::values(std::string_view quantity, std::string_view where, const Fixed& fixed) const {
  const auto is_meant = [&](const Column& each) { return each.quantity == quantity && each.where == where; };
  const std::vector<Column>& columns = table().columns;
  const auto column =
      std::find_if(columns.begin() + static_cast<std::ptrdiff_t>(axes().size()), columns.end(), is_meant);
  const std::string name = "\"" + std::string{quantity} + "\" of \"" + std::string{where} + "\"";
  if (column == columns.end()) throw InputError{"The study has no result " + name + "."};
  if (const auto other = std::find_if(column + 1, columns.end(), is_meant); other != columns.end())
    throw InputError{"The result " + name + " has the unit " + column->unit + " in some cases and " + other->unit +
                     " in others. Give it one unit, or two names."};
  std::vector<double> chosen;
  for (const std::size_t number : numbers(fixed)) chosen.push_back(column->values[number]);
  return chosen;
}

void write_csv(const StudyResult& result, const std::filesystem::path& path) {
  write_file(path, [&](std::ostream& file) {
    // A table of all cases would need as much memory as the results again.
    constexpr std::size_t most = 1000;
    const std::size_t count = result.cases().count();
    for (std::size_t first = 0; first < count; first += most) {
      const Table rows = result.case_table(first, std::min(first + most, count));
      if (first == 0) file << csv_heading(rows) << '\n';
      write_csv_rows(rows, 0, file);
    }
  });
}

std::vector<StudyError::Failure> failures_of(const StudyResult& result) {
  std::vector<StudyError::Failure> failures;
  for (std::size_t number = 0; number < result.cases().count(); ++number)
    if (const CaseState state = result.state(number); state == CaseState::failed || state == CaseState::not_converged)
      failures.push_back({number, StudyCase{result.cases(), number}.description(), result.outcome(number).reason});
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
