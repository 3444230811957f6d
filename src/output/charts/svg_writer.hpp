// Elements of an SVG drawing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "output/charts/chart_style.hpp"

namespace moat {

/// A place in a drawing, pixels from its upper left corner.
struct Pixel {
  double x = 0.0, y = 0.0;
};

/// How a text is drawn.
struct Lettering {
  double size = chart_style::label_size;  ///< pixels
  const char* anchor = "start";           ///< the part of the text that stands at its place: start, middle or end
  bool bold = false;
  bool upwards = false;   ///< read from bottom to top
  bool on_paper = false;  ///< on white ground also where a style sheet darkens the page
};

/// Room that UTF-8 text takes at most in the usual faces, pixels, for a font size in pixels.
double text_width(std::string_view text, double font_size);
/// The text if it fits into `width` pixels, else its beginning with "...".
std::string shortened(std::string_view text, double font_size, double width);

/// Writes an SVG document element by element. Coordinates are rounded to a twentieth of a pixel: finer is invisible and
/// makes files longer. Texts are escaped; bytes that XML does not allow are replaced.
class SvgWriter {
 public:
  /// The text of the drawing begins with its size, a white ground, and `title` and `description` for readers who
  /// do not see it.
  SvgWriter(int width, int height, std::string_view title, std::string_view description);

  void line(const std::vector<Pixel>& points, chart_style::Paint paint, double width = 1.0, bool dashed = false);
  /// The inside of a closed line. opacity: 0 to 1.
  void area(const std::vector<Pixel>& points, chart_style::Paint paint, double opacity = 1.0);
  void rectangle(Pixel corner, double width, double height, std::string_view colour);
  void disc(Pixel centre, double radius, chart_style::Paint paint);
  /// The vertical middle of the letters is at the place.
  void text(Pixel place, std::string_view text, const Lettering& lettering);

  /// Ends the drawing and returns it, without prolog.
  [[nodiscard]] std::string finish();

 private:
  std::string text_;
};

}  // namespace moat
