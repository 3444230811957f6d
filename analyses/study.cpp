#include "analyses/study.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <thread>

#include "analyses/error_bars.hpp"
#include "base/check.hpp"

namespace moat {
namespace {

std::size_t index_of(const std::vector<StudyAxis>& axes, std::string_view name) {
  const auto found = std::ranges::find(axes, name, &StudyAxis::name);
  if (found != axes.end()) return static_cast<std::size_t>(found - axes.begin());
  std::string known;
  for (const StudyAxis& axis : axes) known.append(known.empty() ? "" : ", ").append(axis.name);
  throw InputError{"The study has no axis \"" + std::string{name} + "\". Its axes are: " + known + "."};
}

std::size_t position_on(const std::vector<StudyAxis>& axes, std::size_t axis, std::size_t number) {
  for (std::size_t i = axes.size() - 1; i > axis; --i) number /= axes[i].values.size();
  return number % axes[axis].values.size();
}

std::size_t count_cases(const std::vector<StudyAxis>& axes) {
  Check{"Study", ""}.that(!axes.empty(), "there is no axis.", "Give at least one StudyAxis.");
  std::set<std::string> names;
  std::size_t count = 1;
  for (const StudyAxis& axis : axes) {
    const Check check{"StudyAxis", axis.name};
    check.that(names.insert(axis.name).second, "the name appears twice.", "Give every axis a name of its own.");
    check.that(!axis.values.empty(), "there are no values.", "Give at least one.");
    check.that(axis.labels.empty() || axis.labels.size() == axis.values.size(),
               "the numbers of labels and values differ.", "Give one label for every value, or none.");
    for (const double value : axis.values) check.finite("a value", value, axis.unit);
    count *= axis.values.size();
  }
  return count;
}

struct Outcome {
  StudyRecord record;
  std::optional<std::string> failure;
};

Outcome outcome_of(const StudyCase& each, const std::function<StudyRecord(const StudyCase&)>& compute) {
  try {
    return {compute(each), {}};
  } catch (const std::exception& error) {
    return {{}, error.what()};
  } catch (...) {
    return {{}, "an exception that is not a std::exception"};
  }
}

Table table_of(const std::vector<StudyAxis>& axes, const std::vector<Outcome>& outcomes) {
  Table table;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    table.columns.push_back({axes[axis].name, "", axes[axis].unit.empty() ? "1" : axes[axis].unit, {}});
    for (std::size_t number = 0; number < outcomes.size(); ++number) {
      const std::size_t position = position_on(axes, axis, number);
      table.columns.back().values.push_back(axes[axis].values[position]);
      if (!axes[axis].labels.empty()) table.columns.back().labels.push_back(axes[axis].labels[position]);
    }
  }
  // Cases may have different results (buildings of different height): a column for each that any case has.
  std::map<std::pair<std::string, std::string>, std::size_t> column_of;
  for (std::size_t number = 0; number < outcomes.size(); ++number) {
    for (const NamedNumber& each : outcomes[number].record) {
      const auto [found, added] = column_of.try_emplace({each.quantity, each.where}, table.columns.size());
      if (added)
        table.columns.push_back({each.quantity, each.where, each.unit,
                                 std::vector(outcomes.size(), std::numeric_limits<double>::quiet_NaN())});
      table.columns[found->second].values[number] = each.value;
    }
  }
  return table;
}

std::string failure_message(const std::vector<StudyError::Failure>& failures, std::size_t cases) {
  constexpr std::size_t most_told = 5;
  std::string text = std::to_string(failures.size()) + " of " + std::to_string(cases) + " cases failed.";
  for (std::size_t i = 0; i < std::min(most_told, failures.size()); ++i)
    text += "\n  " + failures[i].description + ": " + failures[i].message;
  if (failures.size() > most_told) text += "\n  ... and " + std::to_string(failures.size() - most_told) + " more";
  return text;
}

}  // namespace

StudyAxis StudyAxis::of_names(std::string name, std::vector<std::string> labels) {
  StudyAxis axis{.name = std::move(name), .unit = "", .values = {}, .labels = std::move(labels)};
  for (std::size_t i = 0; i < axis.labels.size(); ++i) axis.values.push_back(static_cast<double>(i));
  return axis;
}

std::vector<double> linearly_spaced(double first, double last, int count) {
  Check{"linearly_spaced", ""}.that(count >= 2, "count", count, "1", ">= 2");
  std::vector<double> values;
  for (int i = 0; i < count; ++i) values.push_back(first + (last - first) * i / (count - 1));
  return values;
}

std::vector<double> logarithmically_spaced(double first, double last, int count) {
  const Check check{"logarithmically_spaced", ""};
  check.positive("first", first, "1");
  check.positive("last", last, "1");
  std::vector<double> values = linearly_spaced(std::log10(first), std::log10(last), count);
  for (double& value : values) value = std::pow(10.0, value);
  values.front() = first;
  values.back() = last;
  return values;
}

std::size_t StudyCase::position(std::string_view axis) const {
  return position_on(*axes_, index_of(*axes_, axis), number_);
}

double StudyCase::value(std::string_view axis) const { return (*axes_)[index_of(*axes_, axis)].values[position(axis)]; }

