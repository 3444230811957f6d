// The device by which VTK draws SVG.
#pragma once

#include <memory>
#include <string>

class vtkContext2D;

namespace moat {

/// "#0072b2" of three bytes.
std::string hex_colour(const unsigned char* rgb);

/// A sheet of paper whose drawing becomes SVG.
class SvgSheet {
 public:
  SvgSheet(int width, int height);
  ~SvgSheet();
  SvgSheet(const SvgSheet&) = delete;
  SvgSheet& operator=(const SvgSheet&) = delete;

  /// Draws on this sheet.
  [[nodiscard]] vtkContext2D* painter();
  /// Before anything is drawn.
  void resize(int width, int height);
  /// Ends the drawing and returns the whole document, without prolog.
  [[nodiscard]] std::string finish();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace moat
