// SPDX-License-Identifier: MIT
#pragma once
// A canvas that is SVG text.

#include <ostream>

#include "programs/duel/canvas.hpp"

namespace batuta::host {

/// Writes a document; the destructor ends it.
class SvgCanvas final : public Canvas {
 public:
  SvgCanvas(std::ostream& out, double width, double height);
  ~SvgCanvas() override;

  void rectangle(Pixel corner, Pixel size, const Colour& fill) override;
  void line(Pixel a, Pixel b, const Stroke& stroke) override;
  void polyline(const std::vector<Pixel>& points, const Stroke& stroke) override;
  void circle(Pixel centre, double radius, const Stroke& stroke, const std::string& note) override;
  void star(Pixel centre, double radius, const Colour& fill) override;
  void text(Pixel at, std::string_view words, double size, Anchor anchor) override;

 private:
  std::ostream& stroke_attributes(const Stroke& stroke);

  std::ostream& out_;
};

}  // namespace batuta::host