std::string StudyCase::description() const {
  std::string text;
  for (const StudyAxis& axis : *axes_) {
    const std::size_t at = position(axis.name);
    text += (text.empty() ? "" : ", ") + axis.name + " = ";
    text +=
        axis.labels.empty() ? to_text(axis.values[at]) + (axis.unit.empty() ? "" : " " + axis.unit) : axis.labels[at];
  }
  return text;
}

std::vector<double> StudyResult::values(std::string_view quantity, std::string_view where, const Fixed& fixed) const {
  const auto column =
      std::ranges::find_if(table_.columns.begin() + static_cast<std::ptrdiff_t>(axes_.size()), table_.columns.end(),
                           [&](const Column& each) { return each.quantity == quantity && each.where == where; });
  if (column == table_.columns.end())
    throw InputError{"The study has no result \"" + std::string{quantity} + "\" of \"" + std::string{where} + "\"."};
  std::vector<double> chosen;
  for (std::size_t number = 0; number < column->values.size(); ++number) {
    const bool wanted = std::ranges::all_of(fixed, [&](const auto& each) {
      return position_on(axes_, index_of(axes_, each.first), number) == each.second;
    });
    if (wanted) chosen.push_back(column->values[number]);
  }
  return chosen;
}

StudyError::StudyError(std::vector<Failure> failed, StudyResult computed)
    : Error{failure_message(failed, computed.table().rows())},
      failures{std::move(failed)},
      result{std::move(computed)} {}

StudyResult run_study(const std::vector<StudyAxis>& axes, const std::function<StudyRecord(const StudyCase&)>& compute,
                      const StudyOptions& options) {
  const std::size_t cases = count_cases(axes);
  Check{"StudyOptions", ""}.that(options.threads >= 0, "threads", options.threads, "1", ">= 0",
                                 "0 takes one thread per core.");
  const std::size_t wanted = options.threads > 0 ? static_cast<std::size_t>(options.threads)
                                                 : std::max(1u, std::thread::hardware_concurrency());

  std::vector<Outcome> outcomes(cases);
  std::atomic<std::size_t> next{0};
  std::mutex telling;
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t number = next++; number < cases; number = next++) {
      outcomes[number] = outcome_of(StudyCase{axes, number}, compute);
      const std::lock_guard lock{telling};
      ++done;
      if (options.progress) options.progress(done, cases);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 1; i < std::min(wanted, cases); ++i) threads.emplace_back(work);
    work();
  }

  std::vector<StudyError::Failure> failures;
  for (std::size_t number = 0; number < cases; ++number)
    if (outcomes[number].failure)
      failures.push_back({number, StudyCase{axes, number}.description(), *outcomes[number].failure});
  StudyResult result{axes, table_of(axes, outcomes)};
  if (!failures.empty()) throw StudyError{std::move(failures), std::move(result)};
  return result;
}

StudyResult run_study(const std::vector<StudyAxis>& axes, const std::function<StudyModel(const StudyCase&)>& make,
                      const StudyOptions& options) {
  const auto compute = [&](const StudyCase& each) {
    StudyModel study = make(each);
    return peaks_of(study.model, study.motion, options.transient, options.error_bars);
  };
  return run_study(axes, std::function<StudyRecord(const StudyCase&)>{compute}, options);
}

StudyRecord peaks_of(Model& model, const GroundMotion& motion, const TransientOptions& options, bool error_bars) {
  std::optional<Model> untouched;
  if (error_bars) untouched = model;
  PeaksAndImpacts main = compute_peaks(model, motion, options);
  double sensitive = std::numeric_limits<double>::quiet_NaN();
  if (error_bars) {
    try {
      const PeaksAndImpacts companion =
          compute_peaks(*untouched, motion, companion_options(options, main.solver.longest_step));
      const double least_share = least_share_of_errors(model, options);
      sensitive = estimate_errors(main.peaks, main.impacts, companion, least_share).sensitive ? 1.0 : 0.0;
      estimate_clearance_errors(main, companion, least_share);
    } catch (const Error&) {
      // The case itself is computed; its errors stay unknown.
    }
  }
  StudyRecord record;
  for (const Peak& peak : main.peaks) {
    record.push_back({peak.quantity, peak.where, peak.unit, peak.magnitude()});
    if (error_bars) record.push_back({peak.quantity + "_error", peak.where, peak.unit, peak.error});
  }
  for (const GapClearance& gap : main.clearances) {
    record.push_back({"clearance_left", gap.where, "m", gap.left});
    if (error_bars) record.push_back({"clearance_left_error", gap.where, "m", gap.error});
  }
  record.push_back({"impacts", "", "1", static_cast<double>(main.impacts)});
  if (error_bars) record.push_back({"sensitive", "", "1", sensitive});
  return record;
}

double value_of(const StudyRecord& record, std::string_view quantity, std::string_view where) {
  for (const NamedNumber& each : record)
    if (each.quantity == quantity && each.where == where) return each.value;
  throw InputError{"There is no result \"" + std::string{quantity} + "\" of \"" + std::string{where} + "\"."};
}

}  // namespace moat
