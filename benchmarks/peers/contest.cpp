#include "peers/contest.hpp"

#include <algorithm>
#include <moat.hpp>

#include "measuring/measure.hpp"
#include "peers/moat_histories.hpp"

namespace moat::peers {
namespace {

using performance::Figure;

constexpr double error = 1e-3;
const std::string moat_column = "moat, ms", automatic = "moat, `--integrator automatic`", opensees_name = "OpenSees, ";

std::string percent(double share) { return performance::short_text(100.0 * share) + " %"; }

std::string spread_text(const performance::Spread& spread) {
  using performance::short_text;
  return short_text(spread.median) + " (" + short_text(spread.low) + " to " + short_text(spread.high) + ")";
}

std::vector<Ladder> ladders_of(const Case& each, const OpenSees& opensees, const ContestOptions& options) {
  std::vector<Ladder> ladders{moat_ladder(each, "moat", Newmark{}), moat_ladder(each, automatic, Automatic{})};
  for (const OpenSeesSetting& setting : opensees_settings())
    ladders.push_back(opensees_ladder(opensees_name + setting.description, opensees, each, setting, options.finer));
  if (each.compared != Compared::isolation) return ladders;
  for (const auto& block : each.model.blocks())
    if (block->size() > 0 && block->law(0).name == "FrictionPendulum")
      ladders.push_back(
          opensees_ladder(opensees_name + "singleFPBearing", opensees, each, {"textbook", "singleFPBearing", true}));
  return ladders;
}

Outcome outcome_of(performance::Record& record, const std::string& model, const std::vector<Cost>& found,
                   const ContestOptions& options) {
  Outcome outcome{model};
  const Cost& moat = found.front();
  const Cost* best = nullptr;
  for (const Cost& cost : found) {
    if (cost.seconds.empty() || !cost.name.starts_with(opensees_name)) continue;
    if (best == nullptr || cheaper(cost, *best)) best = &cost;
  }
  const auto ratio = [&](const Cost& cost, const std::string& name, std::optional<double> target) {
    Figure figure{model + ", " + name + " / moat", performance::ratio_of(cost.seconds, moat.seconds)};
    if (target) figure.target = performance::Target{*target, false};
    return record.add(std::move(figure)).value;
  };
  if (moat.seconds.empty() || best == nullptr) {
    outcome.remark = std::string{moat.seconds.empty() ? "moat" : "OpenSees"} + " is not so exact";
    return outcome;
  }
  outcome.best_setting = best->name.substr(opensees_name.size());
  outcome.best = ratio(*best, "OpenSees' best (" + outcome.best_setting + ")", options.best);
  const auto textbook = std::ranges::find(found, opensees_name + opensees_settings().front().description, &Cost::name);
  if (textbook != found.end() && !textbook->seconds.empty())
    outcome.textbook = ratio(*textbook, "OpenSees' textbook setting", options.textbook);
  else
    outcome.remark = "OpenSees' textbook setting is not so exact";
  return outcome;
}

}  // namespace

std::vector<Outcome> compare(performance::Record& record, const OpenSees& opensees, const std::vector<Case>& cases,
                             const ContestOptions& options) {
  record.section(options.section);
  std::vector<std::string> header{
      "CPU time in ms for an error of 0.1 % (errors of the loosest ... tightest setting tried)"};
  for (const Case& each : cases) header.push_back(each.name);
  performance::Table table{header};
  std::vector<Outcome> outcomes;
  for (const Case& each : cases) {
    const std::vector<Cost> found =
        costs(ladders_of(each, opensees, options), reference_of(each), error, options.rounds);
    for (const Cost& cost : found) {
      const std::string errors = " (" + percent(cost.errors.front()) + " ... " + percent(cost.errors.back()) + ")";
      const std::string name = each.name + ", " + cost.name;
      if (cost.seconds.empty()) {
        record.add({name + ", error of its tightest setting", performance::single(100.0 * cost.errors.back()), "%"});
        table.put(cost.name, each.name, "-" + errors);
        continue;
      }
      const Figure& figure = record.add({.name = name,
                                         .value = performance::scaled(performance::spread_of(cost.seconds), 1e3),
                                         .unit = "ms",
                                         .detail = cost.settings + errors});
      table.put(cost.name, each.name, performance::short_text(figure.value.median) + errors);
    }
    outcomes.push_back(outcome_of(record, each.name, found, options));
  }
  record.table(table);
  return outcomes;
}

void summarise(performance::Record& record, const std::vector<Outcome>& outcomes) {
  record.section("peers-summary");
  performance::Table table{
      {"OpenSees' time / moat's, median (quartiles)", "textbook", "best", "best setting", "faster"}};
  for (const Outcome& each : outcomes) {
    if (each.textbook.median > 0.0) table.put(each.model, "textbook", spread_text(each.textbook));
    if (each.best.median > 0.0) table.put(each.model, "best", spread_text(each.best));
    table.put(each.model, "best setting", each.best_setting);
    std::string verdict = each.best.median > 1.0 ? "moat" : each.best.median > 0.0 ? "OpenSees" : "";
    if (!each.remark.empty()) verdict += (verdict.empty() ? "" : "; ") + each.remark;
    table.put(each.model, "faster", verdict);
  }
  record.table(table);
  std::printf("%s", table.markdown().c_str());
}

}  // namespace moat::peers
