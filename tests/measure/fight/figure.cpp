// SPDX-License-Identifier: MIT
#include "figure.hpp"

#include <cmath>

#include "programs/duel/svg_canvas.hpp"

namespace fight {
namespace {

using namespace batuta;
using namespace batuta::fencing;
using namespace batuta::host;

constexpr double kCell = 150;          // px
constexpr double kMargin = 60;         // px, around the grid
constexpr double kHead = 70;           // px, above it
constexpr double kScale = 115;         // px/m
constexpr double kMiddleHeight = 1.1;  // m: what a cell shows in its middle
constexpr double kWords = 13;          // px
constexpr double kTitle = 18;          // px
constexpr Colour kFaint = {226, 226, 232};
constexpr Colour kFrame = {205, 205, 210};
constexpr Colour kArrow = {150, 170, 205};
constexpr Colour kSteel = {60, 70, 90};
constexpr Colour kBell = {120, 130, 150};
constexpr Colour kSkin = {190, 120, 80};
constexpr Colour kPoint = {200, 40, 40};

struct Label {
  int column;
  int row;
  const char* words;
};
constexpr std::array<Label, 11> kLabels = {{{4, 3, "beat"},
                                            {0, 0, "septime"},
                                            {4, 0, "retreat"},
                                            {8, 0, "octave"},
                                            {0, 2, "quarte"},
                                            {4, 2, "guard"},
                                            {8, 2, "sixte"},
                                            {0, 4, "lunge, high inside"},
                                            {2, 4, "lunge, low inside"},
                                            {6, 4, "lunge, low outside"},
                                            {8, 4, "lunge, high outside"}}};
constexpr Label kGuard = kLabels[5];

class MapFigure {
 public:
  MapFigure(const Fencer<float>& fencer, SvgCanvas& canvas)
      : fencer_(fencer), weapon_(epee<float>()), canvas_(canvas) {}

  void draw() {
    const FencerMap<float>& map = fencer_.map;
    draw_words();
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) draw_frame({column, row, ""});
    }
    for (const Label& label : kLabels) draw_arrow(label);
    for (int row = 0; row < map.rows; ++row) {
      for (int column = 0; column < map.columns; ++column) draw_key({column, row, ""});
    }
    for (const Label& label : kLabels) {
      const Pixel corner = corner_of(label);
      canvas_.text({corner.x + kCell / 2, corner.y + kWords + 4}, label.words, kWords,
                   Anchor::kMiddle);
    }
  }

 private:
  /// The row behind is the lowest one.
  Pixel corner_of(const Label& cell) const {
    return {kMargin + cell.column * kCell, kHead + (fencer_.map.rows - 1 - cell.row) * kCell};
  }
  Pixel middle_of(const Label& cell) const {
    const Pixel corner = corner_of(cell);
    return {corner.x + kCell / 2, corner.y + kCell / 2};
  }
  /// The fencer's right is to the right.
  Pixel seen(const Label& cell, const Vec3<float>& p_F) const {
    const Pixel middle = middle_of(cell);
    return {middle.x - kScale * static_cast<double>(p_F.y()),
            middle.y - kScale * (static_cast<double>(p_F.z()) - kMiddleHeight)};
  }

  void draw_words() {
    const double width = kMargin * 2 + fencer_.map.columns * kCell;
    const double bottom = kHead + fencer_.map.rows * kCell;
    canvas_.text({kMargin, kHead / 2},
                 "What the stick means: hand, guard and blade of each key, "
                 "as the fencer sees them before the opponent on guard",
                 kTitle, Anchor::kStart);
    const double below = bottom + kMargin / 2;
    canvas_.text({kMargin, below}, "stick to the left: inside", kWords, Anchor::kStart);
    canvas_.text({width - kMargin, below}, "stick to the right: outside", kWords, Anchor::kEnd);
    canvas_.text({kMargin / 2, kHead + kCell / 2}, "forward", kWords, Anchor::kMiddle);
    canvas_.text({kMargin / 2, bottom - kCell / 2}, "back", kWords, Anchor::kMiddle);
  }

