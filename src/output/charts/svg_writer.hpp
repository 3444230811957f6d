// Elements of an SVG drawing.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace moat {

/// A place in a drawing, pixels from its upper left corner.
struct Pixel {
  double x = 0.0, y = 0.0;
};

/// How a line is drawn.
struct Stroke {
  std::string_view colour;  ///< "#0072b2"
  double width = 1.0;       ///< pixels
  bool dashed = false;
  std::string_view kind = {};  ///< name for style sheets; may be empty
};

/// How a text is drawn.
struct Lettering {
  enum class Anchor { start, middle, end };

  double size = 14.0;  ///< pixels
  Anchor anchor = Anchor::start;
  bool bold = false;
  bool upwards = false;   ///< read from bottom to top
  bool on_paper = false;  ///< on white ground also where a style sheet darkens the page
};

/// Writes an SVG document element by element. Coordinates are rounded to a twentieth of a pixel: finer is invisible and
/// makes files longer. Texts are escaped; bytes that XML does not allow are replaced.
class SvgWriter {
 public:
  /// The text of the drawing begins with its size, a white ground, and `title` and `description` for readers who
  /// do not see it.
  SvgWriter(int width, int height, std::string_view title, std::string_view description);

  void line(Pixel from, Pixel to, const Stroke& stroke);
  void polyline(const std::vector<Pixel>& points, const Stroke& stroke);
  /// The inside of a closed line. opacity: 0 to 1.
  void area(const std::vector<Pixel>& points, std::string_view colour, double opacity = 1.0,
            std::string_view kind = {});
  void rectangle(Pixel corner, double width, double height, std::string_view colour);
  void disc(Pixel centre, double radius, std::string_view colour, std::string_view kind = {});
  /// The vertical middle of the letters is at the place.
  void text(Pixel place, std::string_view text, const Lettering& lettering);

  /// Ends the drawing and returns it, without prolog.
  [[nodiscard]] std::string finish();

 private:
  void attribute(std::string_view name, double pixels);
  void attribute(std::string_view name, std::string_view value);
  void stroke(const Stroke& stroke);
  void points(const std::vector<Pixel>& list);

  std::string text_;
};

}  // namespace moat
