#include "output/charts/svg_writer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "output/charts/chart_style.hpp"
#include "output/files/xml_text.hpp"

namespace moat {
namespace {

void append_integer(std::string& out, long value) {
  std::array<char, 24> digits;
  out.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

/// Rounded to a twentieth.
void append_pixels(std::string& out, double pixels) {
  constexpr double steps_per_pixel = 20.0;
  constexpr long hundredths_per_step = 5, hundred = 100, ten = 10;
  constexpr double far_outside = 1e6;
  const double place = std::isfinite(pixels) ? std::clamp(pixels, -far_outside, far_outside) : 0.0;
  long hundredths = std::lround(steps_per_pixel * place) * hundredths_per_step;
  if (hundredths < 0) {
    out += '-';
    hundredths = -hundredths;
  }
  append_integer(out, hundredths / hundred);
  const long rest = hundredths % hundred;
  if (rest == 0) return;
  out += '.';
  out += static_cast<char>('0' + rest / ten);
  if (rest % ten != 0) out += static_cast<char>('0' + rest % ten);
}

}  // namespace

SvgWriter::SvgWriter(int width, int height, std::string_view title, std::string_view description) {
  const std::string w = std::to_string(width), h = std::to_string(height);
  text_ = "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" width=\"" + w + "\" height=\"" + h +
          "\" viewBox=\"0 0 " + w + " " + h +
          "\" font-family=\"Arial, Helvetica, 'Liberation Sans', 'DejaVu Sans', sans-serif\">\n<title>" +
          escaped_for_xml(title) + "</title>\n<desc>" + escaped_for_xml(description) + "</desc>\n<rect class=\"" +
          chart_style::paper_class + "\" width=\"" + w + "\" height=\"" + h + "\" fill=\"" + chart_style::paper +
          "\"/>\n<g fill=\"none\" stroke-linejoin=\"round\">\n";
}

void SvgWriter::attribute(std::string_view name, std::string_view value) {
  text_.append(" ").append(name).append("=\"").append(value).append("\"");
}

void SvgWriter::attribute(std::string_view name, double pixels) {
  text_.append(" ").append(name).append("=\"");
  append_pixels(text_, pixels);
  text_ += '"';
}

void SvgWriter::stroke(const Stroke& stroke) {
  if (!stroke.kind.empty()) attribute("class", stroke.kind);
  attribute("stroke", stroke.colour);
  if (stroke.width != 1.0) attribute("stroke-width", stroke.width);
  if (stroke.dashed) attribute("stroke-dasharray", "7 4");
}

void SvgWriter::line(Pixel from, Pixel to, const Stroke& stroke_of_line) {
  text_ += "<line";
  attribute("x1", from.x);
  attribute("y1", from.y);
  attribute("x2", to.x);
  attribute("y2", to.y);
  stroke(stroke_of_line);
  text_ += "/>\n";
}

void SvgWriter::points(const std::vector<Pixel>& list) {
  text_ += " points=\"";
  for (const Pixel& point : list) {
    append_pixels(text_, point.x);
    text_ += ',';
    append_pixels(text_, point.y);
    text_ += ' ';
  }
  if (!list.empty()) text_.pop_back();
  text_ += "\"/>\n";
}

void SvgWriter::polyline(const std::vector<Pixel>& list, const Stroke& stroke_of_line) {
  text_ += "<polyline";
  stroke(stroke_of_line);
  points(list);
}

void SvgWriter::area(const std::vector<Pixel>& list, std::string_view colour, double opacity, std::string_view kind) {
  text_ += "<polygon";
  if (!kind.empty()) attribute("class", kind);
  attribute("fill", colour);
  if (opacity != 1.0) attribute("fill-opacity", opacity);
  points(list);
}

void SvgWriter::rectangle(Pixel corner, double width, double height, std::string_view colour) {
  text_ += "<rect";
  attribute("x", corner.x);
  attribute("y", corner.y);
  attribute("width", width);
  attribute("height", height);
  attribute("fill", colour);
  text_ += "/>\n";
}

void SvgWriter::disc(Pixel centre, double radius, std::string_view colour, std::string_view kind) {
  text_ += "<circle";
  if (!kind.empty()) attribute("class", kind);
  attribute("cx", centre.x);
  attribute("cy", centre.y);
  attribute("r", radius);
  attribute("fill", colour);
  text_ += "/>\n";
}

void SvgWriter::text(Pixel place, std::string_view text, const Lettering& lettering) {
  // From the middle of the letters to their baseline, for the usual proportions of a sans-serif face: viewers do not
  // agree on dominant-baseline.
  const double drop = 0.36 * lettering.size;
  text_ += "<text";
  if (!lettering.on_paper) attribute("class", chart_style::ink_class);
  if (lettering.upwards) {
    text_ += " transform=\"translate(";
    append_pixels(text_, place.x);
    text_ += ',';
    append_pixels(text_, place.y);
    text_ += ") rotate(-90)\"";
    attribute("y", drop);
  } else {
    attribute("x", place.x);
    attribute("y", place.y + drop);
  }
  attribute("font-size", lettering.size);
  if (lettering.bold) attribute("font-weight", "bold");
  if (lettering.anchor == Lettering::Anchor::middle) attribute("text-anchor", "middle");
  if (lettering.anchor == Lettering::Anchor::end) attribute("text-anchor", "end");
  attribute("fill", chart_style::ink);
  text_.append(">").append(escaped_for_xml(text)).append("</text>\n");
}

std::string SvgWriter::finish() { return std::move(text_) + "</g>\n</svg>\n"; }

}  // namespace moat