  void draw_frame(const Label& cell) {
    const Pixel corner = corner_of(cell);
    const Stroke rim{kFrame, 1, 1};
    canvas_.polyline({corner,
                      {corner.x + kCell, corner.y},
                      {corner.x + kCell, corner.y + kCell},
                      {corner.x, corner.y + kCell},
                      corner},
                     rim);
  }

  /// From the guard's cell into the one that is named.
  void draw_arrow(const Label& label) {
    const Pixel from = middle_of(kGuard);
    const Pixel to = middle_of(label);
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    if (length == 0) return;
    constexpr double kRoom = 0.45 * kCell;
    constexpr double kBarb = 9;
    const Pixel along = {(to.x - from.x) / length, (to.y - from.y) / length};
    const Pixel tip = {to.x - kRoom * along.x, to.y - kRoom * along.y};
    const Stroke shaft{kArrow, 2.5, 0.7};
    canvas_.line({from.x + kRoom * along.x, from.y + kRoom * along.y}, tip, shaft);
    for (const double side : {-1.0, 1.0}) {
      canvas_.line(tip,
                   {tip.x - kBarb * (along.x - side * 0.5 * along.y),
                    tip.y - kBarb * (along.y + side * 0.5 * along.x)},
                   shaft);
    }
  }

  void draw_opponent(const Label& cell) {
    const Pose<float> X_WF{{static_cast<float>(kGuardDistance), 0, 0}, {0, 0, 0, 1}};
    const Pose<float> guard = hand_at(fencer_.map, Vec2<float>(0, 0)).X_WH;
    const BodyShape<float> body = pose_body(fencer_.build, X_WF, chained(X_WF, guard));
    const int parts = static_cast<int>(BodyPart::kFrontThigh);  // the legs are below the picture
    for (int i = 0; i < parts; ++i) {
      const Capsule<float>& part = body[static_cast<std::size_t>(i)];
      const double width = 2 * kScale * static_cast<double>(part.radius);
      canvas_.line(seen(cell, part.axis.a), seen(cell, part.axis.b), {kFaint, width, 1});
    }
  }

  void draw_key(const Label& cell) {
    draw_opponent(cell);
    const Vec2<float> stick(
        -1 + 2.0F * static_cast<float>(cell.column) / static_cast<float>(fencer_.map.columns - 1),
        -1 + 2.0F * static_cast<float>(cell.row) / static_cast<float>(fencer_.map.rows - 1));
    const Pose<float> X_FH = hand_at(fencer_.map, stick).X_WH;
    draw_part(cell, to_world(X_FH, weapon_.hand_H), kSkin);
    draw_part(cell, to_world(X_FH, weapon_.parts[1].capsule_H), kBell);
    const Capsule<float> blade = to_world(X_FH, weapon_.parts[0].capsule_H);
    constexpr double kThick = 3;
    constexpr double kDot = 2;
    canvas_.line(seen(cell, blade.axis.a), seen(cell, blade.axis.b), {kSteel, kThick, 1});
    canvas_.circle(seen(cell, blade.axis.b), kDot, {kPoint, 2 * kDot, 1}, "the point");
    const float feet = feet_at(fencer_.map, stick);
    if (feet == 0) return;
    const Pixel middle = middle_of(cell);
    canvas_.text({middle.x, middle.y + kCell / 2 - 6}, feet < 0 ? "feet go back" : "feet advance",
                 kWords, Anchor::kMiddle);
  }

  /// Its outline.
  void draw_part(const Label& cell, const Capsule<float>& part, const Colour& colour) {
    const double radius = kScale * static_cast<double>(part.radius);
    const Stroke rim{colour, 1.5, 1};
    canvas_.circle(seen(cell, part.axis.a), radius, rim, "");
    if (part.axis.direction().norm() > 0) canvas_.circle(seen(cell, part.axis.b), radius, rim, "");
  }

  const Fencer<float>& fencer_;
  const Weapon<float> weapon_;
  SvgCanvas& canvas_;
};

}  // namespace

void draw_map(const Fencer<float>& fencer, std::ostream& out) {
  SvgCanvas canvas(out, 2 * kMargin + fencer.map.columns * kCell,
                   kHead + kMargin + fencer.map.rows * kCell);
  MapFigure(fencer, canvas).draw();
}

}  // namespace fight
