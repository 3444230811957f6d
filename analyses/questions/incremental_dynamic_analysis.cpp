#include "analyses/questions/incremental_dynamic_analysis.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "base/check.hpp"
#include "base/error.hpp"
#include "study/study_charts.hpp"

namespace moat {
namespace {

constexpr double infinite_response = std::numeric_limits<double>::infinity();

void check(const HuntAndFill& options) {
  const Check check{"HuntAndFill", ""};
  check.positive("first_level", options.first_level, "level");
  check.positive("first_step", options.first_step, "level");
  check.not_negative("step_increment", options.step_increment, "level");
  check.positive("response_limit", options.response_limit, "response");
  check.that(options.largest_level >= options.first_level && std::isfinite(options.largest_level), "largest_level",
             options.largest_level, "level", ">= first_level");
  check.that(options.fill >= 0, "fill", options.fill, "1", ">= 0");
}

// Points and failures, ascending.
IdaCurve curve_of(std::string record, const std::map<double, double>& points, const std::set<double>& unsolved) {
  IdaCurve curve{.record = std::move(record), .levels = {}, .responses = {}};
  for (const auto& [level, response] : points) {
    curve.levels.push_back(level);
    curve.responses.push_back(response);
  }
  curve.without_solution.assign(unsolved.begin(), unsolved.end());
  return curve;
}

std::optional<double> response_at(const IdaCurve& curve, double level) {
  const auto above = std::ranges::lower_bound(curve.levels, level);
  if (above == curve.levels.end()) {
    if (curve.responses.empty()) return std::nullopt;
    const double last = curve.responses.back();
    return last > curve.response_limit || std::isinf(last) ? std::optional{infinite_response} : std::nullopt;
  }
  const auto i = static_cast<std::size_t>(above - curve.levels.begin());
  if (*above == level) return curve.responses[i];
  if (i == 0) return std::nullopt;
  if (std::isinf(curve.responses[i - 1])) return infinite_response;
  const double share = (level - curve.levels[i - 1]) / (curve.levels[i] - curve.levels[i - 1]);
  return curve.responses[i - 1] + share * (curve.responses[i] - curve.responses[i - 1]);
}

/// Infinite where the model collapsed: the analysis ended there, and its peaks are those up to then.
double response_of(const CaseOutcome& outcome, double response) {
  const auto collapsed = std::ranges::find(outcome.results, "collapsed", &NamedNumber::quantity);
  return collapsed != outcome.results.end() && collapsed->value > 0.0 ? infinite_response : response;
}

std::string point_name(std::size_t i) { return "point " + std::to_string(i + 1); }

}  // namespace

std::vector<IdaCurve> ida_curves(const StudyResult& study, std::string_view level_axis, std::string_view quantity,
                                 std::string_view where) {
  const std::size_t index = study.cases().index_of(level_axis);
  struct Points {
    std::map<double, double> solved;
    std::set<double> unsolved;
  };
  std::map<std::vector<std::size_t>, Points> records;
  std::map<std::vector<std::size_t>, std::string> names;
  const std::vector<double> responses = study.values(quantity, where);
  for (std::size_t number = 0; number < study.cases().count(); ++number) {
    const StudyCase each{study.cases(), number};
    std::vector<std::size_t> others;
    std::string name;
    for (std::size_t i = 0; i < study.axes().size(); ++i) {
      if (i == index) continue;
      others.push_back(study.cases().position(i, number));
      name += (name.empty() ? "" : ", ") + each.label(study.axes()[i].name);
    }
    names[others] = name;
    Points& points = records[others];
    const CaseState state = study.state(number);
    const double response = response_of(study.outcome(number), responses[number]);
    if (state == CaseState::done && !std::isnan(response))
      points.solved[each.value(level_axis)] = response;
    else if (state != CaseState::open)
      points.unsolved.insert(each.value(level_axis));
  }
  std::vector<IdaCurve> curves;
  for (const auto& [others, points] : records)
    curves.push_back(curve_of(names[others], points.solved, points.unsolved));
  return curves;
}

IdaCurve hunt_and_fill(const std::function<double(double level)>& response, const HuntAndFill& options) {
  check(options);
  std::map<double, double> points;
  std::set<double> unsolved;
  const auto solve = [&](double level) -> std::optional<double> {
    try {
      return points[level] = response(level);
    } catch (const ConvergenceError&) {
      points.erase(level);
      unsolved.insert(level);
      return std::nullopt;
    }
  };
  double level = options.first_level, step = options.first_step;
  while (true) {
    const std::optional<double> found = solve(level);
    if (!found || *found > options.response_limit || level >= options.largest_level) break;
    level = std::min(level + step, options.largest_level);
    step += options.step_increment;
  }
  for (int i = 0; i < options.fill; ++i) {
    // Level 0 has no response, and the widest distance may be the one above it.
    double below = 0.0, widest = 0.0, middle = 0.0;
    std::set<double> known = unsolved;
    for (const auto& [each, value] : points) known.insert(each);
    for (const double each : known) {
      if (each - below > widest) {
        widest = each - below;
        middle = 0.5 * (each + below);
      }
      const auto point = points.find(each);
      if (point != points.end() && point->second > options.response_limit) break;
      below = each;
    }
    solve(middle);
  }
  IdaCurve curve = curve_of("", points, unsolved);
  curve.response_limit = options.response_limit;
  return curve;
}

StudyRecord record_of(const IdaCurve& curve) {
  StudyRecord record{{"ida_response_limit", "", "1", curve.response_limit}};
  for (std::size_t i = 0; i < curve.levels.size(); ++i) {
    record.push_back({"ida_level", point_name(i), "1", curve.levels[i]});
    record.push_back({"ida_response", point_name(i), "1", curve.responses[i]});
  }
  for (std::size_t i = 0; i < curve.without_solution.size(); ++i)
    record.push_back({"ida_level_without_solution", point_name(i), "1", curve.without_solution[i]});
  return record;
}

std::vector<IdaCurve> ida_curves(const StudyResult& hunts) {
  std::vector<IdaCurve> curves;
  for (std::size_t number = 0; number < hunts.cases().count(); ++number) {
    const CaseOutcome outcome = hunts.outcome(number);
    if (outcome.state != CaseState::done) continue;
    std::map<double, double> points;
    std::set<double> unsolved;
    double level = 0.0, limit = infinite_response;
    for (const NamedNumber& each : outcome.results) {
      if (each.quantity == "ida_response_limit") limit = each.value;
      if (each.quantity == "ida_level") level = each.value;
      if (each.quantity == "ida_response") points[level] = each.value;
      if (each.quantity == "ida_level_without_solution") unsolved.insert(each.value);
    }
    const StudyCase at{hunts.cases(), number};
    std::string name;
    for (const StudyAxis& axis : hunts.axes()) name += (name.empty() ? "" : ", ") + at.label(axis.name);
    curves.push_back(curve_of(name, points, unsolved));
    curves.back().response_limit = limit;
  }
  return curves;
}

std::vector<IdaFractiles> ida_fractiles(const std::vector<IdaCurve>& curves) {
  constexpr double low = 0.16, high = 0.84;
  std::set<double> levels;
  for (const IdaCurve& curve : curves) levels.insert(curve.levels.begin(), curve.levels.end());
  std::vector<IdaFractiles> list;
  for (const double level : levels) {
    std::vector<double> responses;
    IdaFractiles fractiles{.level = level};
    for (const IdaCurve& curve : curves) {
      if (std::ranges::find(curve.without_solution, level) != curve.without_solution.end())
        ++fractiles.without_solution;
      else if (const auto response = response_at(curve, level))
        responses.push_back(*response);
    }
    if (responses.empty()) continue;
    fractiles.records = responses.size();
    fractiles.low = fractile(responses, low);
    fractiles.median = fractile(responses, 0.5);
    fractiles.high = fractile(responses, high);
    list.push_back(fractiles);
  }
  return list;
}

std::vector<KnownInterval> capacities(const std::vector<IdaCurve>& curves, double response) {
  std::vector<KnownInterval> list;
  for (const IdaCurve& curve : curves) {
    if (curve.levels.empty()) continue;
    KnownInterval capacity;
    for (std::size_t i = 0; i < curve.levels.size(); ++i) {
      if (curve.responses[i] > response) {
        capacity.up_to = curve.levels[i];
        break;
      }
      capacity.above = curve.levels[i];
    }
    list.push_back(capacity);
  }
  return list;
}

}  // namespace moat
