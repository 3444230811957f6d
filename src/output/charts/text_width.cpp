#include "output/charts/text_width.hpp"

#include <array>
#include <cstddef>

namespace moat {
namespace {

/// Advance widths of Arial for the characters from ' ' to '~', thousandths of the font size.
constexpr std::array<short, 95> advance{278,  278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
                                        556,  556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
                                        1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
                                        667,  778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
                                        333,  556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
                                        556,  556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584};
/// Advance of any other character. Signs of the Far East are as wide as high.
constexpr double other_advance = 600.0, wide_advance = 1000.0;
/// DejaVu Sans over Arial, for usual texts.
constexpr double widest_face = 1.15;

bool continues_character(unsigned char byte) { return (byte & 0xC0U) == 0x80U; }

double advance_of(unsigned char byte) {
  if (byte >= ' ' && byte <= '~') return advance[static_cast<std::size_t>(byte - ' ')];
  if (continues_character(byte)) return 0.0;
  constexpr unsigned char first_of_three_bytes = 0xE3;  // U+3000 and above
  return byte >= first_of_three_bytes ? wide_advance : other_advance;
}

}  // namespace

double text_width(std::string_view text, double font_size) {
  double thousandths = 0.0;
  for (const char c : text) thousandths += advance_of(static_cast<unsigned char>(c));
  return widest_face * font_size * thousandths / 1000.0;
}

std::string shortened(std::string_view text, double font_size, double width) {
  if (text_width(text, font_size) <= width) return std::string{text};
  constexpr std::string_view dots = "...";
  std::string_view rest = text;
  while (!rest.empty() && text_width(rest, font_size) + text_width(dots, font_size) > width) {
    do rest.remove_suffix(1);
    while (!rest.empty() && continues_character(static_cast<unsigned char>(text[rest.size()])));
  }
  return std::string{rest}.append(dots);
}

}  // namespace moat
