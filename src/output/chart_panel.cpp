#include "output/chart_panel.hpp"

#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkDoubleArray.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "base/check.hpp"
#include "output/chart_curve.hpp"

namespace moat {
namespace {

// Distances in pixels around the plot area of one panel.
constexpr int left_margin = 92;
constexpr int right_margin = 24;
constexpr int bottom_margin = 58;
constexpr int legend_row = 22;
constexpr int y_label_middle = 18;
constexpr int title_size = 16;
constexpr int label_size = 14;
constexpr int tick_size = 13;

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
constexpr std::array<std::array<unsigned char, 3>, 7> palette{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}, {0, 0, 0}}};

void set_text(vtkTextProperty* text, int size) {
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetColor(0.15, 0.15, 0.15);
  text->SetBold(0);
}

/// Decades and, on a short axis, 2 and 5 between them; VTK's own choice often labels a single value.
void set_logarithmic_ticks(vtkAxis* axis, double lowest, double highest) {
  axis->SetLogScale(true);
  axis->SetBehavior(vtkAxis::FIXED);
  vtkNew<vtkDoubleArray> positions;
  vtkNew<vtkStringArray> labels;
  const int first = static_cast<int>(std::floor(std::log10(lowest) + 1e-9));
  const int last = static_cast<int>(std::ceil(std::log10(highest) - 1e-9));
  const bool is_short = last - first <= 3;
  for (int decade = first; decade <= last; ++decade) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (step > 1.0 && !is_short) break;
      const double value = step * std::pow(10.0, decade);
      if (value < lowest * (1.0 - 1e-9) || value > highest * (1.0 + 1e-9)) continue;
      positions->InsertNextValue(std::log10(value));
      labels->InsertNextValue(to_text(value));
    }
  }
  axis->SetUnscaledRange(lowest, highest);
  axis->SetCustomTickPositions(positions, labels);
}

/// The lowest and highest of 1, 2, 5 times a power of ten that hold both ends.
std::pair<double, double> logarithmic_range(double lowest, double highest) {
  const auto nice = [](double value, bool up) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    constexpr std::array steps{1.0, 2.0, 5.0, 10.0};
    double below = decade;
    for (const double step : steps) {
      if (step * decade <= value * (1.0 + 1e-9)) below = step * decade;
      if (step * decade >= value * (1.0 - 1e-9) && up) return step * decade;
    }
    return below;
  };
  const double bottom = nice(lowest, false);
  const double top = nice(highest, true);
  return {bottom, top > bottom ? top : 10.0 * bottom};
}

int pen_type(Series::Style style) {
  if (style == Series::Style::markers) return vtkPen::NO_PEN;
  return style == Series::Style::dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE;
}

constexpr float marker_size = 6.0f;
constexpr float line_width = 1.6f;

const std::array<unsigned char, 3>& colour_of(const Chart& chart, std::size_t series) {
  return palette[chart.series[series].colour.value_or(series) % palette.size()];
}

float text_width(vtkContext2D* painter, const std::string& text) {
  std::array<float, 4> bounds{};
  painter->ComputeStringBounds(text, bounds.data());
  // Measured in Arial; the faces that stand in for it run up to a sixth wider.
  return 1.15f * bounds[2];
}

void use_title_font(vtkContext2D* painter) {
  vtkTextProperty* text = painter->GetTextProp();
  set_text(text, title_size);
  text->SetBold(1);
  text->SetOrientation(0.0);
  text->SetJustificationToLeft();
  text->SetVerticalJustificationToCentered();
}

void use_legend_font(vtkContext2D* painter) {
  use_title_font(painter);
  set_text(painter->GetTextProp(), label_size);
}

constexpr float sample_width = 26.0f;
constexpr float sample_gap = 6.0f;

}  // namespace

