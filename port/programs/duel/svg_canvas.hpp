// SPDX-License-Identifier: MIT
#pragma once
// The few drawing commands that the picture of a bout needs, as SVG text. Units: pixels, y
// downwards.

#include <ostream>
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
Colour mixed(const Colour& from, const Colour& to, double share);

struct Stroke {
  Colour colour;
  double width = 1;
  double opacity = 1;
};

/// Writes a document; the destructor ends it.
class SvgCanvas {
 public:
  SvgCanvas(std::ostream& out, double width, double height);
  SvgCanvas(const SvgCanvas&) = delete;
  SvgCanvas& operator=(const SvgCanvas&) = delete;
  ~SvgCanvas();

  void rectangle(Pixel corner, Pixel size, const Colour& fill);
  /// A line with round ends: a capsule.
  void line(Pixel a, Pixel b, const Stroke& stroke);
  void polyline(const std::vector<Pixel>& points, const Stroke& stroke);
  /// @param note  shown when pointed at; may be empty
  void circle(Pixel centre, double radius, const Stroke& stroke, const std::string& note);
  void star(Pixel centre, double radius, const Colour& fill);
  /// @param anchor  "start", "middle" or "end"
  void text(Pixel at, std::string_view words, double size, const char* anchor);

 private:
  std::ostream& stroke_attributes(const Stroke& stroke);

  std::ostream& out_;
};

}  // namespace batuta::host
