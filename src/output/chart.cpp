#include "output/chart.hpp"

#include <vtkAutoInit.h>
#include <vtkAxis.h>
#include <vtkBrush.h>
#include <vtkChartXY.h>
#include <vtkContext2D.h>
#include <vtkContextScene.h>
#include <vtkDoubleArray.h>
#include <vtkMatrix3x3.h>
#include <vtkNew.h>
#include <vtkPen.h>
#include <vtkPlotLine.h>
#include <vtkPlotPoints.h>
#include <vtkSVGContextDevice2D.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTextProperty.h>
#include <vtkViewport.h>
#include <vtkWindow.h>
#include <vtkXMLDataElement.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <mutex>
#include <sstream>
#include <tuple>

#include "base/check.hpp"
#include "base/error.hpp"
#include "output/envelope.hpp"
#include "output/file_io.hpp"

// Text is measured with FreeType.
VTK_MODULE_INIT(vtkRenderingFreeType)

namespace moat {
namespace {

// Distances in pixels around the plot area of one panel.
constexpr int left_margin = 92;
constexpr int right_margin = 24;
constexpr int top_margin = 40;
constexpr int bottom_margin = 58;
constexpr int legend_row = 22;
constexpr int y_label_middle = 18;
constexpr int title_size = 16;
constexpr int label_size = 14;
constexpr int tick_size = 13;

/// Colours that stay apart for colour-blind readers (Okabe and Ito).
constexpr std::array<std::array<unsigned char, 3>, 7> palette{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}, {0, 0, 0}}};

/// A sheet of paper of given size: all the SVG device asks of a window.
class PaperWindow : public vtkWindow {
 public:
  static PaperWindow* New() { VTK_STANDARD_NEW_BODY(PaperWindow); }
  vtkTypeMacro(PaperWindow, vtkWindow)
};

class Paper : public vtkViewport {
 public:
  static Paper* New() { VTK_STANDARD_NEW_BODY(Paper); }
  vtkTypeMacro(Paper, vtkViewport)

      void resize(int width, int height) {
    window_->SetSize(width, height);
    this->VTKWindow = window_;
  }
  vtkWindow* GetVTKWindow() override { return window_; }
  vtkAssemblyPath* PickProp(double, double) override { return nullptr; }
  vtkAssemblyPath* PickProp(double, double, double, double) override { return nullptr; }
  ~Paper() override { this->VTKWindow = nullptr; }

 private:
  vtkNew<PaperWindow> window_;
};

std::string hex_colour(const unsigned char* rgb) {
  std::array<char, 8> text;
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", rgb[0], rgb[1], rgb[2]);
  return text.data();
}

/// VTK's SVG device writes data coordinates under an SVG transform, which distorts line widths, and its <text> elements
/// are misplaced in most viewers. This one applies transforms itself, writes pixels, and places text by standard
/// attributes only. It does not clip: nothing outside the plot area is given to it.
class PixelSvgDevice : public vtkSVGContextDevice2D {
 public:
  static PixelSvgDevice* New() { VTK_STANDARD_NEW_BODY(PixelSvgDevice); }
  vtkTypeMacro(PixelSvgDevice, vtkSVGContextDevice2D)

      void SetMatrix(vtkMatrix3x3* matrix) override {
    matrix_->DeepCopy(matrix);
  }
  void GetMatrix(vtkMatrix3x3* matrix) override { matrix->DeepCopy(matrix_); }
  void MultiplyMatrix(vtkMatrix3x3* matrix) override { vtkMatrix3x3::Multiply3x3(matrix_, matrix, matrix_); }
  void PushMatrix() override {
    std::array<double, 9> entries;
    std::copy_n(matrix_->GetData(), 9, entries.begin());
    stack_.push_back(entries);
  }
  void PopMatrix() override {
    std::copy_n(stack_.back().begin(), 9, matrix_->GetData());
    stack_.pop_back();
  }
  void EnableClipping(bool) override {}
  void SetClipping(int*) override {}

