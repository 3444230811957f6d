#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "measuring/measure.hpp"
#include "performance/methods.hpp"
#include "performance/sections.hpp"

namespace moat::performance {
namespace {

namespace names = method_names;
using peers::Case;
using peers::Cost;

constexpr double error = 1e-3;

class Report {
 public:
  Report(Record& record, const Options& options)
      : record_{&record}, options_{&options}, opensees_{peers::OpenSees::find(options.folder)} {
    if (!opensees_) record.note("OpenSees is not installed (OPENSEES names it): it is left out.");
    if (options.records.empty())
      record.note("MOAT_RECORDS is not set: recorded motions are left out, and only the pulse is computed.");
    for (const auto& [name, motion] : peers::motions(!options.quick && !options.records.empty()))
      cases_.push_back(peers::five_storeys(name, peers::hertz_damp(), motion));
  }

  void run() {
    std::vector<std::string> header{""};
    for (const Case& each : cases_) header.push_back(each.name);
    header.front() = "CPU time in ms for an error of 0.1 %";
    times_.emplace(header);
    header.front() = "At 0.1 %";
    targets_.emplace(header);
    for (const Case& each : cases_) run(each);
    record_->table(*times_);
    record_->table(*targets_);
  }

 private:
  void run(const Case& each) {
    column_ = each.name;
    const References found = references(each);
    constexpr double six_digits = 1e-6;
    judge("difference of the reference from one with a tolerance ten times looser",
          single(largest_error(found.moat_less_tight, found.moat)), Target{six_digits});
    judge("difference of the reference from SUNDIALS with a tight tolerance",
          single(largest_error(found.sundials, found.moat)), Target{six_digits});
    std::map<std::string, std::vector<double>> seconds;
    // A history takes a millisecond: rounds are cheap, and more of them steady the median.
    for (const Cost& cost : peers::costs(methods(each, opensees_), found.moat, error, 2 * options_->rounds + 1)) {
      if (cost.seconds.empty()) {
        record_->note(column_ + ", " + cost.name + ": no setting is as exact as 0.1 %.");
        continue;
      }
      const Spread in_ms = scaled(spread_of(cost.seconds), 1e3);
      times_->put(cost.name, column_, cell(add(cost.name + " at 0.1 %", in_ms, "ms", {}, cost.settings)));
      seconds[cost.name] = cost.seconds;
    }
    compare(seconds);
  }

  void compare(const std::map<std::string, std::vector<double>>& seconds) {
    const auto at_most_ms = [&](const char* name, double bound) {
      if (seconds.contains(name)) judge(name, scaled(spread_of(seconds.at(name)), 1e3), Target{bound}, "ms");
    };
    at_most_ms(names::moat_recorded, 15.0);
    if (!seconds.contains(names::moat_adaptive)) return;
    const std::vector<double>& moat = seconds.at(names::moat_adaptive);
    for (const char* other : {names::arkode, names::opensees})
      if (const auto its = seconds.find(other); its != seconds.end()) {
        const std::string name = std::string{other} + " / moat adaptive";
        targets_->put(name, column_, cell(add(name, ratio_of(its->second, moat), "")));
      }
  }

  const Figure& add(const std::string& name, const Spread& value, const std::string& unit,
                    std::optional<Target> target = {}, const std::string& detail = {}) {
    return record_->add({"equal accuracy, " + column_ + ", " + name, value, unit, target, detail});
  }
  void judge(const std::string& name, const Spread& value, Target target, const std::string& unit = {}) {
    const Figure& figure = add(name, value, unit, target);
    targets_->put(name + (unit.empty() ? "" : " [" + unit + "]") + ": " + text(target), column_, cell(figure));
  }

  Record* record_;
  const Options* options_;
  std::optional<peers::OpenSees> opensees_;
  std::vector<Case> cases_;
  std::optional<Table> times_, targets_;
  std::string column_;
};

}  // namespace

void equal_accuracy(Record& record, const Options& options) {
  record.section("equal-accuracy");
  Report{record, options}.run();
}

}  // namespace moat::performance
