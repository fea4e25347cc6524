// SPDX-License-Identifier: MIT

#include "programs/duel/view/sdl_canvas.hpp"

#include <algorithm>

namespace batuta::host {
namespace {

constexpr double kPi = 3.14159265358979;
constexpr double kHalf = 0.5;  // of the pixel over which an edge fades out
constexpr double kThin = 2;    // width of a line that SDL draws by itself
constexpr double kThinnestPen = 1.2;
constexpr double kPenOfSize = 0.09;  // width of a letter's strokes, of the font's size

Uint8 byte(double share) {
  return static_cast<Uint8>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

SDL_Color sdl_colour(const Colour& colour, double opacity) {
  const auto part = [](int value) { return static_cast<Uint8>(std::clamp(value, 0, 255)); };
  return {part(colour.red), part(colour.green), part(colour.blue), byte(opacity)};
}

SDL_FPoint sdl_point(Pixel p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

/// Points around a circle of this radius: no corner is to be seen. Even.
int points_around(double radius) {
  return 2 * std::clamp(static_cast<int>(std::ceil(2.5 * std::sqrt(radius + 1))), 4, 24);
}

}  // namespace

SdlCanvas::SdlCanvas(SDL_Renderer* renderer) : renderer_(renderer) {
  SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
}

template <std::size_t kRings, class Place>
void SdlCanvas::fill(int around, const std::array<Ring, kRings>& rings, const Colour& colour,
                     const Place& place) {
  vertices_.clear();
  indices_.clear();
  for (const Ring& ring : rings) {
    for (int i = 0; i < around; ++i) {
      vertices_.push_back(
          {sdl_point(place(i, ring.reach)), sdl_colour(colour, ring.opacity), {0, 0}});
    }
  }
  const auto vertex = [&](int ring, int i) { return ring * around + i % around; };
  for (int ring = 0; ring + 1 < static_cast<int>(kRings); ++ring) {
    for (int i = 0; i < around; ++i) {
      for (const int corner : {vertex(ring, i), vertex(ring, i + 1), vertex(ring + 1, i),
                               vertex(ring, i + 1), vertex(ring + 1, i), vertex(ring + 1, i + 1)}) {
        indices_.push_back(corner);
      }
    }
  }
  draw_vertices();
}

void SdlCanvas::rectangle(Pixel corner, Pixel size, const Colour& fill) {
  const SDL_Color colour = sdl_colour(fill, 1);
  SDL_SetRenderDrawColor(renderer_, colour.r, colour.g, colour.b, colour.a);
  const SDL_FRect area = {static_cast<float>(corner.x), static_cast<float>(corner.y),
                          static_cast<float>(size.x), static_cast<float>(size.y)};
  SDL_RenderFillRectF(renderer_, &area);
}

void SdlCanvas::line(Pixel a, Pixel b, const Stroke& stroke) {
  const double radius = stroke.width / 2;
  const double along = std::atan2(b.y - a.y, b.x - a.x);
  const int around = points_around(radius);
  const int end = around / 2;  // points of a half circle
  const double opacity = stroke.opacity * std::min(1.0, stroke.width);
  const std::array<Ring, 3> rings = {
      {{0, opacity}, {std::max(radius - kHalf, 0.0), opacity}, {radius + kHalf, 0}}};
  fill(around, rings, stroke.colour, [&](int i, double reach) {
    const bool at_b = i < end;
    const double turned = kPi * (at_b ? i : i - end) / (end - 1);
    const double angle = along + turned + (at_b ? -kPi / 2 : kPi / 2);
    const Pixel base = at_b ? b : a;
    return Pixel{base.x + reach * std::cos(angle), base.y + reach * std::sin(angle)};
  });
}

void SdlCanvas::polyline(const std::vector<Pixel>& points, const Stroke& stroke) {
  if (stroke.width > kThin) {
    for (std::size_t i = 1; i < points.size(); ++i) line(points[i - 1], points[i], stroke);
    return;
  }
  points_.clear();
  for (const Pixel& point : points) points_.push_back(sdl_point(point));
  const SDL_Color colour = sdl_colour(stroke.colour, stroke.opacity);
  SDL_SetRenderDrawColor(renderer_, colour.r, colour.g, colour.b, colour.a);
  SDL_RenderDrawLinesF(renderer_, points_.data(), static_cast<int>(points_.size()));
}

void SdlCanvas::circle(Pixel centre, double radius, const Stroke& stroke,
                       const std::string& /*note*/) {
  const int around = 2 * points_around(radius);
  const double half = stroke.width / 2;
  const double soft = std::min(kHalf, half);
  const std::array<Ring, 4> rings = {{{std::max(radius - half - kHalf, 0.0), 0},
                                      {std::max(radius - half + soft, 0.0), stroke.opacity},
                                      {radius + half - soft, stroke.opacity},
                                      {radius + half + kHalf, 0}}};
  fill(around, rings, stroke.colour, [&](int i, double reach) {
    const double angle = 2 * kPi * i / around;
    return Pixel{centre.x + reach * std::cos(angle), centre.y + reach * std::sin(angle)};
  });
}

void SdlCanvas::star(Pixel centre, double radius, const Colour& fill_colour) {
  const std::array<Ring, 3> rings = {{{0, 1}, {radius - kHalf, 1}, {radius + kHalf, 0}}};
  fill(kStarCorners, rings, fill_colour,
       [&](int i, double reach) { return star_corner(centre, reach, i); });
}

/// Across the stroke: nothing, colour, colour, nothing. Its ends are straight, half a width beyond.
void SdlCanvas::add_stroke(const PenStroke& stroke, double width) {
  const double length = std::hypot(stroke.to.x - stroke.from.x, stroke.to.y - stroke.from.y);
  const Pixel along = length > 0 ? Pixel{(stroke.to.x - stroke.from.x) / length,
                                         (stroke.to.y - stroke.from.y) / length}
                                 : Pixel{1, 0};
  const double half = width / 2;
  const int first = static_cast<int>(vertices_.size());
  for (const Ring row : {Ring{-half - kHalf, 0}, Ring{kHalf - half, 1}, Ring{half - kHalf, 1},
                         Ring{half + kHalf, 0}}) {
    const Pixel across = {-row.reach * along.y, row.reach * along.x};
    const Pixel from = {stroke.from.x - half * along.x, stroke.from.y - half * along.y};
    const Pixel to = {stroke.to.x + half * along.x, stroke.to.y + half * along.y};
    for (const Pixel end : {from, to}) {
      vertices_.push_back(
          {sdl_point({end.x + across.x, end.y + across.y}), sdl_colour(kInk, row.opacity), {0, 0}});
    }
  }
  for (int row = first; row < first + 6; row += 2) {
    for (const int corner : {0, 1, 2, 1, 2, 3}) indices_.push_back(row + corner);
  }
}

/// All strokes at once.
void SdlCanvas::text(Pixel at, std::string_view words, double size, Anchor anchor) {
  const double width = text_width(words, size);
  if (anchor == Anchor::kMiddle) at.x -= width / 2;
  if (anchor == Anchor::kEnd) at.x -= width;
  write_strokes(words, at, size, strokes_);
  vertices_.clear();
  indices_.clear();
  const double pen = std::max(kThinnestPen, kPenOfSize * size);
  for (const PenStroke& stroke : strokes_) add_stroke(stroke, pen);
  draw_vertices();
}

void SdlCanvas::draw_vertices() {
  if (indices_.empty()) return;
  (void)SDL_RenderGeometry(renderer_, nullptr, vertices_.data(), static_cast<int>(vertices_.size()),
                           indices_.data(), static_cast<int>(indices_.size()));
}

}  // namespace batuta::host
