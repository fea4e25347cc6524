// SPDX-License-Identifier: MIT
// The arrows of --figure against the bout's own places, and against the laws of the blow.
#include "programs/duel/beat_figure.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "bouts.hpp"
#include "heap_trap.hpp"
#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

using testing::HasSubstr;
using Vector = Vec3<double>;

constexpr std::array<const char*, 2> kArrowColours = {"rgb(10,50,120)", "rgb(140,40,0)"};
constexpr const char* kYardstickColour = "rgb(120,120,120)";
constexpr double kMostPixelsForMetrePerSecond = 40;
constexpr double kHalfPanel = 140;  // pixels: no arrow is longer
constexpr int kArrows = 5;
constexpr float kDt = 1e-3F;

struct Arrow {
  Pixel from;
  Pixel along;
};

/// Every line of a colour, in the order of the file.
std::vector<Arrow> arrows_of(const std::string& svg, const char* colour) {
  std::vector<Arrow> arrows;
  const std::regex line(
      "<line x1=\"([-0-9.]+)\" y1=\"([-0-9.]+)\" x2=\"([-0-9.]+)\" "
      "y2=\"([-0-9.]+)\" stroke=\"([^\"]+)\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), line), end; it != end; ++it) {
    if ((*it)[5] != colour) continue;
    std::array<double, 4> n{};
    for (std::size_t i = 0; i < 4; ++i) n[i] = std::stod((*it)[i + 1]);
    arrows.push_back({{n[0], n[1]}, {n[2] - n[0], n[3] - n[1]}});
  }
  return arrows;
}

/// Panels in the order of the file: before and after, from the side; the same from above.
const Arrow& arrow(const std::vector<Arrow>& all, bool above, bool after, int place) {
  return all.at(static_cast<std::size_t>((above ? 2 : 0) + (after ? 1 : 0)) * kArrows +
                static_cast<std::size_t>(place));
}

/// What a bout came to, step by step, kept by the test.
struct LoggedBout {
  struct Step {
    std::array<Segment<float>, 2> blades;
  };

  explicit LoggedBout(const char* left, const char* right) : bout(left, right) {
    BeatFigure figure(out);
    const auto& duel = bout.runner->duel();
    const auto log = [&] {
      steps.push_back({{duel.blade_W(Side::kLeft).axis, duel.blade_W(Side::kRight).axis}});
    };
    figure.on_start(*bout.runner);
    log();
    bool going_on = true;
    while (going_on) {
      going_on = bout.runner->step();
      figure.on_step(*bout.runner);
      log();
      for (const auto& event : duel.events()) {
        if (!is_beat(event) || event.impulse <= beat.impulse) continue;
        beat = event;
        step = steps.size() - 1;
      }
    }
    figure.on_end(*bout.runner);
    seen = figure.hardest();
  }
  /// Of a place on a blade, 0 guard ... 1 tip, over the step that ends with `i`, m/s.
  Vector velocity(Side side, std::size_t i, double place) const {
    const Segment<float>& from = steps.at(i - 1).blades[index_of(side)];
    const Segment<float>& to = steps.at(i).blades[index_of(side)];
    const Vector guard = (to.a - from.a).cast<double>() / static_cast<double>(kDt);
    const Vector tip = (to.b - from.b).cast<double>() / static_cast<double>(kDt);
    return guard + (tip - guard) * place;
  }

  BoutRig bout;
  std::ostringstream out;
  std::vector<Step> steps;
  ContactEvent<float> beat;
  std::size_t step = 0;  ///< that ended with the hardest beat
  SeenBeat seen;
};

/// Pixels for 1 m/s: the fastest end of a blade fills half a panel, unless it is slow.
double scale_of(const LoggedBout& log) {
  double fastest = 0;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    for (const std::size_t i : {log.step - 1, log.step + 1}) {
      for (const double end : {0.0, 1.0}) {
        fastest = std::max(fastest, log.velocity(side, i, end).norm());
      }
    }
  }
  return std::min(kMostPixelsForMetrePerSecond, kHalfPanel / fastest);
}

TEST(BeatFigure, ItsArrowsAreTheVelocitiesOfTheHardestBeat) {
  for (const char* left : {"default", "script:attack", "script:guard"}) {
    LoggedBout log(left, "script:parry");
    ASSERT_GT(log.beat.impulse, 0.01F) << left;
    const std::string svg = log.out.str();
    const double scale = scale_of(log);
    constexpr double kTenth = 0.11;  // both ends are written to a tenth of a pixel
    EXPECT_THAT(svg, HasSubstr(">1 m/s<")) << left;
    EXPECT_NEAR(arrows_of(svg, kYardstickColour).at(0).along.x, scale, kTenth) << "the yardstick";
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const auto arrows = arrows_of(svg, kArrowColours[index_of(side)]);
      ASSERT_EQ(arrows.size(), 4U * kArrows) << left;
      for (int place = 0; place < kArrows; ++place) {
        for (const bool after : {false, true}) {
          const Vector v =
              scale * log.velocity(side, after ? log.step + 1 : log.step - 1, place / 4.0);
          const Arrow& from_side = arrow(arrows, false, after, place);
          EXPECT_NEAR(from_side.along.x, v.x(), kTenth);
          EXPECT_NEAR(from_side.along.y, -v.z(), kTenth) << "up is up";
          const Arrow& from_above = arrow(arrows, true, after, place);
          EXPECT_NEAR(from_above.along.x, v.x(), kTenth);
          EXPECT_NEAR(from_above.along.y, -v.y(), kTenth);
        }
      }
    }
  }
}

