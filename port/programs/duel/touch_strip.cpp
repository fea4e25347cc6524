// SPDX-License-Identifier: MIT

#include "programs/duel/touch_strip.hpp"

#include <algorithm>
#include <cstdio>

#include "programs/duel/svg_canvas.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr double kStripWidth = 1280;
constexpr double kStripHeight = 560;

std::string before_touch(double seconds) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), "%.2f s before", seconds);
  return text.data();
}

}  // namespace

SalleView TouchStrip::view_of(int i, double middle) {
  const int row = i / kColumns;
  SalleView view;
  view.corner = {kFirst.x + kToNext.x * (i % kColumns), kFirst.y + kToNext.y * row};
  view.middle = middle;
  view.reach = kReach;
  view.width = kWidth;
  return view;
}

void TouchStrip::on_start(const DuelRunner& runner) {
  latest_.fill(postures_of(runner.duel()));
}

void TouchStrip::on_step(const DuelRunner& runner) {
  const std::uint32_t step = runner.duel().steps();
  latest_[step % kKept] = postures_of(runner.duel());
  touches_.for_each_new(runner.duel(), [&](const Touch<float>& touch) {
    touch_ = mark_of(runner.duel(), touch);
    for (int i = 0; i < kPictures; ++i) {  // Bound: kPictures
      // As old as there is: before the first step everybody stands as at the start.
      const auto back = static_cast<std::uint32_t>((kPictures - 1 - i) * kSpacing);
      pictures_[static_cast<std::size_t>(i)] =
          latest_[(step + kKept - std::min(step, back)) % kKept];
    }
  });
}

void TouchStrip::on_end(const DuelRunner& /*runner*/) {
  SvgCanvas canvas(out_, kStripWidth, kStripHeight);
  if (!touch_) {
    canvas.text({kFirst.x, 36}, "No touch in this bout", 22, Anchor::kStart);
    return;
  }
  std::array<char, 96> words{};
  std::snprintf(words.data(), words.size(), "Touch by %s: %s, after %.2f s", name_of(touch_->by),
                fencing::name_of(touch_->part), touch_->time);
  canvas.text({kFirst.x, 36}, words.data(), 22, Anchor::kStart);
  for (int i = 0; i < kPictures; ++i) {  // Bound: kPictures
    const Postures& postures = pictures_[static_cast<std::size_t>(i)];
    const SalleView view = view_of(i, postures.middle);
    const bool last = i == kPictures - 1;
    draw_strip(canvas, view);
    draw_fencers(canvas, view, postures);
    if (last) canvas.star(view.at(touch_->point_W), 12, kTouch);
    canvas.text({view.corner.x + 8, view.corner.y - 6},
                last ? "touch" : before_touch(touch_->time - postures.time), 13, Anchor::kStart);
  }
}

}  // namespace batuta::host