void build_panel(const Chart& chart, Panel& panel) {
  const int plot_width = panel.width - left_margin - right_margin;
  const int plot_height = panel.height - panel.heading - bottom_margin;
  const Check check{"Chart", chart.title};
  if (chart.x_range) {
    check.finite("start of x range", chart.x_range->first, "1");
    check.finite("end of x range", chart.x_range->second, "1");
    check.that(chart.x_range->first < chart.x_range->second, "the x range ends before it starts.",
               "Give its lower end first.");
    if (chart.logarithmic_x) check.positive("start of logarithmic x range", chart.x_range->first, "1");
  }

  panel.chart = {vtkChartXY::New(), [](vtkChartXY* made) { made->Delete(); }};
  vtkChartXY* drawn = panel.chart.get();
  drawn->SetLayoutStrategy(vtkChart::AXES_TO_RECT);
  drawn->SetSize(vtkRectf(static_cast<float>(panel.left + left_margin),
                          static_cast<float>(panel.bottom + bottom_margin), static_cast<float>(plot_width),
                          static_cast<float>(plot_height)));
  drawn->SetShowLegend(false);
  drawn->GetBackgroundBrush()->SetOpacityF(0.0);

  double x_low = std::numeric_limits<double>::infinity();
  double x_high = -x_low;
  double y_low = x_low;
  double y_high = -x_low;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    const std::array<unsigned char, 3>& colour = colour_of(chart, i);
    const Curve curve = drawn_curve(chart, series, plot_width, plot_height);
    if (curve.x.empty()) continue;
    const auto [left, right] = std::minmax_element(curve.x.begin(), curve.x.end());
    const auto [low, high] = std::minmax_element(curve.y.begin(), curve.y.end());
    x_low = std::min(x_low, *left);
    x_high = std::max(x_high, *right);
    y_low = std::min(y_low, *low);
    y_high = std::max(y_high, *high);

    vtkNew<vtkTable> table;
    for (const auto& [name, values] : {std::pair{"x", &curve.x}, std::pair{"y", &curve.y}}) {
      vtkNew<vtkDoubleArray> array;
      array->SetName(name);
      for (const double value : *values) array->InsertNextValue(value);
      table->AddColumn(array);
    }
    const bool markers = series.style == Series::Style::markers;
    vtkPlot* plot = drawn->AddPlot(markers ? vtkChart::POINTS : vtkChart::LINE);
    plot->SetInputData(table, 0, 1);
    plot->SetColor(colour[0], colour[1], colour[2], 255);
    plot->SetWidth(markers ? marker_size : line_width);
    plot->GetPen()->SetLineType(markers ? vtkPen::SOLID_LINE : pen_type(series.style));
    if (markers) vtkPlotPoints::SafeDownCast(plot)->SetMarkerSize(marker_size);
  }
  check.that(x_low <= x_high, "there is no point to draw.",
             "Give at least one series with a point inside the x range.");

  for (const int side : {vtkAxis::BOTTOM, vtkAxis::LEFT}) {
    vtkAxis* axis = drawn->GetAxis(side);
    set_text(axis->GetTitleProperties(), label_size);
    set_text(axis->GetLabelProperties(), tick_size);
    axis->GetGridPen()->SetColor(225, 225, 225, 255);
    axis->GetPen()->SetColor(90, 90, 90, 255);
  }
  vtkAxis* x_axis = drawn->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* y_axis = drawn->GetAxis(vtkAxis::LEFT);
  x_axis->SetTitle(chart.x_label);
  // VTK puts the title beside the widest number as Arial has it, where wider faces run into it: see draw_labels.
  y_axis->SetTitle("");
  if (chart.x_range) std::tie(x_low, x_high) = *chart.x_range;
  if (chart.logarithmic_x) {
    if (!chart.x_range) std::tie(x_low, x_high) = logarithmic_range(x_low, x_high);
    set_logarithmic_ticks(x_axis, x_low, x_high);
  } else if (chart.x_range) {
    x_axis->SetBehavior(vtkAxis::FIXED);
    x_axis->SetUnscaledRange(x_low, x_high);
  }
  if (chart.logarithmic_y) {
    std::tie(y_low, y_high) = logarithmic_range(y_low, y_high);
    set_logarithmic_ticks(y_axis, y_low, y_high);
  } else if (chart.y_from_zero) {
    y_axis->SetBehavior(vtkAxis::FIXED);
    y_axis->SetUnscaledRange(0.0, y_high > 0.0 ? 1.05 * y_high : 1.0);
  } else if (y_low == 0.0 && y_high == 0.0) {
    // Around zero alone VTK chooses 1e-7.
    y_axis->SetBehavior(vtkAxis::FIXED);
    y_axis->SetUnscaledRange(-1.0, 1.0);
  }
}

