// One panel of a chart: plot area, axes, title and legend.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "output/chart.hpp"

class vtkChartXY;
class vtkContext2D;

namespace moat {

/// Height of the strip above the plot area that holds the title, pixels.
inline constexpr int top_margin = 40;

struct LegendEntry {
  std::string name;
  Series::Style style;
  std::array<unsigned char, 3> colour;
  float x = 0.0f;  ///< left end of the line sample, pixels
  int row = 0;     ///< 0: beside the title
};

/// One panel: the VTK chart, and title and legend drawn by hand above it.
struct Panel {
  std::shared_ptr<vtkChartXY> chart;  // made by build_panel
  std::string title, y_label;
  std::vector<LegendEntry> legend;
  int heading = top_margin;  // height of the strip above the plot area
  int width = 0;             // of the whole panel
  int height = 0;
  int left = 0;    // pixels
  int bottom = 0;  // pixels, upwards
};

/// Places title and legend in the strip above the plot area, never on top of a curve; sets Panel::heading.
void lay_out_heading(vtkContext2D* painter, const Chart& chart, Panel& panel);
/// Makes Panel::chart. Throws as svg_text does.
void build_panel(const Chart& chart, Panel& panel);
/// Draws title, legend and the label of the y axis.
void draw_labels(vtkContext2D* painter, const Panel& panel);

}  // namespace moat