  void DrawPoly(float* points, int n, unsigned char*, int) override {
    if (this->Pen->GetLineType() == vtkPen::NO_PEN) return;
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawPoly(pixels.data(), n);
  }
  void DrawLines(float* points, int n, unsigned char*, int) override {
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawLines(pixels.data(), n);
  }
  void DrawQuad(float* points, int n) override { DrawPolygon(points, n); }
  void DrawPolygon(float* points, int n) override {
    if (this->Brush->GetOpacity() == 0) return;
    std::vector<float> pixels = to_pixels(points, n);
    Superclass::DrawPolygon(pixels.data(), n);
  }
  void DrawMarkers(int, bool, float* points, int n, unsigned char*, int) override {
    const std::vector<float> pixels = to_pixels(points, n);
    const std::string colour = hex_colour(this->Pen->GetColor());
    for (std::size_t i = 0; i + 1 < pixels.size(); i += 2) {
      vtkNew<vtkXMLDataElement> circle;
      circle->SetName("circle");
      circle->SetFloatAttribute("cx", pixels[i]);
      circle->SetFloatAttribute("cy", this->CanvasHeight - pixels[i + 1]);
      circle->SetFloatAttribute("r", 0.5f * this->Pen->GetWidth());
      circle->SetAttribute("fill", colour.c_str());
      this->ActiveNode->AddNestedElement(circle);
    }
  }
  using vtkSVGContextDevice2D::DrawString;
  void DrawString(float* point, const vtkStdString& string) override {
    const std::vector<float> pixel = to_pixels(point, 1);
    const int size = this->TextProp->GetFontSize();
    // From the point to the baseline, for the usual proportions of a sans-serif face.
    double drop = -0.21 * size;
    if (this->TextProp->GetVerticalJustification() == VTK_TEXT_CENTERED) drop = 0.36 * size;
    if (this->TextProp->GetVerticalJustification() == VTK_TEXT_TOP) drop = 0.78 * size;
    std::ostringstream transform;
    transform << "translate(" << pixel[0] << "," << this->CanvasHeight - pixel[1] << ")";
    if (this->TextProp->GetOrientation() != 0.0) transform << " rotate(" << -this->TextProp->GetOrientation() << ")";
    std::array<double, 3> colour;
    this->TextProp->GetColor(colour.data());
    std::array<unsigned char, 3> bytes;
    for (std::size_t i = 0; i < 3; ++i) bytes[i] = static_cast<unsigned char>(std::lround(255.0 * colour[i]));

    vtkNew<vtkXMLDataElement> text;
    text->SetName("text");
    text->SetAttribute("transform", transform.str().c_str());
    text->SetFloatAttribute("y", static_cast<float>(drop));
    text->SetIntAttribute("font-size", size);
    text->SetAttribute("fill", hex_colour(bytes.data()).c_str());
    if (this->TextProp->GetBold() != 0) text->SetAttribute("font-weight", "bold");
    if (this->TextProp->GetJustification() == VTK_TEXT_CENTERED) text->SetAttribute("text-anchor", "middle");
    if (this->TextProp->GetJustification() == VTK_TEXT_RIGHT) text->SetAttribute("text-anchor", "end");
    text->SetCharacterData(string.c_str(), static_cast<int>(string.size()));
    this->ActiveNode->AddNestedElement(text);
  }

 private:
  /// Data to pixels, rounded to a twentieth: finer is invisible and only makes files longer.
  std::vector<float> to_pixels(const float* points, int n) const {
    const double* m = matrix_->GetData();
    std::vector<float> pixels(2 * static_cast<std::size_t>(n));
    const auto rounded = [](double value) { return static_cast<float>(std::round(20.0 * value) / 20.0); };
    for (std::size_t i = 0; i < pixels.size(); i += 2) {
      const double x = static_cast<double>(points[i]);
      const double y = static_cast<double>(points[i + 1]);
      pixels[i] = rounded(m[0] * x + m[1] * y + m[2]);
      pixels[i + 1] = rounded(m[3] * x + m[4] * y + m[5]);
    }
    return pixels;
  }

  vtkNew<vtkMatrix3x3> matrix_;
  std::vector<std::array<double, 9>> stack_;
};

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

struct LegendEntry {
  std::string name;
  Series::Style style;
  std::array<unsigned char, 3> colour;
  float x = 0.0f;  ///< left end of the line sample, pixels
  int row = 0;     ///< 0: beside the title
};

/// One panel: the VTK chart and what is drawn by hand above it.
struct Panel {
  vtkNew<vtkChartXY> chart;
  std::string title, y_label;
  std::vector<LegendEntry> legend;
  int heading = top_margin;  // height of the strip above the plot area
  int width = 0;             // of the whole panel
  int height = 0;
  int left = 0;    // pixels
  int bottom = 0;  // pixels, upwards
};

int pen_type(Series::Style style) {
  if (style == Series::Style::markers) return vtkPen::NO_PEN;
  return style == Series::Style::dashed ? vtkPen::DASH_LINE : vtkPen::SOLID_LINE;
}

