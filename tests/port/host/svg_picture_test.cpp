// SPDX-License-Identifier: MIT
#include "programs/duel/svg_picture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <regex>
#include <sstream>
#include <vector>

#include "bouts.hpp"
#include "heap_trap.hpp"
#include "programs/devices/replay_device.hpp"
#include "programs/duel/svg_canvas.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using testing::HasSubstr;
using testing::Not;

std::string picture_of(BoutRig& bout) {
  std::ostringstream out;
  const auto picture = std::make_unique<SvgPicture>(out);
  bout.run(picture.get());
  return out.str();
}

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++found;
  return found;
}

TEST(SvgPicture, ShowsTheBout) {
  BoutRig bout("default", "script:parry");
  const std::string svg = picture_of(bout);
  EXPECT_THAT(svg, HasSubstr("Touch by left: torso"));
  EXPECT_EQ(count(svg, "from the side"), 1);
  EXPECT_EQ(count(svg, "from above"), 1);
  EXPECT_EQ(count(svg, "<circle"), 2 * static_cast<int>(bout.runner->tally().beats) + 1)
      << "each beat in both views, and the legend";
  EXPECT_EQ(count(svg, "<polygon"), 4)
      << "the touch in both views, on the time line, in the legend";
  EXPECT_LT(svg.size(), 400'000U);
}

TEST(SvgPicture, ADraw_HasNoStarButThatOfTheLegend) {
  BoutRig bout("script:guard", "script:guard", 1);
  const std::string svg = picture_of(bout);
  EXPECT_THAT(svg, HasSubstr("No touch in 1.00 s"));
  EXPECT_EQ(count(svg, "<polygon"), 1);
}

/// A text of a picture: the middle of its base line, and how broad it is, about.
struct Written {
  double x = 0;
  double y = 0;
  double width = 0;
};

/// What is written at the stars: the texts of this size.
std::vector<Written> labels_of(const std::string& svg) {
  const std::regex text("<text x=\"([-0-9.]+)\" y=\"([-0-9.]+)\" font-size=\"14\"[^>]*>([^<]*)<");
  std::vector<Written> found;
  for (std::sregex_iterator it(svg.begin(), svg.end(), text), end; it != end; ++it) {
    found.push_back(
        {std::stod((*it)[1]), std::stod((*it)[2]), 7.0 * static_cast<double>((*it)[3].length())});
  }
  return found;
}

// Who is touched five times by the same lunge is touched in the same places.
TEST(SvgPicture, OfManyTouches_WritesNoWordOverAnother) {
  BoutRules rules;
  rules.touches = 5;
  BoutRig bout("script:attack", "script:guard", std::numeric_limits<double>::infinity(), rules);
  const std::vector<Written> labels = labels_of(picture_of(bout));
  ASSERT_GE(labels.size(), 10U) << "five touches in both views";
  for (std::size_t i = 0; i < labels.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) {
      const bool is_aside =
          std::abs(labels[i].x - labels[k].x) > (labels[i].width + labels[k].width) / 2;
      EXPECT_TRUE(is_aside || std::abs(labels[i].y - labels[k].y) > 12) << i << " over " << k;
    }
  }
}

TEST(SvgPicture, ABoutThatIsBrokenOff_SaysSo) {
  BoutRig bout("script:guard", "script:guard");
  for (const int steps : {0, 250}) {
    std::ostringstream out;
    const auto picture = std::make_unique<SvgPicture>(out);
    picture->on_start(*bout.runner);
    for (int i = 0; i < steps; ++i) {
      ASSERT_TRUE(bout.runner->step());
      picture->on_step(*bout.runner);
    }
    picture->on_end(*bout.runner);
    EXPECT_THAT(out.str(), HasSubstr(steps == 0 ? "Broken off after 0.00 s" : "after 0.25 s"));
    EXPECT_THAT(out.str(), Not(HasSubstr("Touch by")));
  }
}

/// A stick that goes up the middle and back, five times a second.
Recording beats_for(double duration) {
  Recording recording;
  recording.duration = duration;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(duration * 10); ++i) {
    InputSample sample;
    sample.time = i * 100000;
    sample.sequence = i;
    sample.y = i % 2 == 0 ? 0.0F : 0.5F;
    recording.samples.push_back(sample);
  }
  return recording;
}

TEST(SvgPicture, ALongBout_StaysSmall_AndSaysWhatItLeavesOut) {
  BoutRig bout("script:guard", "script:guard", 180);
  bout.left = std::make_unique<ReplayDevice>(beats_for(180), "beating");
  bout.runner = std::make_unique<DuelRunner>(*bout.left, *bout.right, 180);
  ASSERT_EQ(bout.runner->start(), Status::kOk);
  const std::string svg = picture_of(bout);
  ASSERT_GT(bout.runner->tally().beats, static_cast<std::uint32_t>(SvgPicture::kMaxBeats));
  EXPECT_LT(svg.size(), 400'000U);
  EXPECT_EQ(count(svg, "<circle"), 2 * SvgPicture::kMaxBeats + 1);
  EXPECT_THAT(svg, HasSubstr("(the 400 hardest)"));
}

TEST(SvgPicture, Watching_AllocatesNothing) {
  BoutRig bout("default", "script:parry");
  std::ostringstream out;
  const auto picture = std::make_unique<SvgPicture>(out);
  picture->on_start(*bout.runner);
  int allocations = 0;
  bool going_on = true;
  while (going_on) {
    going_on = bout.runner->step();
    const test::HeapTrap trap;
    picture->on_step(*bout.runner);
    allocations += trap.allocations();
  }
  EXPECT_EQ(allocations, 0);
}

TEST(SvgCanvas, NumbersAndTextsAreAlwaysValid) {
  std::ostringstream out;
  {
    SvgCanvas canvas(out, 10, 20);
    canvas.line({-0.04, 1e300}, {std::numeric_limits<double>::quiet_NaN(), -12.34},
                {{1, 2, 3}, 1, 0.5});
    canvas.text({1, 2}, "a<b & \"c\" \xFF\x01", 3, Anchor::kStart);
  }
  EXPECT_THAT(out.str(), HasSubstr("x1=\"0\" y1=\"100000000\" x2=\"0\" y2=\"-12.3\""));
  EXPECT_THAT(out.str(), HasSubstr("a&lt;b &amp; \"c\" ?\?<"));
  EXPECT_THAT(out.str(), Not(HasSubstr("nan")));
}

TEST(Colour, Mixed_IsExactAtItsEnds) {
  const Colour from{10, 200, 0};
  const Colour to{20, 100, 255};
  EXPECT_EQ(mixed(from, to, 0).green, 200);
  EXPECT_EQ(mixed(from, to, 1).blue, 255);
  EXPECT_EQ(mixed(from, to, 0.5).red, 15);
}

}  // namespace
}  // namespace batuta::host