/// Places the legend at the right of the strip above the plot area, never on top of a curve or the title.
void lay_out_heading(vtkContext2D* painter, const Chart& chart, Panel& panel) {
  constexpr float between = 18.0f;
  panel.title = chart.title;
  panel.y_label = chart.y_label;
  const auto start = static_cast<float>(panel.left + left_margin);
  use_title_font(painter);
  const float title_end = start + text_width(painter, panel.title) + between;
  use_legend_font(painter);
  std::vector<float> widths;
  float total = 0.0f;
  for (std::size_t i = 0; i < chart.series.size(); ++i) {
    const Series& series = chart.series[i];
    if (series.name.empty()) continue;
    panel.legend.push_back({series.name, series.style, colour_of(chart, i)});
    widths.push_back(sample_width + sample_gap + text_width(painter, series.name) + between);
    total += widths.back();
  }
  const auto end = static_cast<float>(panel.left + panel.width - right_margin);
  const bool beside_title = title_end + total <= end + between;
  float x = beside_title ? end + between - total : start;
  int row = beside_title ? 0 : 1;
  for (std::size_t i = 0; i < panel.legend.size(); ++i) {
    if (row > 0 && x > start && x + widths[i] > end + between) {
      x = start;
      ++row;
    }
    panel.legend[i].x = x;
    panel.legend[i].row = row;
    x += widths[i];
  }
  panel.heading = top_margin + row * legend_row;
}

void draw_labels(vtkContext2D* painter, const Panel& panel) {
  const int middle_of_margin = panel.bottom + panel.height - top_margin / 2 - 2;
  const float title_height = static_cast<float>(middle_of_margin);
  use_title_font(painter);
  painter->DrawString(static_cast<float>(panel.left + left_margin), title_height, panel.title);
  use_legend_font(painter);
  for (const LegendEntry& entry : panel.legend) {
    const float y = title_height - static_cast<float>(entry.row * legend_row);
    painter->DrawString(entry.x + sample_width + sample_gap, y, entry.name);
    painter->GetPen()->SetColor(entry.colour[0], entry.colour[1], entry.colour[2]);
    painter->GetPen()->SetOpacity(255);
    if (entry.style == Series::Style::markers) {
      painter->GetPen()->SetWidth(marker_size);
      painter->GetPen()->SetLineType(vtkPen::SOLID_LINE);
      std::array<float, 2> point{entry.x + 0.5f * sample_width, y};
      painter->DrawMarkers(VTK_MARKER_CIRCLE, false, point.data(), 1, nullptr, 0);
    } else {
      painter->GetPen()->SetWidth(2.0f);
      painter->GetPen()->SetLineType(pen_type(entry.style));
      painter->DrawLine(entry.x, y, entry.x + sample_width, y);
    }
  }

  vtkTextProperty* text = painter->GetTextProp();
  text->SetOrientation(90.0);
  text->SetJustificationToCentered();
  text->SetVerticalJustificationToCentered();
  const int plot_height = panel.height - panel.heading - bottom_margin;
  const int middle_of_plot = panel.bottom + bottom_margin + plot_height / 2;
  painter->DrawString(static_cast<float>(panel.left + y_label_middle), static_cast<float>(middle_of_plot),
                      panel.y_label);
}

}  // namespace moat
