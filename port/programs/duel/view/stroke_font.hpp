// SPDX-License-Identifier: MIT
#pragma once
// Letters as strokes, for the window: it shows digits and a few words, at any size. Capitals,
// digits and signs; small letters are shown as capitals, what is none of ASCII as a box. A library
// for text would want a font file to be found when the program runs.

#include <string_view>
#include <vector>

#include "programs/duel/canvas.hpp"

namespace batuta::host {

/// A straight stroke of a letter, pixels; a dot begins where it ends.
struct PenStroke {
  Pixel from;
  Pixel to;
};

/// @param size  of the font, as in SVG: capitals are 0.7 of it high
double text_width(std::string_view words, double size);

/// @param at  the left end of the base line
/// @param strokes  what was in it goes
void write_strokes(std::string_view words, Pixel at, double size, std::vector<PenStroke>& strokes);

}  // namespace batuta::host
