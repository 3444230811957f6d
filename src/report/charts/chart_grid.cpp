#include "report/charts/chart_grid.hpp"

namespace moat::html {

std::string chart_grid(const std::vector<Chart>& charts, int width, int height) {
  std::string html = "<div class=\"charts\" style=\"--width: " + std::to_string(width) + "px\">\n";
  for (const Chart& chart : charts) html += svg_text({chart}, width, height);
  return html + "</div>\n";
}

std::string wide_picture(const std::string& svg) { return "<div class=\"wide-picture\">\n" + svg + "</div>\n"; }

}  // namespace moat::html
