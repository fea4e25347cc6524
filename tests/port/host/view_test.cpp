// SPDX-License-Identifier: MIT
// What the window of --view shows, and what its viewer may do.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "bouts.hpp"
#include "heap_trap.hpp"
#include "programs/duel/bout_words.hpp"
#include "programs/duel/pacing.hpp"
#include "programs/duel/view/stroke_font.hpp"
#include "programs/duel/view/view.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

/// Takes every `every`-th state, as a window does that draws more seldom than the bout steps.
class SlowScreen final : public View {
 public:
  explicit SlowScreen(std::uint32_t every) : every_(every) {}
  void show(const ViewState& state) override {
    if (state.over || state.steps % every_ == 0) screen.take(state);
    last = state;
  }

  ViewScreen screen{ViewNames{}};
  ViewState last;

 private:
  std::uint32_t every_;
};

void expect_same_story(const BoutStory& a, const BoutStory& b) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    ASSERT_EQ(a.tips(side).size(), b.tips(side).size());
    for (std::size_t i = 0; i < a.tips(side).size(); ++i) {
      EXPECT_EQ(a.tips(side)[i].p_W, b.tips(side)[i].p_W) << i;
    }
  }
  ASSERT_EQ(a.beats().size(), b.beats().size());
  for (int i = 0; i < a.beats().size(); ++i) EXPECT_EQ(a.beats()[i].time, b.beats()[i].time);
}

TEST(Drawing, ReachOf_HoldsBothFencers_HoweverFarApart) {
  Postures near;
  EXPECT_EQ(reach_of(near), SalleView::kReach);
  for (const float away : {-2.6F, 2.6F}) {
    Postures apart;
    apart.middle = 5;
    for (auto& body : apart.body_W) body.fill({{{5, 0, 1}, {5, 0, 1}}, 0.1F});
    apart.blade_W.fill({{{5, 0, 1}, {5, 0, 1}}, 0.01F});
    apart.body_W[1][3] = {{{5 + away, 0, 1}, {5, 0, 1}}, 0.1F};
    EXPECT_GE(reach_of(apart), 2.7);
    EXPECT_LE(reach_of(apart), 2.8);
  }
}

TEST(ViewScreen, DrawnEveryHundredSteps_ItMissesNothing) {
  for (const std::uint32_t every : {1U, 17U, ViewState::kRecent}) {
    BoutRig bout("default", "script:parry");
    SlowScreen view(every);
    ViewFeed feed;
    ViewObserver observer(view, feed, nullptr);
    auto every_step = std::make_unique<BoutStory>();
    observer.on_start(*bout.runner);
    every_step->add_step(bout.runner->duel());
    bool going_on = true;
    while (going_on) {
      going_on = bout.runner->step();
      observer.on_step(*bout.runner);
      every_step->add_step(bout.runner->duel());
    }
    observer.on_end(*bout.runner);
    ASSERT_GT(every_step->beats().size(), 10);
    expect_same_story(view.screen.story(), *every_step);
    EXPECT_EQ(view.screen.story().touches().size(), 1);
    EXPECT_EQ(view.last.score, (std::array<int, 2>{1, 0}));
  }
}

TEST(ViewScreen, TouchesOfAllExchanges_StayInSight) {
  BoutRig bout("script:attack", "script:parry", std::numeric_limits<double>::infinity(), {3});
  SlowScreen view(100);
  ViewFeed feed;
  ViewObserver observer(view, feed, nullptr);
  bool halted = false;
  observer.on_start(*bout.runner);
  bool going_on = true;
  while (going_on) {
    going_on = bout.runner->step();
    observer.on_step(*bout.runner);
    halted = halted || view.last.halt;
  }
  observer.on_end(*bout.runner);
  EXPECT_TRUE(halted);
  EXPECT_EQ(view.last.score, (std::array<int, 2>{3, 0}));
  const auto& touches = view.screen.story().touches();
  ASSERT_EQ(touches.size(), 3);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(touches[i].exchange, static_cast<std::uint32_t>(i + 1));
}

TEST(ViewScreen, AnotherBout_BeginsAnotherStory) {
  SlowScreen view(1);
  ViewFeed feed;
  for (const int steps : {500, 30}) {
    BoutRig bout("script:attack", "script:parry");
    ViewObserver observer(view, feed, nullptr);
    observer.on_start(*bout.runner);
    for (int i = 0; i < steps; ++i) {
      ASSERT_TRUE(bout.runner->step());
      observer.on_step(*bout.runner);
    }
  }
  EXPECT_EQ(view.last.bout, 2U);
  EXPECT_EQ(view.last.steps, 30U);
  const Trace& tips = view.screen.story().tips(Side::kLeft);
  EXPECT_NEAR(static_cast<double>(tips[tips.size() - 1].time), 0.03, 0.03);
}

