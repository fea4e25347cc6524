// SPDX-License-Identifier: MIT

#include "programs/duel/beat_figure.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "programs/duel/bout_words.hpp"
#include "programs/duel/svg_canvas.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr double kFigureWidth = 1280;
constexpr double kFigureHeight = 760;

BladeEnds ends_of(const DuelRunner::DuelType& duel) {
  BladeEnds ends;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Segment<float> axis = duel.blade_W(side).axis;
    ends.guard[index_of(side)] = axis.a;
    ends.tip[index_of(side)] = axis.b;
  }
  return ends;
}

/// a + b * share, end by end.
BladeEnds sum(const BladeEnds& a, const BladeEnds& b, float share) {
  BladeEnds ends;
  for (std::size_t side = 0; side < 2; ++side) {  // Bound: 2
    ends.guard[side] = a.guard[side] + b.guard[side] * share;
    ends.tip[side] = a.tip[side] + b.tip[side] * share;
  }
  return ends;
}

BladeEnds velocities(const BladeEnds& from, const BladeEnds& to, float dt) {
  return sum(sum({}, to, 1 / dt), from, -1 / dt);
}

/// Pixels for 1 m/s: the longest arrow is as long as the figure allows.
double arrow_scale(const SeenBeat& seen) {
  double fastest = 0;
  for (const BladeEnds* ends : {&seen.v_before, &seen.v_after}) {
    for (std::size_t side = 0; side < 2; ++side) {  // Bound: 2
      fastest = std::max({fastest, static_cast<double>(ends->guard[side].norm()),
                          static_cast<double>(ends->tip[side].norm())});
    }
  }
  return std::min(BeatFigure::kArrowScale, BeatFigure::kLongest / std::max(fastest, 1e-3));
}

/// One of the six panels.
struct Panel {
  Vec3<float> middle_W;
  Pixel corner;
  bool from_above;

  /// Of a vector of the salle, pixels for one of its units.
  Pixel turned(const Vec3<float>& v_W, double scale) const {
    return {scale * static_cast<double>(v_W.x()),
            -scale * static_cast<double>(from_above ? v_W.y() : v_W.z())};
  }
  Pixel at(const Vec3<float>& p_W) const {
    const Pixel off = turned(p_W - middle_W, BeatFigure::kScale);
    return {corner.x + BeatFigure::kPanel.x / 2 + off.x,
            corner.y + BeatFigure::kPanel.y / 2 + off.y};
  }
};

void draw_blades(Canvas& canvas, const Panel& panel, const BladeEnds& ends, bool pale) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = index_of(side);
    const Colour colour = pale ? mixed(palette(side).body, kPaper, 0.7) : palette(side).body;
    canvas.line(panel.at(ends.guard[i]), panel.at(ends.tip[i]), {colour, 5, 1});
    canvas.circle(panel.at(ends.guard[i]), 6, {colour, 3, 1}, {});
  }
}

void draw_arrow(Canvas& canvas, Pixel from, Pixel along, const Colour& colour) {
  const double length = std::hypot(along.x, along.y);
  const Pixel to = {from.x + along.x, from.y + along.y};
  canvas.line(from, to, {colour, 1.6, 1});
  if (length <= 0) return;
  const double head = std::min(7.0, length) / length;
  const auto barb = [&](double side) {
    return Pixel{to.x - head * (along.x + side * 0.4 * along.y),
                 to.y - head * (along.y - side * 0.4 * along.x)};
  };
  canvas.polyline({barb(1), to, barb(-1)}, {colour, 1.6, 1});
}

void draw_velocities(Canvas& canvas, const Panel& panel, const BladeEnds& ends,
                     const BladeEnds& velocity, double scale) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = index_of(side);
    for (int arrow = 0; arrow < BeatFigure::kArrows; ++arrow) {
      const float place = static_cast<float>(arrow) / (BeatFigure::kArrows - 1);
      const Vec3<float> p_W = ends.guard[i] + (ends.tip[i] - ends.guard[i]) * place;
      const Vec3<float> v_W = velocity.guard[i] + (velocity.tip[i] - velocity.guard[i]) * place;
      draw_arrow(canvas, panel.at(p_W), panel.turned(v_W, scale), palette(side).late);
    }
  }
}

/// One direction of sight: before, at contact, after.
void draw_row(Canvas& canvas, const SeenBeat& seen, bool from_above) {
  const Vec3<float> middle_W = (seen.contact.guard[0] + seen.contact.guard[1]) * 0.5F;
  const auto panel = [&](int column) {
    return Panel{middle_W,
                 {BeatFigure::kFirstPanel.x + column * BeatFigure::kPanelStep.x,
                  BeatFigure::kFirstPanel.y + (from_above ? BeatFigure::kPanelStep.y : 0)},
                 from_above};
  };
  for (int column = 0; column < 3; ++column) {
    canvas.rectangle(panel(column).corner, BeatFigure::kPanel, {250, 250, 248});
  }
  const Pixel corner = panel(0).corner;
  canvas.text({corner.x, corner.y - 6}, from_above ? "from above" : "from the side", 13,
              Anchor::kStart);
  draw_blades(canvas, panel(0), seen.earlier, true);
  draw_blades(canvas, panel(0), seen.before, false);
  draw_velocities(canvas, panel(0), seen.before, seen.v_before, arrow_scale(seen));
  draw_blades(canvas, panel(1), seen.contact, false);
  canvas.circle(panel(1).at(seen.beat.point_W), ring_radius(seen.beat.impulse), {kBeat, 1.6, 1},
                {});
  draw_blades(canvas, panel(2), seen.later, true);
  draw_blades(canvas, panel(2), seen.after, false);
  draw_velocities(canvas, panel(2), seen.after, seen.v_after, arrow_scale(seen));
}

