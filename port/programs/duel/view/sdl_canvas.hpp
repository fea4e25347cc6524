// SPDX-License-Identifier: MIT
#pragma once
// A canvas that is an SDL renderer. Edges fade out over a pixel, since SDL smooths none.

#include <SDL.h>

#include <array>

#include "programs/duel/canvas.hpp"
#include "programs/duel/view/stroke_font.hpp"

namespace batuta::host {

class SdlCanvas final : public Canvas {
 public:
  /// @param renderer  outlives this; pixels are its logical ones
  explicit SdlCanvas(SDL_Renderer* renderer);

  void rectangle(Pixel corner, Pixel size, const Colour& fill) override;
  void line(Pixel a, Pixel b, const Stroke& stroke) override;
  /// Thin ones are drawn by SDL: they are long.
  void polyline(const std::vector<Pixel>& points, const Stroke& stroke) override;
  void circle(Pixel centre, double radius, const Stroke& stroke, const std::string& note) override;
  void star(Pixel centre, double radius, const Colour& fill) override;
  void text(Pixel at, std::string_view words, double size, Anchor anchor) override;

 private:
  /// A closed line of points around a shape, and how much is to be seen of the colour there.
  struct Ring {
    double reach;
    double opacity;
  };
  /// Fills from ring to ring. @param place  (point, reach) to a Pixel
  template <std::size_t kRings, class Place>
  void fill(int around, const std::array<Ring, kRings>& rings, const Colour& colour,
            const Place& place);

  void add_stroke(const PenStroke& stroke, double width);
  void draw_vertices();

  SDL_Renderer* renderer_;
  std::vector<SDL_Vertex> vertices_;
  std::vector<int> indices_;
  std::vector<SDL_FPoint> points_;
  std::vector<PenStroke> strokes_;
};

}  // namespace batuta::host
