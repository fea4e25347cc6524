// SPDX-License-Identifier: MIT

#include "programs/duel/svg_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "programs/duel/svg_canvas.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr double kWidth = 1060;
constexpr double kHeight = 1130;
constexpr double kMargin = 30;

std::string seconds(double time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", time);
  return text.data();
}

/// 1, 2 or 5 times a power of ten: at most a dozen marks over `span`.
double mark_spacing(double span) {
  double spacing = 0.1;
  for (int i = 0; span / spacing > 12 && i < 20; ++i) spacing *= i % 3 == 1 ? 2.5 : 2;
  return spacing;
}

/// Far enough to either side of the middle of the strip that all that happened can be seen, m.
double reach_of(const BoutStory& story) {
  constexpr double kBehind = 1.85;  // a fencer's rear foot behind his tip
  double reach = SalleView::kReach;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const Trace& tips = story.tips(side);
    for (std::size_t i = 0; i < tips.size(); ++i) {
      const auto back =
          static_cast<double>(side == Side::kLeft ? -tips[i].p_W.x() : tips[i].p_W.x());
      reach = std::max(reach, back + kBehind);
    }
  }
  return reach;
}

std::string title_of(const DuelRunner& runner) {
  const std::string result = result_of(runner);
  const auto [left, right] = score_of(runner.duel().bout());
  const std::string score = std::to_string(left) + " : " + std::to_string(right);
  if (result == "draw" && left == 0) return "No touch in " + seconds(runner.now());
  if (result == "draw") return "Draw, " + score + ", after " + seconds(runner.now());
  if (result == "open") return "Broken off after " + seconds(runner.now());
  if (runner.rules().touches > 1) {
    return "Won by " + result + ", " + score + ", after " + seconds(runner.now());
  }
  const Touch<float>& touch = runner.duel().bout().touches[0];
  const std::string where = fencing::name_of(touch.part);
  if (result == "double") return "Double touch after " + seconds(time_of(runner, touch));
  return "Touch by " + result + ": " + where + ", after " + seconds(time_of(runner, touch));
}

}  // namespace

void SvgPicture::on_start(const DuelRunner& runner) {
  on_step(runner);
}

void SvgPicture::on_step(const DuelRunner& runner) {
  story_.add_step(runner.duel());
  touches_.for_each_new(runner.duel(), [&](const Touch<float>& touch) {
    story_.add_touch(mark_of(runner.duel(), touch));
  });
}

void SvgPicture::on_end(const DuelRunner& runner) {
  SvgCanvas canvas(out_, kWidth, kHeight);
  draw_title(canvas, runner);
  const double reach = reach_of(story_);
  const SalleView side{false, {kMargin, 96}, 0, reach};
  const SalleView above{true, {kMargin, side.corner.y + side.size().y + 34}, 0, reach};
  const Postures postures = postures_of(runner.duel());
  draw_salle(canvas, side, postures, story_);
  draw_salle(canvas, above, postures, story_);
  draw_timeline(canvas, runner);
  draw_legend(canvas);
}

void SvgPicture::draw_title(Canvas& canvas, const DuelRunner& runner) const {
  canvas.text({kMargin, 36}, title_of(runner), 24, Anchor::kStart);
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double x = side == Side::kLeft ? kMargin : kWidth - kMargin;
    canvas.text({x, 62}, std::string(name_of(side)) + ": " + runner.source(side).description(), 13,
                side == Side::kLeft ? Anchor::kStart : Anchor::kEnd);
  }
}

void SvgPicture::draw_timeline(Canvas& canvas, const DuelRunner& runner) const {
  constexpr double kTop = 1010;
  constexpr double kBase = kTop + 50;
  const double span = std::max(runner.now(), 1e-3);
  const auto x_at = [&](double time) { return kMargin + SalleView::kWidth * time / span; };
  constexpr int kShades = 100;
  for (int i = 0; i < kShades; ++i) {
    const double x = x_at(span * i / kShades);
    const double width = x_at(span / kShades) - x_at(0) + 0.5;
    const double share = static_cast<double>(i) / (kShades - 1);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double y = kBase + (side == Side::kLeft ? 2 : 9);
      canvas.rectangle({x, y}, {width, 6}, mixed(palette(side).early, palette(side).late, share));
    }
  }
  for (const Beat& beat : story_.beats()) {
    const double height = std::min(10 + 60 * static_cast<double>(beat.impulse), 50.0);
    canvas.line({x_at(beat.time), kBase}, {x_at(beat.time), kBase - height}, {kBeat, 2, 0.8});
  }
  for (const TouchMark& touch : story_.touches()) {
    canvas.star({x_at(touch.time), kTop + 30}, 11, kTouch);
    canvas.text({x_at(touch.time), kTop + 14}, std::to_string(touch.exchange), 12, Anchor::kMiddle);
  }
  const double spacing = mark_spacing(span);
  for (int i = 0; i * spacing <= span; ++i) {
    std::array<char, 32> mark{};
    std::snprintf(mark.data(), mark.size(), "%g s", i * spacing);
    canvas.text({x_at(i * spacing), kBase + 30}, mark.data(), 12, Anchor::kMiddle);
  }
}

void SvgPicture::draw_legend(Canvas& canvas) const {
  constexpr double kLine = kHeight - 14;
  double x = kMargin;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    canvas.line({x, kLine - 5}, {x + 16, kLine - 5}, {palette(side).early, 4, 1});
    canvas.line({x + 22, kLine - 5}, {x + 38, kLine - 5}, {palette(side).late, 4, 1});
    canvas.text({x + 48, kLine}, std::string(name_of(side)) + " tip, early ... late", 13,
                Anchor::kStart);
    x += 230;
  }
  canvas.circle({x + 8, kLine - 5}, 7, {kBeat, 1.6, 1}, {});
  std::string beats = "beat, larger: harder";
  if (story_.beats_left_out() > 0)
    beats += " (the " + std::to_string(BoutStory::kMaxBeats) + " hardest)";
  canvas.text({x + 24, kLine}, beats, 13, Anchor::kStart);
  x += 290;
  canvas.star({x, kLine - 5}, 9, kTouch);
  canvas.text({x + 16, kLine}, "touch, numbered by exchange", 13, Anchor::kStart);
}

}  // namespace batuta::host
