// Which colours an object has, as people call them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/types/color.h"
#include "core/types/detections.h"

namespace fovea {

// By hue, chroma and lightness in CIELAB (D65). The bounds are rounded from what fits best the 558
// colours of the XKCD survey (Munroe 2010) whose name ends with one of the terms: 91 % of those and
// of greys are called as there. What the light does to a colour is not taken out.
ColorName NameOfColor(const std::array<std::uint8_t, 3>& rgb);

// Those that at least an eighth of the points have, the most frequent first; the most frequent one
// where none is. Colours are told apart in steps of 8. Cost: some ns a point.
std::vector<ColorPart> ColorPartsOf(const std::vector<ColoredPoint>& cloud);

}  // namespace fovea
