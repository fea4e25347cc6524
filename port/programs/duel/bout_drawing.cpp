// SPDX-License-Identifier: MIT

#include "programs/duel/bout_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr std::array<Palette, 2> kPalettes = {{
    {{176, 208, 240}, {10, 50, 120}, {70, 120, 180}},
    {{250, 210, 160}, {140, 40, 0}, {205, 120, 50}},
}};
constexpr Colour kFaint = {225, 225, 225};

void draw_fencer(Canvas& canvas, const SalleView& view, const Postures& postures, Side side) {
  const auto draw = [&](const Capsule<float>& capsule, const Colour& colour, double least) {
    const double width = std::max(2 * static_cast<double>(capsule.radius) * view.scale(), least);
    canvas.line(view.at(capsule.axis.a), view.at(capsule.axis.b), {colour, width, 1});
  };
  const Colour pale = mixed(palette(side).body, kPaper, 0.72);
  for (const Capsule<float>& part : postures.body_W[index_of(side)]) draw(part, pale, 0);
  draw(postures.blade_W[index_of(side)], palette(side).body, 4);
}

/// The trace in pieces of one colour each, so that a file stays small.
void draw_trace(Canvas& canvas, const SalleView& view, const Trace& trace, Side side, double end) {
  constexpr int kShades = 24;
  const auto shade_at = [&](std::size_t i) {
    const double share = end > 0 ? static_cast<double>(trace[i].time) / end : 0;
    return std::clamp(static_cast<int>(share * kShades), 0, kShades - 1);
  };
  std::vector<Pixel> piece;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    piece.push_back(view.at(trace[i].p_W));
    const bool last = i + 1 == trace.size();
    if (!last && shade_at(i + 1) == shade_at(i)) continue;
    const double share = static_cast<double>(shade_at(i)) / (kShades - 1);
    if (!last) piece.push_back(view.at(trace[i + 1].p_W));
    canvas.polyline(piece, {mixed(palette(side).early, palette(side).late, share), 1.2, 0.9});
    piece.clear();
  }
}

void draw_beats(Canvas& canvas, const SalleView& view, const BoutStory& story) {
  for (const Beat& beat : story.beats()) {
    std::array<char, 64> note{};
    std::snprintf(note.data(), note.size(), "beat at %.3f s, %.3f N s", beat.time,
                  static_cast<double>(beat.impulse));
    canvas.circle(view.at(beat.point_W), ring_radius(beat.impulse), {kBeat, 1.6, 0.8}, note.data());
  }
}

constexpr double kLabel = 14;  // height of a label's letters, pixels
constexpr double kStar = 15;   // radius, pixels

/// What is drawn at a place already: a word, or a star.
struct Taken {
  Pixel middle;
  double width = 0;
  double height = 0;

  bool covers(const Taken& other) const {
    return 2 * std::abs(middle.x - other.middle.x) < width + other.width &&
           2 * std::abs(middle.y - other.middle.y) < height + other.height;
  }
};

/// Up from a star, a line at a time, to where nothing is drawn yet. Bound: what is taken.
Pixel place_for(const std::string& words, Pixel star, std::vector<Taken>& taken) {
  constexpr double kBreadth = 0.58;  // of a letter on the average, of its height
  Taken label = {{star.x, star.y - kStar - kLabel / 2},
                 kBreadth * kLabel * static_cast<double>(words.size()),
                 kLabel};
  const auto is_covered = [&] {
    return std::any_of(taken.begin(), taken.end(),
                       [&](const Taken& other) { return other.covers(label); });
  };
  while (is_covered()) label.middle.y -= kLabel;
  taken.push_back(label);
  return label.middle;
}

