#include "output/charts/chart_curve.hpp"

#include <cmath>
#include <string>

#include "base/check.hpp"

namespace moat {
namespace {

/// Throws for the first value that cannot be drawn.
void check_point(const Chart& chart, const Series& series, std::size_t i) {
  const Check check{"Series", series.name};
  const std::string x = "x of chart \"" + chart.title + "\"", y = "y of chart \"" + chart.title + "\"";
  check.finite(x, series.x[i], "1");
  check.finite(y, series.y[i], "1");
  if (chart.logarithmic_x) check.positive(x + " with logarithmic x axis", series.x[i], "1");
  if (chart.logarithmic_y) check.positive(y + " with logarithmic y axis", series.y[i], "1");
  if (chart.y_from_zero) check.not_negative(y + " with y axis from zero", series.y[i], "1");
}

Curve visible_part(const Chart& chart, const Series& series) {
  Check{"Series", series.name}.that(series.x.size() == series.y.size(), "x and y have different lengths.",
                                    "Give one y for every x.");
  const auto has_place = [&](double x, double y) {
    return (!chart.logarithmic_x || x > 0.0) && (!chart.logarithmic_y || y > 0.0) && (!chart.y_from_zero || y >= 0.0);
  };
  Curve visible;
  visible.x.reserve(series.x.size());
  visible.y.reserve(series.y.size());
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    const double x = series.x[i], y = series.y[i];
    // Messages are made only where one is needed.
    if (!std::isfinite(x) || !std::isfinite(y)) check_point(chart, series, i);
    if (chart.x_range && (x < chart.x_range->first || x > chart.x_range->second)) continue;
    if (!has_place(x, y)) check_point(chart, series, i);
    visible.x.push_back(x);
    visible.y.push_back(y);
  }
  return visible;
}

/// Thinned where it appears: on a logarithmic axis a pixel is a factor, not a difference.
Curve thinned(const Chart& chart, Curve curve, int width, int height) {
  const auto take_logarithm = [](std::vector<double>& values) {
    for (double& value : values) value = std::log10(value);
  };
  const auto take_power = [](std::vector<double>& values) {
    for (double& value : values) value = std::pow(10.0, value);
  };
  if (chart.logarithmic_x) take_logarithm(curve.x);
  if (chart.logarithmic_y) take_logarithm(curve.y);
  curve = thin_out(curve, width, height);
  if (chart.logarithmic_x) take_power(curve.x);
  if (chart.logarithmic_y) take_power(curve.y);
  return curve;
}

}  // namespace

Curve drawn_curve(const Chart& chart, const Series& series, int width, int height) {
  return thinned(chart, visible_part(chart, series), width, height);
}

}  // namespace moat
