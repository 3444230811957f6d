#include "output/chart_curve.hpp"

#include <cmath>
#include <string>

#include "base/check.hpp"

namespace moat {
namespace {

Curve visible_part(const Chart& chart, const Series& series) {
  const Check check{"Series", series.name};
  check.that(series.x.size() == series.y.size(), "x and y have different lengths.", "Give one y for every x.");
  const std::string chart_name = "of chart \"" + chart.title + "\"";
  Curve visible;
  visible.x.reserve(series.x.size());
  visible.y.reserve(series.y.size());
  for (std::size_t i = 0; i < series.x.size(); ++i) {
    check.finite("x " + chart_name, series.x[i], "1");
    check.finite("y " + chart_name, series.y[i], "1");
    if (chart.x_range && (series.x[i] < chart.x_range->first || series.x[i] > chart.x_range->second)) continue;
    if (chart.logarithmic_x) check.positive("x " + chart_name + " with logarithmic x axis", series.x[i], "1");
    if (chart.logarithmic_y) check.positive("y " + chart_name + " with logarithmic y axis", series.y[i], "1");
    if (chart.y_from_zero) check.not_negative("y " + chart_name + " with y axis from zero", series.y[i], "1");
    visible.x.push_back(series.x[i]);
    visible.y.push_back(series.y[i]);
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
