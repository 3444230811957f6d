#include "output/chart.hpp"

#include <vtkChartXY.h>
#include <vtkContextScene.h>
#include <vtkNew.h>

#include <algorithm>
#include <mutex>

#include "base/check.hpp"
#include "output/chart_panel.hpp"
#include "output/classic_locale.hpp"
#include "output/file_io.hpp"
#include "output/svg_device.hpp"

namespace moat {
namespace {

std::string paint(const std::vector<Chart>& charts, int width, int height, std::size_t columns) {
  SvgSheet sheet{width, height};
  // Panels of a row have one height, so that their plot areas are aligned.
  std::vector<Panel> panels(charts.size());
  int total_height = 0;
  for (std::size_t first = 0; first < charts.size(); first += columns) {
    const std::size_t end = std::min(first + columns, charts.size());
    int heading = 0;
    for (std::size_t i = first; i < end; ++i) {
      panels[i].width = width / static_cast<int>(columns);
      panels[i].left = static_cast<int>(i - first) * panels[i].width;
      lay_out_heading(sheet.painter(), charts[i], panels[i]);
      heading = std::max(heading, panels[i].heading);
    }
    for (std::size_t i = first; i < end; ++i) {
      panels[i].heading = heading;
      panels[i].height = height + heading - top_margin;
    }
    total_height += panels[first].height;
  }
  sheet.resize(width, total_height);

  vtkNew<vtkContextScene> scene;
  scene->SetGeometry(width, total_height);
  int top = total_height;
  for (std::size_t i = 0; i < charts.size(); ++i) {
    if (i % columns == 0) top -= panels[i].height;
    panels[i].bottom = top;
    build_panel(charts[i], panels[i]);
    scene->AddItem(panels[i].chart.get());
  }
  scene->Paint(sheet.painter());
  for (const Panel& panel : panels) draw_labels(sheet.painter(), panel);
  return sheet.finish();
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
  const ClassicLocale classic;
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
