#include "output/charts/svg_writer.hpp"

#include <algorithm>
#include <cmath>

#include "base/text/number_format.hpp"
#include "base/text/utf8_text.hpp"

namespace moat {
namespace {

using namespace chart_style;

bool begins_character(char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }

std::string number(double pixels) {
  constexpr double steps_per_pixel = 20.0, far_outside = 1e6;
  const double place = std::isfinite(pixels) ? std::clamp(pixels, -far_outside, far_outside) : 0.0;
  return to_significant(std::round(steps_per_pixel * place) / steps_per_pixel + 0.0, 9);  // + 0: no -0
}

std::string attribute(const char* name, std::string_view value) {
  return std::string{" "}.append(name).append("=\"").append(value).append("\"");
}

std::string class_of(Paint paint) { return paint.kind.empty() ? "" : attribute("class", paint.kind); }

std::string points_of(const std::vector<Pixel>& list) {
  std::string text;
  for (const Pixel& point : list) text += (text.empty() ? "" : " ") + number(point.x) + "," + number(point.y);
  return attribute("points", text) + "/>\n";
}

}  // namespace

double text_width(std::string_view text, double font_size) {
  // Averages of DejaVu Sans, the widest usual face. Signs of the Far East are as wide as high.
  constexpr double digit = 0.64, other = 0.54, wide = 1.0;
  constexpr unsigned char first_wide_byte = 0xE3;  // U+3000 and above
  double sizes = 0.0;
  for (const char c : text)
    if (begins_character(c))
      sizes += c >= '0' && c <= '9' ? digit : static_cast<unsigned char>(c) >= first_wide_byte ? wide : other;
  return font_size * sizes;
}

std::string shortened(std::string_view text, double font_size, double width) {
  if (text_width(text, font_size) <= width) return std::string{text};
  constexpr std::string_view dots = "...";
  constexpr std::size_t most = 2000;  // more than fit into any picture
  std::size_t length = std::min(text.size(), most);
  while (length > 0 && (text_width(text.substr(0, length), font_size) + text_width(dots, font_size) > width ||
                        !begins_character(text[length])))
    --length;
  return std::string{text.substr(0, length)}.append(dots);
}

SvgWriter::SvgWriter(int width, int height, std::string_view title, std::string_view description) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" + w + "\" height=\"" + h +
          "\" viewBox=\"0 0 " + w + " " + h +
          "\" font-family=\"Arial, Helvetica, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n<title>" +
          escaped_for_xml(title) + "</title>\n<desc>" + escaped_for_xml(description) + "</desc>\n<rect" +
          class_of(paper) + attribute("width", w) + attribute("height", h) + attribute("fill", paper.colour) +
          "/>\n<g fill=\"none\" stroke-linejoin=\"round\">\n";
}

void SvgWriter::line(const std::vector<Pixel>& points, Paint paint, double width, bool dashed) {
  text_ += "<polyline" + class_of(paint) + attribute("stroke", paint.colour) +
           (width == 1.0 ? "" : attribute("stroke-width", number(width))) +
           (dashed ? attribute("stroke-dasharray", "7 4") : "") + points_of(points);
}

void SvgWriter::area(const std::vector<Pixel>& points, Paint paint, double opacity) {
  text_ += "<polygon" + class_of(paint) + attribute("fill", paint.colour) +
           (opacity == 1.0 ? "" : attribute("fill-opacity", number(opacity))) + points_of(points);
}

void SvgWriter::rectangle(Pixel corner, double width, double height, std::string_view colour) {
  text_ += "<rect" + attribute("x", number(corner.x)) + attribute("y", number(corner.y)) +
           attribute("width", number(width)) + attribute("height", number(height)) + attribute("fill", colour) + "/>\n";
}

void SvgWriter::disc(Pixel centre, double radius, Paint paint) {
  text_ += "<circle" + class_of(paint) + attribute("cx", number(centre.x)) + attribute("cy", number(centre.y)) +
           attribute("r", number(radius)) + attribute("fill", paint.colour) + "/>\n";
}

void SvgWriter::text(Pixel place, std::string_view text, const Lettering& lettering) {
  // From the middle of the letters to their baseline, for the usual proportions of a sans-serif face: viewers do not
  // agree on dominant-baseline.
  const double drop = 0.36 * lettering.size;
  text_ += "<text" + (lettering.on_paper ? "" : class_of(ink)) +
           (lettering.upwards
                ? attribute("transform", "translate(" + number(place.x) + "," + number(place.y) + ") rotate(-90)") +
                      attribute("y", number(drop))
                : attribute("x", number(place.x)) + attribute("y", number(place.y + drop))) +
           attribute("font-size", number(lettering.size)) + (lettering.bold ? attribute("font-weight", "bold") : "") +
           attribute("text-anchor", lettering.anchor) + attribute("fill", ink.colour) + ">" + escaped_for_xml(text) +
           "</text>\n";
}

std::string SvgWriter::finish() { return std::move(text_) + "</g>\n</svg>\n"; }

}  // namespace moat
