#include "output/charts/suite_charts.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "base/check.hpp"
#include "base/units.hpp"
#include "motions/motion_measures.hpp"

namespace moat {
namespace {

std::vector<Time> periods_of_pictures(const TargetSpectrum& target) {
  constexpr Time first = 0.02 * units::s, last = 10.0 * units::s;
  std::vector<Time> periods = spaced_periods(first, last, 200);
  periods.insert(periods.end(), target.corners.begin(), target.corners.end());
  std::erase_if(periods, [&](Time each) {
    return each < std::max(first, target.shortest) || each > std::min(last, target.longest);
  });
  std::ranges::sort(periods);
  periods.erase(std::unique(periods.begin(), periods.end()), periods.end());
  return periods;
}

// The chart of the spectra, each value times a factor of its period; the range of scaling lies behind them.
Chart chart_of(const ScaledSuite& suite, const Table& spectra, const std::function<double(double)>& factor) {
  const auto& columns = spectra.columns;
  Chart chart{.x_label = "period [s]", .series = {}};
  double lowest = std::numeric_limits<double>::infinity(), highest = 0.0;
  const auto add = [&](std::string name, const Column& column, std::size_t colour, double share, Series::Style style) {
    Series series{std::move(name), columns.front().values, column.values, style, colour};
    for (std::size_t k = 0; k < series.y.size(); ++k) series.y[k] *= share * factor(series.x[k]);
    lowest = std::min(lowest, std::ranges::min(series.y));
    highest = std::max(highest, std::ranges::max(series.y));
    chart.series.push_back(std::move(series));
  };
  using Style = Series::Style;
  constexpr std::size_t first_record = 3, blue = 4, black = 6, red = 1, yellow = 5;
  for (std::size_t i = first_record; i < columns.size(); ++i)
    add(i == first_record ? "records" : "", columns[i], blue, 1.0, Style::line);
  add(suite.scaling.spectrum == PairSpectrum::each_component ? "smaller mean" : "mean", columns[2], black, 1.0,
      Style::line);
  add(suite.target.name, columns[1], red, 1.0, Style::line);
  if (suite.scaling.fraction != 1.0)
    add(to_text(suite.scaling.fraction) + " target", columns[1], red, suite.scaling.fraction, Style::dashed);
  const double from = suite.scaling.shortest.si(), to = suite.scaling.longest.si();
  chart.series.insert(
      chart.series.begin(),
      {"range of scaling", {from, to, to, from}, {highest, highest, lowest, lowest}, Style::band, yellow});
  return chart;
}

}  // namespace

Table spectra_table(const ScaledSuite& suite) {
  const std::vector<Time> periods = periods_of_pictures(suite.target);
  const std::string quantity = "spectral_acceleration", unit = "m/s^2";
  Column period{"period", "", "s", {}}, target{quantity, "target", unit, {}};
  for (const Time each : periods) {
    period.values.push_back(each.si());
    target.values.push_back(suite.target.acceleration(each).si());
  }
  // Each component is a column, and the smaller mean counts.
  const bool apart = suite.scaling.spectrum == PairSpectrum::each_component;
  std::vector<Column> means(apart ? 2 : 1, Column{quantity, "mean", unit, std::vector(periods.size(), 0.0)});
  Table table{{std::move(period), std::move(target), {}}};
  for (const NamedPair& pair : suite.pairs) {
    const std::vector<double> values =
        pair_spectra(pair.motion, periods, suite.target.damping_ratio).of(suite.scaling.spectrum);
    for (std::size_t part = 0; part < means.size(); ++part) {
      const auto first = values.begin() + static_cast<std::ptrdiff_t>(part * periods.size());
      const std::string of = apart ? (part == 0 ? ", first" : ", second") : "";
      table.columns.push_back({quantity, pair.name + of, unit, {first, first + std::ssize(periods)}});
      for (std::size_t k = 0; k < periods.size(); ++k)
        means[part].values[k] += table.columns.back().values[k] / static_cast<double>(suite.pairs.size());
    }
  }
  Column mean = means.front();
  for (std::size_t k = 0; k < periods.size(); ++k) mean.values[k] = std::min(mean.values[k], means.back().values[k]);
  table.columns[2] = std::move(mean);
  return table;
}

std::vector<Chart> suite_charts(const ScaledSuite& suite) {
  const Table spectra = spectra_table(suite);
  Chart accelerations = chart_of(suite, spectra, [](double) { return 1.0 / standard_gravity; });
  accelerations.title =
      "Spectra of the suite, " + name_of(suite.scaling.spectrum) + ", scaled by " + suite.scaling.name;
  accelerations.y_label = "acceleration [g]";
  accelerations.logarithmic_x = accelerations.logarithmic_y = true;
  Chart displacements = chart_of(suite, spectra, [](double period) {
    const double rate = period / (2.0 * std::numbers::pi);
    return rate * rate * (units::m / units::cm);
  });
  displacements.title = "Displacement spectra of the suite";
  displacements.y_label = "displacement [cm]";
  displacements.y_from_zero = true;
  return {std::move(accelerations), std::move(displacements)};
}

Table scaling_table(const ScaledSuite& suite) {
  Column records{"record", "", "1", {}}, first{"pga", "first", "m/s^2", {}}, second{"pga", "second", "m/s^2", {}};
  for (const NamedPair& pair : suite.pairs) {
    records.labels.push_back(pair.name);
    records.values.push_back(static_cast<double>(records.values.size()));
    first.values.push_back(pair.motion.first.peak_acceleration().si());
    second.values.push_back(pair.motion.second.peak_acceleration().si());
  }
  return {{std::move(records),
           {"own_factor", "", "1", suite.own_factors},
           {"factor", "", "1", suite.factors()},
           std::move(first),
           std::move(second)}};
}

}  // namespace moat