/// From the arrows alone, m/s.
Vector drawn(const LoggedBout& log, const std::vector<Arrow>& arrows, bool after, double place) {
  const auto at = [&](int i) -> Vector {
    const Pixel side = arrow(arrows, false, after, i).along;
    const Pixel above = arrow(arrows, true, after, i).along;
    return Vector(side.x, -above.y, -side.y) / scale_of(log);
  };
  return at(0) + (at(kArrows - 1) - at(0)) * place;
}

/// How far the velocity of a place may be from that at the contact, m/s: what it changes by itself,
/// without a blow, in the step before and in the step after, twice; and the tenths of a pixel.
double slack(const LoggedBout& log, Side side, double place) {
  const auto change = [&](std::size_t i) {
    return (log.velocity(side, i, place) - log.velocity(side, i - 1, place)).norm();
  };
  return 2 * (change(log.step - 1) + change(log.step + 2)) + 3 * 0.1 / scale_of(log);
}

TEST(BeatFigure, ItsArrowsObeyTheLawsOfTheBlow) {
  const LoggedBout log("script:parry", "script:attack");
  const WeaponBody<float> weapon = first_fencer<float>().weapon;
  const auto left = arrows_of(log.out.str(), kArrowColours[0]);
  const auto right = arrows_of(log.out.str(), kArrowColours[1]);
  const Vector n = log.beat.contact.normal_BA_W.cast<double>();
  const double place_A = static_cast<double>(log.beat.place_A);
  const double place_B = static_cast<double>(log.beat.place_B);
  const double v_rel = static_cast<double>(log.beat.v_rel);

  // Restitution [Kavan eq. 25].
  const double off = slack(log, Side::kLeft, place_A) + slack(log, Side::kRight, place_B);
  EXPECT_LT(off, 0.15 * std::abs(v_rel)) << "else this shows nothing";
  const Vector apart_before = drawn(log, left, false, place_A) - drawn(log, right, false, place_B);
  const Vector apart_after = drawn(log, left, true, place_A) - drawn(log, right, true, place_B);
  EXPECT_NEAR(apart_before.dot(n), v_rel, off);
  EXPECT_NEAR(apart_after.dot(n), -static_cast<double>(weapon.restitution) * v_rel, off);

  // Momentum [Kavan eq. 12, 24]: both centres of mass change by the impulse, one each way.
  const Segment<float>& axis_B = weapon.blade_B.axis;  // the centre of mass is its origin
  const double centre = static_cast<double>(axis_B.a.x() / (axis_B.a.x() - axis_B.b.x()));
  const double mass = static_cast<double>(weapon.mass);
  const Vector impulse = static_cast<double>(log.beat.impulse) * n;
  // What the hands catch of the blow in the two steps after it, of the 20 that they take at least:
  // h + s h' at s = 0.1 of what both ends of the blade were given (src/fencing/grip.md).
  constexpr double kCaught = 0.028 + 0.054;
  const auto caught = [&log](const auto& arrows) {
    double given = 0;
    for (const double end : {0.0, 1.0}) {
      given += (drawn(log, arrows, true, end) - drawn(log, arrows, false, end)).norm();
    }
    return kCaught * given;
  };
  EXPECT_LT(mass * slack(log, Side::kLeft, centre), 0.15 * impulse.norm());
  EXPECT_LE(
      (mass * (drawn(log, left, true, centre) - drawn(log, left, false, centre)) - impulse).norm(),
      mass * (slack(log, Side::kLeft, centre) + caught(left)));
  EXPECT_LE((mass * (drawn(log, right, true, centre) - drawn(log, right, false, centre)) + impulse)
                .norm(),
            mass * (slack(log, Side::kRight, centre) + caught(right)));
}

TEST(BeatFigure, TheBladesMeetWhereTheBeatIs) {
  const LoggedBout log("script:parry", "script:attack");
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const std::size_t i = index_of(side);
    const float place = side == Side::kLeft ? log.beat.place_A : log.beat.place_B;
    const Vec3<float> met =
        log.seen.contact.guard[i] + (log.seen.contact.tip[i] - log.seen.contact.guard[i]) * place;
    const float radius = log.bout.runner->duel().blade_W(side).radius;
    EXPECT_LT((met - log.beat.contact.point_W).norm(), 2 * radius);
  }
}

TEST(BeatFigure, WithoutABeat_ItSaysSo) {
  for (const double seconds : {0.001, 0.5}) {
    BoutRig bout("script:guard", "script:guard", seconds);
    std::ostringstream out;
    BeatFigure figure(out);
    bout.run(&figure);
    EXPECT_THAT(out.str(), HasSubstr("No beat in this bout"));
    EXPECT_THAT(out.str(), HasSubstr("</svg>"));
  }
}

TEST(BeatFigure, Watching_AllocatesNothing) {
  BoutRig bout("default", "script:parry");
  std::ostringstream out;
  BeatFigure figure(out);
  figure.on_start(*bout.runner);
  int allocations = 0;
  bool going_on = true;
  while (going_on) {
    going_on = bout.runner->step();
    const test::HeapTrap trap;
    figure.on_step(*bout.runner);
    allocations += trap.allocations();
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_TRUE(figure.hardest().found);
}

}  // namespace
}  // namespace batuta::host