void draw_words(Canvas& canvas, const SeenBeat& seen) {
  std::array<char, 128> words{};
  std::snprintf(words.data(), words.size(),
                "The hardest beat: at %.3f s, %.3f N s, blades closing at %.2f m/s", seen.beat.time,
                static_cast<double>(seen.beat.impulse), -static_cast<double>(seen.v_rel));
  canvas.text({BeatFigure::kFirstPanel.x, 36}, words.data(), 22, Anchor::kStart);
  const std::array<const char*, 3> titles = {"a) before", "b) at contact", "c) after"};
  for (int column = 0; column < 3; ++column) {
    const double left = BeatFigure::kFirstPanel.x + column * BeatFigure::kPanelStep.x;
    canvas.text({left + BeatFigure::kPanel.x / 2, 72}, titles[static_cast<std::size_t>(column)], 16,
                Anchor::kMiddle);
  }
  constexpr double kBase = kFigureHeight - 34;
  const double x = BeatFigure::kFirstPanel.x;
  const double scale = arrow_scale(seen);
  constexpr double kShort = 10;               // pixels
  const int speed = scale < kShort ? 10 : 1;  // m/s
  draw_arrow(canvas, {x, kBase}, {speed * scale, 0}, kGrey);
  canvas.text({x + speed * scale + 10, kBase + 5}, std::to_string(speed) + " m/s", 13,
              Anchor::kStart);
  canvas.line({x + 150, kBase}, {x + 150 + BeatFigure::kScale / 10, kBase}, {kGrey, 3, 1});
  canvas.text({x + 150 + BeatFigure::kScale / 10 + 10, kBase + 5}, "0.1 m", 13, Anchor::kStart);
  canvas.text({x + 300, kBase + 5},
              "blue: left, orange: right; rings: guards; pale: " +
                  std::to_string(BeatFigure::kLead) + " ms earlier, and later",
              13, Anchor::kStart);
}

}  // namespace

void BeatFigure::on_start(const DuelRunner& runner) {
  dt_ = runner.duel().dt();
  ends_[0] = ends_of(runner.duel());
}

void BeatFigure::on_step(const DuelRunner& runner) {
  const std::uint32_t step = runner.duel().steps();
  ends_[step % ends_.size()] = ends_of(runner.duel());
  follow(step);
  for (const auto& event : runner.duel().events()) {  // Bound: DuelScene::kMaxEvents
    const bool harder = !hardest_.found || event.impulse > hardest_.beat.impulse;
    if (is_beat(event) && harder && step >= 2) see(runner, event);
  }
}

void BeatFigure::see(const DuelRunner& runner, const ContactEvent<float>& event) {
  const std::uint32_t step = runner.duel().steps();
  if (hardest_.age > 0) harder_before_ = hardest_;
  hardest_ = SeenBeat();
  hardest_.found = true;
  hardest_.beat = beat_of(runner.duel(), event);
  hardest_.normal_W = event.contact.normal_BA_W;
  hardest_.v_rel = event.v_rel;
  hardest_.earlier = ends_at(step - std::min<std::uint32_t>(step, kLead));
  hardest_.before = ends_at(step - 1);
  hardest_.v_before = velocities(ends_at(step - 2), ends_at(step - 1), dt_);
  hardest_.contact = sum(hardest_.before, hardest_.v_before, event.time);
  hardest_.after = ends_at(step);
  hardest_.later = ends_at(step);
}

/// What comes after a beat.
void BeatFigure::follow(std::uint32_t step) {
  if (!hardest_.found || hardest_.age == kLead) return;
  ++hardest_.age;
  if (hardest_.age == 1) hardest_.v_after = velocities(ends_at(step - 1), ends_at(step), dt_);
  hardest_.later = ends_at(step);
}

void BeatFigure::on_end(const DuelRunner& /*runner*/) {
  SvgCanvas canvas(out_, kFigureWidth, kFigureHeight);
  const SeenBeat& seen = hardest();
  if (!seen.found) {
    canvas.text({kFirstPanel.x, 36}, "No beat in this bout", 22, Anchor::kStart);
    return;
  }
  draw_words(canvas, seen);
  draw_row(canvas, seen, false);
  draw_row(canvas, seen, true);
}

}  // namespace batuta::host