TEST(ViewFeed, AStep_AllocatesNothing) {
  BoutRig bout("default", "script:parry", 3);
  ViewFeed feed;
  feed.begin(bout.runner->duel(), bout.runner->bout().forces());
  int allocations = 0;
  bool going_on = true;
  while (going_on) {
    going_on = bout.runner->step();
    const test::HeapTrap trap;
    feed.add_step(bout.runner->duel(), bout.runner->bout().forces());
    allocations += trap.allocations();
  }
  EXPECT_EQ(allocations, 0);
}

TEST(ViewControls, PauseAndSingleSteps) {
  ViewControls controls;
  controls.single_step();
  EXPECT_TRUE(controls.is_paused()) << "a bout that runs is paused";
  EXPECT_FALSE(controls.take_step());
  controls.single_step();
  controls.single_step();
  EXPECT_TRUE(controls.take_step());
  EXPECT_TRUE(controls.take_step());
  EXPECT_FALSE(controls.take_step()) << "once for each";
  controls.toggle_pause();
  EXPECT_FALSE(controls.is_paused());
}

TEST(ViewControls, ADeviceThatKeepsItsTime_WaitsForNobody) {
  ViewControls controls;
  controls.toggle_pause();
  controls.slow_down(ViewControls::kTwentieth);
  controls.begin(true);
  EXPECT_FALSE(controls.is_paused());
  EXPECT_EQ(controls.slowness(), 1);
  controls.toggle_pause();
  controls.single_step();
  controls.slow_down(ViewControls::kQuarter);
  EXPECT_FALSE(controls.is_paused());
  EXPECT_EQ(controls.slowness(), 1);
  controls.wish(ViewWish::kQuit);
  controls.begin(true);
  EXPECT_EQ(controls.wish(), ViewWish::kQuit) << "who has left does not come back";
}

TEST(Pacing, AViewerStepsAndQuits) {
  ViewControls controls;
  Pacing pacing(true, &controls);
  EXPECT_TRUE(pacing.wait());
  controls.toggle_pause();
  controls.single_step();
  EXPECT_TRUE(pacing.wait()) << "the step that was asked for";
  controls.wish(ViewWish::kRestart);
  EXPECT_FALSE(pacing.wait());
  EXPECT_EQ(wait_for_wish(controls), ViewWish::kRestart);
  controls.begin(false);
  EXPECT_EQ(controls.wish(), ViewWish::kNone) << "the wish is granted once";
}

TEST(Pacing, SlowMotion_TakesAsManyTimesAsLong) {
  for (const int slowness : {ViewControls::kQuarter, ViewControls::kTwentieth}) {
    ViewControls controls;
    controls.slow_down(slowness);
    Pacing pacing(true, &controls);
    constexpr int kSteps = 20;
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < kSteps; ++i) ASSERT_TRUE(pacing.wait());
    const auto spent = std::chrono::steady_clock::now() - start;
    // Never sooner; how much later is the machine's affair.
    EXPECT_GE(spent, std::chrono::milliseconds(kSteps * slowness - slowness));
  }
}

TEST(StrokeFont, WhatTheProgramSays_HasLetters) {
  std::vector<PenStroke> box;
  write_strokes("\xC3\xBC", {0, 0}, 60, box);
  ASSERT_EQ(box.size(), 4U);
  for (char sign = ' '; sign < '\x7f'; ++sign) {
    if (std::string("#$&@\\^`{|}~").find(sign) != std::string::npos) continue;
    std::vector<PenStroke> strokes;
    write_strokes(std::string(1, sign), {10, 70}, 60, strokes);
    EXPECT_TRUE(strokes.empty() == (sign == ' ')) << sign;
    bool is_box = strokes.size() == box.size();
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      for (const Pixel& end : {strokes[i].from, strokes[i].to}) {
        EXPECT_GE(end.x, 10) << sign;
        EXPECT_LE(end.x, 10 + text_width("M", 60) + 1e-9) << sign;
        EXPECT_LE(end.y, 70) << sign;
        EXPECT_GE(end.y, 70 - 0.7 * 60 - 1e-9) << sign;
      }
      is_box = is_box && strokes[i].to.x == box[i].to.x + 10 && strokes[i].to.y == box[i].to.y + 70;
    }
    EXPECT_FALSE(is_box) << sign;
  }
}

}  // namespace
}  // namespace batuta::host
