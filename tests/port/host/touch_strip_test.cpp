// SPDX-License-Identifier: MIT
// The pictures of --strip against the bout's own places, projected by the test.
#include "programs/duel/touch_strip.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>
#include <vector>

#include "bouts.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using testing::HasSubstr;

constexpr std::array<const char*, 2> kBladeColours = {"rgb(70,120,180)", "rgb(205,120,50)"};

struct Line {
  Pixel a;
  Pixel b;
};

std::vector<Line> lines_of(const std::string& svg, const char* colour) {
  std::vector<Line> lines;
  const std::regex pattern(
      "<line x1=\"([-0-9.]+)\" y1=\"([-0-9.]+)\" x2=\"([-0-9.]+)\" "
      "y2=\"([-0-9.]+)\" stroke=\"([^\"]+)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), pattern), end; it != end; ++it) {
    if ((*it)[5] != colour) continue;
    std::array<double, 4> n{};
    for (std::size_t i = 0; i < 4; ++i) n[i] = std::stod((*it)[i + 1]);
    lines.push_back({{n[0], n[1]}, {n[2], n[3]}});
  }
  return lines;
}

/// Three pictures in a row, 400 x 200 pixels for 3.9 m of the salle, the floor at the lower edge.
Pixel projected(const Vec3<float>& p_W, int picture) {
  constexpr double kPixelsPerMetre = 400 / 3.9;
  const double left = 20 + 420.0 * (picture % 3);
  const double floor = 70 + 240.0 * (picture / 3) + 200;
  return {left + 200 + static_cast<double>(p_W.x()) * kPixelsPerMetre,
          floor - static_cast<double>(p_W.z()) * kPixelsPerMetre};
}

void expect_near(const Pixel& drawn, const Pixel& expected) {
  constexpr double kWritten = 0.06;  // numbers are written to a tenth of a pixel
  EXPECT_NEAR(drawn.x, expected.x, kWritten);
  EXPECT_NEAR(drawn.y, expected.y, kWritten);
}

TEST(TouchStrip, ShowsBothBladesEverySixtyMillisecondsUpToTheTouch) {
  BoutRig rig("script:attack", "script:guard");
  std::ostringstream out;
  TouchStrip strip(out);
  std::vector<std::array<Segment<float>, 2>> blades;
  const auto& duel = rig.runner->duel();
  const auto log = [&] {
    blades.push_back({duel.blade_W(Side::kLeft).axis, duel.blade_W(Side::kRight).axis});
  };
  strip.on_start(*rig.runner);
  log();
  std::size_t touched = 0;
  for (bool going_on = true; going_on;) {
    going_on = rig.runner->step();
    strip.on_step(*rig.runner);
    log();
    if (touched == 0 && duel.bout().touches.size() > 0) touched = blades.size() - 1;
  }
  strip.on_end(*rig.runner);
  ASSERT_EQ(duel.bout().touches.size(), 1);
  ASSERT_GE(touched, 300U);
  for (std::size_t side = 0; side < 2; ++side) {
    const auto lines = lines_of(out.str(), kBladeColours[side]);
    ASSERT_EQ(lines.size(), 6U);
    for (std::size_t i = 0; i < 6; ++i) {
      const Segment<float>& blade = blades[touched - 60 * (5 - i)][side];
      expect_near(lines[i].a, projected(blade.a, static_cast<int>(i)));
      expect_near(lines[i].b, projected(blade.b, static_cast<int>(i)));
    }
  }
  EXPECT_THAT(out.str(), HasSubstr("Touch by left"));
}

TEST(TouchStrip, WithoutATouch_SaysSo) {
  BoutRig rig("script:guard", "script:guard", 0.01);
  std::ostringstream out;
  TouchStrip strip(out);
  rig.run(&strip);
  EXPECT_THAT(out.str(), HasSubstr("No touch in this bout"));
}

}  // namespace
}  // namespace batuta::host