constexpr float marker_size = 6.0f;
constexpr float line_width = 1.6f;

const std::array<unsigned char, 3>& colour_of(const Chart& chart, std::size_t series) {
  return palette[chart.series[series].colour.value_or(series) % palette.size()];
}

void build_panel(const Chart& chart, const Panel& panel) {
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

  vtkChartXY* drawn = panel.chart;
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
    const Curve curve = thinned(chart, visible_part(chart, series), plot_width, plot_height);
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
  const float title_height = static_cast<float>(panel.bottom + panel.height - top_margin / 2 - 2);
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
  painter->DrawString(static_cast<float>(panel.left + y_label_middle),
                      static_cast<float>(panel.bottom + bottom_margin + plot_height / 2), panel.y_label);
}

/// Puts the SVG header around what the device draws into `page`.
std::string document(vtkXMLDataElement* page, int width, int height) {
  const std::string w = std::to_string(width);
  const std::string h = std::to_string(height);
  std::ostringstream text;
  text << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << w << "\" height=\"" << h << "\" viewBox=\"0 0 " << w
       << " " << h << "\" font-family=\"Arial, Helvetica, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n"
       << "<rect width=\"" << w << "\" height=\"" << h << "\" fill=\"#ffffff\"/>\n";
  page->PrintXML(text, vtkIndent{});
  text << "</svg>\n";
  return text.str();
}

std::string paint(const std::vector<Chart>& charts, int width, int height, std::size_t columns) {
  vtkNew<vtkXMLDataElement> page;
  page->SetName("g");
  // The device states a stroke or a fill for each thing it draws, never both.
  page->SetAttribute("stroke", "none");
  page->SetAttribute("fill", "none");
  page->SetAttribute("stroke-linejoin", "round");
  vtkNew<vtkXMLDataElement> definitions;  // stays empty: PixelSvgDevice uses none

  vtkNew<Paper> paper;
  vtkNew<PixelSvgDevice> device;
  device->SetSVGContext(page, definitions);
  paper->resize(width, height);
  device->Begin(paper);
  vtkNew<vtkContext2D> painter;
  painter->Begin(device);

  // Panels of a row have one height, so that their plot areas are aligned.
  std::vector<Panel> panels(charts.size());
  int total_height = 0;
  for (std::size_t first = 0; first < charts.size(); first += columns) {
    const std::size_t end = std::min(first + columns, charts.size());
    int heading = 0;
    for (std::size_t i = first; i < end; ++i) {
      panels[i].width = width / static_cast<int>(columns);
      panels[i].left = static_cast<int>(i - first) * panels[i].width;
      lay_out_heading(painter, charts[i], panels[i]);
      heading = std::max(heading, panels[i].heading);
    }
    for (std::size_t i = first; i < end; ++i) {
      panels[i].heading = heading;
      panels[i].height = height + heading - top_margin;
    }
    total_height += panels[first].height;
  }
  paper->resize(width, total_height);
  device->Begin(paper);

  vtkNew<vtkContextScene> scene;
  scene->SetGeometry(width, total_height);
  int top = total_height;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    if (i % columns == 0) top -= panels[i].height;
    panels[i].bottom = top;
    build_panel(charts[i], panels[i]);
    scene->AddItem(panels[i].chart);
  }
  scene->Paint(painter);
  for (const Panel& panel : panels) draw_labels(painter, panel);
  painter->End();
  device->End();
  return document(page, width, total_height);
}

}  // namespace

std::string svg_text(const std::vector<Chart>& charts, int width, int height, int columns) {
  const Check check{"Chart", charts.empty() ? "" : charts.front().title};
  check.that(!charts.empty(), "there is no chart to draw.", "Give at least one.");
  check.that(columns >= 1, "columns", columns, "1", ">= 1");
  check.that(width / columns >= 200, "width", width, "pixels", ">= 200 pixels for every column");
  check.that(height >= 150, "height", height, "pixels", ">= 150 pixels");
  static std::mutex fonts;
  const std::lock_guard lock{fonts};
  return paint(charts, width, height, static_cast<std::size_t>(columns));
}

void write_svg(const Chart& chart, const std::filesystem::path& path, int width, int height) {
  write_svg(std::vector{chart}, path, width, height);
}

void write_svg(const std::vector<Chart>& charts, const std::filesystem::path& path, int width, int panel_height,
               int columns) {
  write_file(path, "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n" + svg_text(charts, width, panel_height, columns));
}

}  // namespace moat
