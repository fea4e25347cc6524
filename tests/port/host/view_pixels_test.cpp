// SPDX-License-Identifier: MIT
// The window of --view, read back pixel by pixel, and its keys.
#include <SDL.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "bouts.hpp"
#include "programs/duel/view/sdl_canvas.hpp"
#include "programs/duel/view/sdl_view.hpp"
#include "soon.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using test::soon;

/// The screen drawn by SDL into memory.
class Screenshot {
 public:
  explicit Screenshot(const ViewScreen& screen, const ViewControls& controls = {})
      : surface_(SDL_CreateRGBSurfaceWithFormat(0, ViewScreen::kWidth, ViewScreen::kHeight, 32,
                                                SDL_PIXELFORMAT_ARGB8888)) {
    SDL_Renderer* const renderer = SDL_CreateSoftwareRenderer(surface_);
    EXPECT_NE(renderer, nullptr) << SDL_GetError();
    SdlCanvas canvas(renderer);
    screen.draw(canvas, controls);
    SDL_RenderPresent(renderer);
    SDL_DestroyRenderer(renderer);
  }
  Screenshot(const Screenshot&) = delete;
  Screenshot& operator=(const Screenshot&) = delete;
  ~Screenshot() { SDL_FreeSurface(surface_); }

  Colour at(double x, double y) const {
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    const auto* const line = static_cast<const std::uint8_t*>(surface_->pixels) +
                             static_cast<std::ptrdiff_t>(row) * surface_->pitch;
    const std::uint32_t pixel = reinterpret_cast<const std::uint32_t*>(line)[column];
    return {static_cast<int>(pixel >> 16U & 0xFFU), static_cast<int>(pixel >> 8U & 0xFFU),
            static_cast<int>(pixel & 0xFFU)};
  }
  /// Pixels of a part of the screen that are as dark as ink.
  int ink(SDL_Rect part) const {
    int dark = 0;
    for (int y = part.y; y < part.y + part.h; ++y) {
      for (int x = part.x; x < part.x + part.w; ++x) dark += at(x, y).green < 100 ? 1 : 0;
    }
    return dark;
  }
  int of_colour(SDL_Rect part, const Colour& colour) const;

 private:
  SDL_Surface* surface_;
};

bool is(const Colour& seen, const Colour& wanted) {
  constexpr int kNear = 12;  // of 255: an edge that fades, or rounding
  return std::abs(seen.red - wanted.red) <= kNear && std::abs(seen.green - wanted.green) <= kNear &&
         std::abs(seen.blue - wanted.blue) <= kNear;
}

int Screenshot::of_colour(SDL_Rect part, const Colour& colour) const {
  int count = 0;
  for (int y = part.y; y < part.y + part.h; ++y) {
    for (int x = part.x; x < part.x + part.w; ++x) count += is(at(x, y), colour) ? 1 : 0;
  }
  return count;
}

/// The blades' colours as docs and legend have them: blue on the left, orange on the right.
constexpr std::array<Colour, 2> kBlades = {{{70, 120, 180}, {205, 120, 50}}};
constexpr Colour kRed = {215, 0, 30};

/// Where a point of the salle is, written down once more: 250 pixels a metre; the side view begins
/// 2 m left of the middle and 2 m above the floor at (30, 96), that from above 0.7 m beside the
/// middle line at (30, 628).
Pixel seen_from_the_side(const Vec3<float>& p_W) {
  return {30 + 250 * (2 + static_cast<double>(p_W.x())),
          96 + 250 * (2 - static_cast<double>(p_W.z()))};
}
Pixel seen_from_above(const Vec3<float>& p_W) {
  return {30 + 250 * (2 + static_cast<double>(p_W.x())),
          628 + 250 * (0.7 - static_cast<double>(p_W.y()))};
}

/// Points on the line from a to b that have the colour, of 99; and of those so many pixels beside.
int coloured(const Screenshot& shot, Pixel a, Pixel b, const Colour& colour, double beside = 0) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const Pixel across = {beside * (a.y - b.y) / length, beside * (b.x - a.x) / length};
  int count = 0;
  for (int i = 1; i < 100; ++i) {
    const double share = i / 100.0;
    const Colour seen =
        shot.at(a.x + (b.x - a.x) * share + across.x, a.y + (b.y - a.y) * share + across.y);
    count += is(seen, colour) ? 1 : 0;
  }
  return count;
}

struct ShownBout {
  explicit ShownBout(const char* left = "default", const char* right = "script:parry")
      : bout(left, right) {
    feed.begin(bout.runner->duel(), bout.runner->bout().forces());
    screen.take(feed.state());
  }
  bool step(int steps) {
    bool going_on = true;
    for (int i = 0; i < steps && going_on; ++i) {
      going_on = bout.runner->step();
      feed.add_step(bout.runner->duel(), bout.runner->bout().forces());
      screen.take(feed.state());
    }
    return going_on;
  }

  BoutRig bout;
  ViewFeed feed;
  ViewScreen screen{ViewNames{"left words", "right words"}};
};

TEST(ViewPixels, TheBladesAreWhereTheDuelHasThem) {
  ShownBout shown("default", "script:guard");
  for (int i = 0; i < 4; ++i) {
    const Screenshot shot(shown.screen);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const Segment<float>& blade = shown.bout.runner->duel().blade_W(side).axis;
      const Colour& colour = kBlades[index_of(side)];
      for (const auto& look : {seen_from_the_side, seen_from_above}) {
        // Rings, traces and the right blade lie on it: up to four tenths of it.
        const int least = i == 0 && side == Side::kRight ? 95 : 60;
        EXPECT_GE(coloured(shot, look(blade.a), look(blade.b), colour), least);
        EXPECT_LE(coloured(shot, look(blade.a), look(blade.b), colour, 9), 5) << "and only there";
      }
    }
    ASSERT_TRUE(shown.step(1111));
  }
}

