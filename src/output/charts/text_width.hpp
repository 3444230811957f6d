// The width of a text before it is drawn.
#pragma once

#include <string>
#include <string_view>

namespace moat {

/// Width in pixels of UTF-8 text in Arial of a font size in pixels. A viewer may take another face in its place; room
/// for the widest usual one (DejaVu Sans) is included.
double text_width(std::string_view text, double font_size);

/// The text if it fits into `width` pixels, else its beginning with "...".
std::string shortened(std::string_view text, double font_size, double width);

}  // namespace moat
