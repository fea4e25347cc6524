// SPDX-License-Identifier: MIT

#include "programs/duel/svg_canvas.hpp"

#include <cmath>

#include "programs/duel/utf8.hpp"

namespace batuta::host {
namespace {

/// Text that XML accepts: no markup, no control characters, valid UTF-8.
std::string escaped(std::string_view words) {
  std::string text;
  while (!words.empty()) {  // Bound: the bytes of the text
    const std::size_t length = utf8_length(words);
    const char c = words.front();
    if (length == 0 || static_cast<unsigned char>(c) < 0x20) {
      text += '?';
    } else if (c == '&') {
      text += "&amp;";
    } else if (c == '<') {
      text += "&lt;";
    } else {
      text += words.substr(0, length);
    }
    words.remove_prefix(length == 0 ? 1 : length);
  }
  return text;
}

/// Tenths of a pixel are as fine as an eye sees; an exponent or a NaN would not be SVG.
struct Number {
  double value;
};

std::ostream& operator<<(std::ostream& out, Number number) {
  const double tenths = std::isfinite(number.value) ? std::round(number.value * 10) : 0;
  const long long whole = std::llround(std::fmin(std::fmax(tenths, -1e9), 1e9));
  const long long size = whole < 0 ? -whole : whole;
  out << (whole < 0 ? "-" : "") << size / 10;
  if (size % 10 != 0) out << '.' << size % 10;
  return out;
}

std::ostream& operator<<(std::ostream& out, const Colour& colour) {
  return out << "rgb(" << colour.red << ',' << colour.green << ',' << colour.blue << ')';
}

const char* word_of(Anchor anchor) {
  if (anchor == Anchor::kStart) return "start";
  return anchor == Anchor::kMiddle ? "middle" : "end";
}

}  // namespace

SvgCanvas::SvgCanvas(std::ostream& out, double width, double height) : out_(out) {
  out_ << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" "
          "width=\""
       << Number{width} << "\" height=\"" << Number{height} << "\" viewBox=\"0 0 " << Number{width}
       << ' ' << Number{height} << "\" font-family=\"sans-serif\" fill=\"none\" "
       << "stroke-linecap=\"round\" stroke-linejoin=\"round\">\n";
  rectangle({0, 0}, {width, height}, kPaper);
}

SvgCanvas::~SvgCanvas() {
  out_ << "</svg>\n";
}

void SvgCanvas::rectangle(Pixel corner, Pixel size, const Colour& fill) {
  out_ << "<rect x=\"" << Number{corner.x} << "\" y=\"" << Number{corner.y} << "\" width=\""
       << Number{size.x} << "\" height=\"" << Number{size.y} << "\" fill=\"" << fill << "\"/>\n";
}

std::ostream& SvgCanvas::stroke_attributes(const Stroke& stroke) {
  out_ << "stroke=\"" << stroke.colour << "\" stroke-width=\"" << Number{stroke.width} << '"';
  if (stroke.opacity < 1) out_ << " stroke-opacity=\"" << Number{stroke.opacity} << '"';
  return out_;
}

void SvgCanvas::line(Pixel a, Pixel b, const Stroke& stroke) {
  out_ << "<line x1=\"" << Number{a.x} << "\" y1=\"" << Number{a.y} << "\" x2=\"" << Number{b.x}
       << "\" y2=\"" << Number{b.y} << "\" ";
  stroke_attributes(stroke) << "/>\n";
}

void SvgCanvas::polyline(const std::vector<Pixel>& points, const Stroke& stroke) {
  out_ << "<polyline ";
  stroke_attributes(stroke) << " points=\"";
  for (const Pixel& point : points) out_ << Number{point.x} << ',' << Number{point.y} << ' ';
  out_ << "\"/>\n";
}

void SvgCanvas::circle(Pixel centre, double radius, const Stroke& stroke, const std::string& note) {
  out_ << "<circle cx=\"" << Number{centre.x} << "\" cy=\"" << Number{centre.y} << "\" r=\""
       << Number{radius} << "\" ";
  stroke_attributes(stroke);
  if (note.empty()) {
    out_ << "/>\n";
  } else {
    out_ << "><title>" << escaped(note) << "</title></circle>\n";
  }
}

void SvgCanvas::star(Pixel centre, double radius, const Colour& fill) {
  out_ << "<polygon fill=\"" << fill << "\" points=\"";
  for (int i = 0; i < kStarCorners; ++i) {
    const Pixel corner = star_corner(centre, radius, i);
    out_ << Number{corner.x} << ',' << Number{corner.y} << ' ';
  }
  out_ << "\"/>\n";
}

void SvgCanvas::text(Pixel at, std::string_view words, double size, Anchor anchor) {
  out_ << "<text x=\"" << Number{at.x} << "\" y=\"" << Number{at.y} << "\" font-size=\""
       << Number{size} << "\" text-anchor=\"" << word_of(anchor) << "\" fill=\"" << kInk << "\">"
       << escaped(words) << "</text>\n";
}

}  // namespace batuta::host
