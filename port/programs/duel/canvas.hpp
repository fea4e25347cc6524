// SPDX-License-Identifier: MIT
#pragma once
// The few drawing commands that the pictures of a bout need, whatever they are drawn on: a file or
// a window. Units: pixels, y downwards.

#include <cmath>
#include <string>
#include <string_view>
#include <vector>

namespace batuta::host {

struct Pixel {
  double x = 0;
  double y = 0;
};

struct Colour {
  int red = 0;
  int green = 0;
  int blue = 0;
};

/// share 0: from; 1: to.
inline Colour mixed(const Colour& from, const Colour& to, double share) {
  const auto mix = [share](int a, int b) {
    return static_cast<int>(std::lround(a + (b - a) * share));
  };
  return {mix(from.red, to.red), mix(from.green, to.green), mix(from.blue, to.blue)};
}

struct Stroke {
  Colour colour;
  double width = 1;
  double opacity = 1;
};

/// Which point of a text stands where it is put, on its base line.
enum class Anchor { kStart, kMiddle, kEnd };

/// Of every text.
inline constexpr Colour kInk = {40, 40, 40};
/// What every picture begins with.
inline constexpr Colour kPaper = {255, 255, 255};

/// A star has so many corners, every second one at kStarWaist of its radius; the first is above.
inline constexpr int kStarCorners = 16;
inline constexpr double kStarWaist = 0.45;
/// Corner i of a star. @param radius  of its outer corners
inline Pixel star_corner(Pixel centre, double radius, int i) {
  constexpr double kPi = 3.14159265358979;
  const double reach = i % 2 == 0 ? radius : kStarWaist * radius;
  const double angle = 2 * kPi * i / kStarCorners;
  return {centre.x + reach * std::sin(angle), centre.y - reach * std::cos(angle)};
}

class Canvas {
 public:
  Canvas() = default;
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  virtual ~Canvas() = default;

  virtual void rectangle(Pixel corner, Pixel size, const Colour& fill) = 0;
  /// A line with round ends: a capsule.
  virtual void line(Pixel a, Pixel b, const Stroke& stroke) = 0;
  virtual void polyline(const std::vector<Pixel>& points, const Stroke& stroke) = 0;
  /// @param note  shown when pointed at, where the canvas can; may be empty
  virtual void circle(Pixel centre, double radius, const Stroke& stroke,
                      const std::string& note) = 0;
  virtual void star(Pixel centre, double radius, const Colour& fill) = 0;
  virtual void text(Pixel at, std::string_view words, double size, Anchor anchor) = 0;
};

}  // namespace batuta::host
