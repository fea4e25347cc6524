// SPDX-License-Identifier: MIT

#include "programs/duel/view/view_screen.hpp"

#include <algorithm>
#include <cstdio>

#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr double kPadTop = 988;
constexpr double kPad = 80;  // a stick's square, pixels

std::string with_seconds(const char* format, double time) {
  std::array<char, 48> text{};
  std::snprintf(text.data(), text.size(), format, time);
  return text.data();
}

std::string headline(const ViewState& state) {
  if (state.bout == 0) return "waiting";
  if (state.corps_a_corps) return "corps a corps; halt";
  if (state.touches.empty()) return state.over ? "no touch" : "en garde";
  const int last = state.touches.size() - 1;
  const TouchMark& touch = state.touches[last];
  const bool both = last > 0 && state.touches[last - 1].exchange == touch.exchange;
  const std::string who =
      both ? "double touch" : std::string("touch by ") + batuta::host::name_of(touch.by);
  const std::string what = (state.annulled ? "annulled " : "") + who + ": ";
  return what + fencing::name_of(touch.part) +
         with_seconds(", after %.2f s", state.touches[both ? last - 1 : last].time) +
         (state.halt ? "; halt" : "");
}

std::string mode_of(const ViewControls& controls) {
  if (controls.device_keeps_time()) return "the device keeps its own time";
  std::string words;
  if (controls.slowness() != 1)
    words = "1/" + std::to_string(controls.slowness()) + " of the speed";
  if (controls.is_paused()) words += words.empty() ? "paused" : ", paused";
  return words;
}

/// As a share of the device's range, the larger of both axes.
double strength(const ViewState::Hand& hand) {
  return static_cast<double>(std::max(std::abs(hand.force.x()), std::abs(hand.force.y())));
}

}  // namespace

void ViewScreen::take(const ViewState& state) {
  constexpr std::uint32_t kRecent = ViewState::kRecent;
  const bool another = state.bout != state_.bout;
  if (another) story_.clear();
  const std::uint32_t seen = another ? 0 : state_.steps + 1;
  const std::uint32_t kept = state.steps < kRecent ? 0 : state.steps - kRecent + 1;
  for (std::uint32_t i = std::max(seen, kept); i <= state.steps; ++i) {  // Bound: kRecent
    story_.add_tip(Side::kLeft, state.tips[0][i % kRecent]);
    story_.add_tip(Side::kRight, state.tips[1][i % kRecent]);
  }
  const std::uint32_t beats_seen = another ? 0 : state_.beat_count;
  const std::uint32_t beats_kept = state.beat_count < kRecent ? 0 : state.beat_count - kRecent;
  for (std::uint32_t i = std::max(beats_seen, beats_kept); i < state.beat_count; ++i) {
    story_.add_beat(state.beats[i % kRecent]);  // Bound: kRecent
  }
  for (int i = another ? 0 : state_.touches.size(); i < state.touches.size(); ++i) {
    story_.add_touch(state.touches[i]);  // Bound: the touches of a bout
  }
  state_ = state;
}

void ViewScreen::draw(Canvas& canvas, const ViewControls& controls) const {
  canvas.rectangle({0, 0}, {kWidth, kHeight}, kPaper);
  draw_head(canvas, controls);
  for (SalleView view : {kSide, kAbove}) {
    view.middle = state_.postures.middle;  // it goes along with them
    view.reach = reach_of(state_.postures);
    draw_salle(canvas, view, state_.postures, story_);
  }
  draw_foot(canvas);
}

void ViewScreen::draw_head(Canvas& canvas, const ViewControls& controls) const {
  canvas.text({kMargin, 36}, headline(state_), 24, Anchor::kStart);
  canvas.text({kWidth - kMargin, 36}, with_seconds("%.3f s", state_.postures.time), 24,
              Anchor::kEnd);
  canvas.text({kMargin, 62}, "left: " + names_.left, 13, Anchor::kStart);
  canvas.text({kWidth - kMargin, 62}, "right: " + names_.right, 13, Anchor::kEnd);
  canvas.text({kWidth - kMargin, 88}, mode_of(controls), 16, Anchor::kEnd);
}

void ViewScreen::draw_foot(Canvas& canvas) const {
  for (const Side side : {Side::kLeft, Side::kRight}) draw_stick(canvas, side);
  canvas.text({kWidth / 2.0, 1046},
              std::to_string(state_.score[0]) + " : " + std::to_string(state_.score[1]), 64,
              Anchor::kMiddle);
  canvas.text({kWidth / 2.0, 1078}, "space pause   . one step   1 2 3 speed   r restart   q quit",
              11, Anchor::kMiddle);
}

void ViewScreen::draw_stick(Canvas& canvas, Side side) const {
  const bool left = side == Side::kLeft;
  const ViewState::Hand& hand = state_.hands[index_of(side)];
  const Pixel corner = {left ? kMargin : kWidth - kMargin - kPad, kPadTop};
  const auto on_pad = [&](const Vec2<float>& at) {
    return Pixel{corner.x + kPad / 2 * (1 + static_cast<double>(at.x())),
                 corner.y + kPad / 2 * (1 - static_cast<double>(at.y()))};
  };
  canvas.rectangle(corner, {kPad, kPad}, {240, 240, 236});
  canvas.circle(on_pad(hand.stick), 6, {palette(side).body, 4, 1}, {});
  const Vec2<float> end = hand.stick + hand.force;
  if (strength(hand) > 0) canvas.line(on_pad(hand.stick), on_pad(end), {kTouch, 4, 1});
  const Pixel words = {left ? corner.x + kPad + 14 : corner.x - 14, kPadTop + 34};
  const Anchor anchor = left ? Anchor::kStart : Anchor::kEnd;
  canvas.text(words, "force on the hand", 13, anchor);
  canvas.text({words.x, words.y + 28}, with_seconds("%.0f %%", 100 * strength(hand)), 20, anchor);
}

}  // namespace batuta::host