/// A star each, and what was touched in which exchange.
void draw_touches(Canvas& canvas, const SalleView& view, const BoutStory& story) {
  constexpr double kBase = 4;  // of a line of letters, below its middle
  std::vector<Taken> taken;
  for (const TouchMark& touch : story.touches()) {
    const Pixel star = view.at(touch.point_W);
    taken.push_back({star, 2 * kStar, 2 * kStar});
  }
  for (const TouchMark& touch : story.touches()) {
    const Pixel star = view.at(touch.point_W);
    const std::string words = std::to_string(touch.exchange) + " " + fencing::name_of(touch.part);
    const Pixel middle = place_for(words, star, taken);
    if (middle.y < star.y - kStar - kLabel) {
      canvas.line(star, {star.x, middle.y + kLabel / 2}, {kGrey, 0.7, 1});
    }
    canvas.text({middle.x, middle.y + kBase}, words, kLabel, Anchor::kMiddle);
  }
  for (const TouchMark& touch : story.touches()) canvas.star(view.at(touch.point_W), kStar, kTouch);
}

}  // namespace

const Palette& palette(Side side) {
  return kPalettes[index_of(side)];
}

Postures postures_of(const DuelRunner::DuelType& duel) {
  Postures postures;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    postures.body_W[index_of(side)] = duel.body_W(side);
    postures.blade_W[index_of(side)] = duel.blade_W(side);
  }
  postures.time = time_of(duel);
  const Vec3<float> both = duel.X_WF(Side::kLeft).p_W + duel.X_WF(Side::kRight).p_W;
  postures.middle = 0.5 * static_cast<double>(both.x());
  return postures;
}

double ring_radius(float impulse) {
  return std::clamp(2.5 + 9 * std::sqrt(static_cast<double>(impulse)), 2.5, 14.0);
}

Pixel SalleView::at(const Vec3<float>& p_W) const {
  // From above, the left fencer's left hand (+y) is up, as it is on a map with the piste drawn from
  // left to right.
  const double up = from_above ? size().y / 2 + static_cast<double>(p_W.y()) * scale()
                               : static_cast<double>(p_W.z()) * scale();
  return {corner.x + (reach + static_cast<double>(p_W.x()) - middle) * scale(),
          corner.y + size().y - up};
}

double reach_of(const Postures& postures) {
  constexpr double kEdge = 0.05;  // m
  double reach = SalleView::kReach;
  const auto hold = [&](const Capsule<float>& part) {
    for (const Vec3<float>& end : {part.axis.a, part.axis.b}) {
      const double away = std::abs(static_cast<double>(end.x()) - postures.middle);
      reach = std::max(reach, away + static_cast<double>(part.radius) + kEdge);
    }
  };
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const auto& part : postures.body_W[index_of(side)]) hold(part);
    hold(postures.blade_W[index_of(side)]);
  }
  return reach;
}

void draw_fencers(Canvas& canvas, const SalleView& view, const Postures& postures) {
  for (const Side side : {Side::kLeft, Side::kRight}) draw_fencer(canvas, view, postures, side);
}

void draw_strip(Canvas& canvas, const SalleView& view) {
  const Pixel low = {view.corner.x, view.corner.y + view.size().y};
  canvas.rectangle(view.corner, view.size(), {250, 250, 248});
  constexpr int kEndLine = 7;  // m from the middle
  for (int metre = -kEndLine; metre <= kEndLine; ++metre) {
    if (std::abs(metre - view.middle) >= view.reach) continue;
    const double x = view.at({static_cast<float>(metre), 0, 0}).x;
    canvas.line({x, view.corner.y}, {x, low.y},
                {std::abs(metre) == kEndLine ? kGrey : kFaint, 1, 1});
  }
  if (!view.from_above) canvas.line(low, {low.x + view.size().x, low.y}, {kGrey, 2, 1});
}

void draw_salle(Canvas& canvas, const SalleView& view, const Postures& postures,
                const BoutStory& story) {
  draw_strip(canvas, view);
  canvas.text({view.corner.x + 8, view.corner.y - 6},
              view.from_above ? "from above" : "from the side (lines: 1 m)", 13, Anchor::kStart);
  draw_fencers(canvas, view, postures);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    draw_trace(canvas, view, story.tips(side), side, postures.time);
  }
  draw_beats(canvas, view, story);
  draw_touches(canvas, view, story);
}

}  // namespace batuta::host