TEST(ViewPixels, ATouch_ChangesTheScoreAndLeavesAStar) {
  const SDL_Rect left = {440, 990, 70, 62};
  const SDL_Rect right = {550, 990, 70, 62};
  ShownBout shown;
  const Screenshot before(shown.screen);
  EXPECT_GT(before.ink(left), 100);
  EXPECT_NEAR(before.ink(left), before.ink(right), 0.1 * before.ink(right)) << "0 : 0";
  while (shown.step(1)) {
  }
  const Screenshot after(shown.screen);
  EXPECT_GT(after.ink(left), 100);
  EXPECT_LT(after.ink(left), 0.7 * before.ink(left)) << "1 is thinner than 0";
  EXPECT_EQ(after.ink(right), before.ink(right));
  const Vec3<float> point_W = shown.bout.runner->duel().bout().touches[0].contact.point_W;
  for (const auto& look : {seen_from_the_side, seen_from_above}) {
    const Pixel at = look(point_W);
    EXPECT_TRUE(is(after.at(at.x, at.y), kRed));
    EXPECT_FALSE(is(before.at(at.x, at.y), kRed));
  }
}

TEST(ViewPixels, TheForceGoesFromTheStickInItsDirection) {
  ViewScreen screen{ViewNames{}};
  ViewState state;
  state.bout = 1;
  state.hands[0].stick = {-0.5F, 0.5F};
  state.hands[1].force = {0.25F, 0.0F};
  const SDL_Rect left_pad = {30, 988, 80, 80};
  const SDL_Rect right_pad = {950, 988, 80, 80};
  screen.take(state);
  const Screenshot weak(screen);
  EXPECT_EQ(weak.of_colour(left_pad, kRed), 0) << "no force, no line";
  // The stick's ring, to the left of and above the middle.
  EXPECT_GT(weak.of_colour({40, 998, 20, 20}, kBlades[0]), 20);
  EXPECT_EQ(weak.of_colour({72, 1030, 36, 36}, kBlades[0]), 0);
  // From the middle of the pad 10 pixels to the right, 4 pixels wide.
  EXPECT_GT(weak.of_colour(right_pad, kRed), 20);
  EXPECT_EQ(weak.of_colour({1004, 988, 26, 80}, kRed), 0);
  EXPECT_EQ(weak.of_colour({950, 988, 36, 80}, kRed), 0);
  state.hands[1].force = {0.75F, 0.0F};
  screen.take(state);
  const Screenshot strong(screen);
  const int more = strong.of_colour(right_pad, kRed) - weak.of_colour(right_pad, kRed);
  EXPECT_GE(more, 20 * 2) << "half of the range is 20 pixels; 2 or 3 of 4 in width do not fade";
  EXPECT_LE(more, 20 * 3);
  EXPECT_NE(strong.ink({820, 1020, 120, 40}), weak.ink({820, 1020, 120, 40})) << "the number";
}

/// SDL's driver that shows nothing, with the events of a window.
class ViewKeys : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(SDL_setenv("SDL_VIDEODRIVER", "dummy", 1), 0);
    view = std::make_unique<SdlView>(ViewNames{});
    ASSERT_EQ(view->open(), "");
  }
  void press(SDL_Keycode code, bool repeated = false) {
    SDL_Event event{};
    event.type = SDL_KEYDOWN;
    event.key.keysym.sym = code;
    event.key.repeat = repeated ? 1 : 0;
    ASSERT_EQ(SDL_PushEvent(&event), 1);
  }

  std::unique_ptr<SdlView> view;
};

TEST_F(ViewKeys, EachDoesWhatTheHelpSays) {
  ViewControls& controls = view->controls();
  press(SDLK_SPACE);
  EXPECT_TRUE(soon([&] { return controls.is_paused(); }));
  press(SDLK_PERIOD);
  press(SDLK_PERIOD, true);
  EXPECT_TRUE(soon([&] { return controls.take_step(); }));
  EXPECT_TRUE(soon([&] { return controls.take_step(); })) << "a key that is held";
  press(SDLK_SPACE, true);
  press(SDLK_2);
  EXPECT_TRUE(soon([&] { return controls.slowness() == 4; }));
  EXPECT_TRUE(controls.is_paused()) << "a pause is no key that is held";
  press(SDLK_3);
  EXPECT_TRUE(soon([&] { return controls.slowness() == 20; }));
  press(SDLK_1);
  EXPECT_TRUE(soon([&] { return controls.slowness() == 1; }));
  press(SDLK_SPACE);
  EXPECT_TRUE(soon([&] { return !controls.is_paused(); }));
  press(SDLK_r);
  EXPECT_TRUE(soon([&] { return controls.wish() == ViewWish::kRestart; }));
  controls.begin(false);
  press(SDLK_q);
  EXPECT_TRUE(soon([&] { return controls.wish() == ViewWish::kQuit; }));
}

TEST_F(ViewKeys, ClosingTheWindow_Quits) {
  SDL_Event event{};
  event.type = SDL_QUIT;
  ASSERT_EQ(SDL_PushEvent(&event), 1);
  EXPECT_TRUE(soon([&] { return view->controls().wish() == ViewWish::kQuit; }));
}

TEST_F(ViewKeys, ItDraws_WhetherOrNotTheBoutGoesOn) {
  const std::uint32_t before = view->pictures();
  EXPECT_TRUE(soon([&] { return view->pictures() >= before + 3; }));
}

}  // namespace
}  // namespace batuta::host
