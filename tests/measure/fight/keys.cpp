// SPDX-License-Identifier: MIT
#include "keys.hpp"

#include <cmath>

namespace fight {
namespace {

constexpr double kRounding = 1e4;  // keys are given to 0.1 mm, 0.1 mrad
constexpr double kThird = 0.3;     // between two lunges, nearer to the first

Triple sum(double a, const Triple& x, double b, const Triple& y) {
  return {a * x[0] + b * y[0], a * x[1] + b * y[1], a * x[2] + b * y[2]};
}
Triple unit(const Triple& x) {
  const double length = std::sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
  return {x[0] / length, x[1] / length, x[2] / length};
}

/// What keeps the feet still beside the two keys that let them retreat: between keys the surface
/// swings (src/fencing/map.md). Row by row from the back.
constexpr std::array<std::array<double, kColumns>, kRows> kAgainstSwing = {
    {{0, 0, 0, -0.3, 0, -0.3, 0, 0, 0},
     {0, 0, 0, 0, 0, 0, 0, 0, 0},
     {0, 0, -0.2, 0.2, 0, 0.2, -0.2, 0, 0},
     {0, 0, 0, -0.2, -0.2, -0.2, 0, 0, 0},
     {0, 0, 0, 0, 0, 0, 0, 0, 0}}};

/// A hand, where its blade points, and what it asks of the feet.
struct Stance {
  Triple hand;
  Triple aim;  ///< of any length
  double feet;
};

Stance mix(const Stance& a, const Stance& b, double share) {
  return {sum(1 - share, a.hand, share, b.hand), sum(1 - share, unit(a.aim), share, unit(b.aim)),
          0};
}

/// The stances by name.
class Stances {
 public:
  explicit Stances(const Knobs& knobs) : knobs_(knobs) {}

  Triple place(const std::string& name) const {
    return {knobs_.at(name + ".x"), knobs_.at(name + ".y"), knobs_.at(name + ".z")};
  }
  Stance pose(const std::string& name) const {
    return {place(name + ".hand"), {1, knobs_.at(name + ".aim.y"), knobs_.at(name + ".aim.z")}, 0};
  }
  /// Where a lunge ends: the blade points at a spot of the opponent, given in his frame.
  Stance lunge(const std::string& line) const {
    const Triple hand = place(line + ".hand");
    return {hand, sum(1, spot(line), -1, hand), 0};
  }
  /// Arm out, the point already in its line: before the lunge.
  Stance extension(const std::string& line) const {
    const Stance guard = pose("guard");
    const Stance full = lunge(line);
    const double forward = knobs_.at("extension.forward");
    const double across = knobs_.at("extension.across");
    const Triple offset = place(line + ".extension");
    Stance out;
    for (std::size_t i = 0; i < 3; ++i) {
      const double share = i == 0 ? forward : across;
      out.hand[i] = guard.hand[i] + share * (full.hand[i] - guard.hand[i]) + offset[i];
    }
    out.aim = sum(1, spot(line), -1, out.hand);
    return out;
  }
  /// A semicircle: on the way to a low parry the point drops before the hand sweeps.
  Stance drop(const std::string& parry) const {
    const Stance guard = pose("guard");
    const Stance closed = pose(parry);
    const double by_aim = knobs_.at(parry + ".drop.aim");
    Stance out = mix(guard, closed, knobs_.at(parry + ".drop.hand"));
    out.aim = sum(1 - by_aim, unit(guard.aim), by_aim, unit(closed.aim));
    out.aim[1] += knobs_.at(parry + ".drop.aside");
    out.hand[2] += knobs_.at(parry + ".drop.lift");
    return out;
  }
  double value(const std::string& name) const { return knobs_.at(name); }

 private:
  Triple spot(const std::string& line) const {
    const Triple his = place(line + ".spot");
    return {kGuardDistance - his[0], -his[1], his[2]};
  }

  const Knobs& knobs_;
};

using Row = std::array<Stance, kColumns>;
using Grid = std::array<Row, kRows>;

/// Five stances, and between two of them their mean.
Row spread(const std::array<Stance, 5>& five) {
  Row row;
  for (std::size_t i = 0; i < five.size(); ++i) row[2 * i] = five[i];
  for (std::size_t i = 1; i < row.size(); i += 2) row[i] = mix(row[i - 1], row[i + 1], 0.5);
  return row;
}

Row lunges(const Stances& of) {
  const Stance high_inside = of.lunge("high_inside");
  const Stance low_inside = of.lunge("low_inside");
  const Stance middle = of.lunge("middle");
  const Stance low_outside = of.lunge("low_outside");
  const Stance high_outside = of.lunge("high_outside");
  return {high_inside, mix(high_inside, low_inside, kThird),
          low_inside,  mix(low_inside, middle, kThird),
          middle,      mix(low_outside, middle, kThird),
          low_outside, mix(high_outside, low_outside, kThird),
          high_outside};
}

/// On the straight way from guard to each of the four attacks lies its own extension.
Row extensions(const Stances& of) {
  const Stance high_inside = of.extension("high_inside");
  const Stance high_outside = of.extension("high_outside");
  return {high_inside,
          high_inside,
          high_inside,
          of.extension("low_inside"),
          of.extension("middle"),
          of.extension("low_outside"),
          high_outside,
          high_outside,
          high_outside};
}

Grid grid_of(const Stances& of) {
  const Stance guard = of.pose("guard");
  const Stance retreat = of.pose("retreat");
  const Stance quarte = of.pose("quarte");
  const Stance septime = of.pose("septime");
  const Stance octave = of.pose("octave");
  const Stance sixte = of.pose("sixte");
  const std::array<Stance, 5> high = {quarte, mix(guard, quarte, 0.5), guard,
                                      mix(guard, sixte, 0.5), sixte};
  const std::array<Stance, 5> low = {septime, mix(retreat, septime, 0.5), retreat,
                                     mix(retreat, octave, 0.5), octave};
  std::array<Stance, 5> between;
  for (std::size_t i = 0; i < between.size(); ++i) between[i] = mix(low[i], high[i], 0.5);
  between[1] = of.drop("septime");
  between[3] = of.drop("octave");
  Grid grid = {spread(low), spread(between), spread(high), extensions(of), lunges(of)};
  // The point sweeps flat through the other blade's foible.
  const auto beat = static_cast<int>(of.value("beat.place"));
  if (beat == 1) grid[3][4] = of.pose("beat");
  if (beat == 2) grid[2][3] = of.pose("beat");
  for (std::size_t row = 0; row < grid.size(); ++row) {
    for (std::size_t i = 0; i < kColumns; ++i) grid[row][i].feet = kAgainstSwing[row][i];
  }
  grid[0][4].feet = of.value("retreat.feet");
  grid[1][4].feet = of.value("retreat.half_feet");
  return grid;
}

float rounded(double x) {
  // The sum takes away the sign of a zero.
  return static_cast<float>(std::round(x * kRounding) / kRounding + 0.0);
}

}  // namespace

Triple turn_onto(const Triple& aim) {
  const double across = std::hypot(aim[1], aim[2]);
  if (across == 0) return {0, 0, 0};
  const double angle = std::atan2(across, aim[0]);
  return {0, -angle * aim[2] / across, angle * aim[1] / across};
}

Triple aim_of(const Triple& turn) {
  const double angle = std::hypot(turn[1], turn[2]);
  if (angle == 0) return {1, 0, 0};
  const double across = std::sin(angle) / angle;
  return {std::cos(angle), across * turn[2], -across * turn[1]};
}

Keys keys_from(const Knobs& knobs) {
  const Grid grid = grid_of(Stances(knobs));
  Keys keys{};
  std::size_t i = 0;
  for (const Row& row : grid) {
    for (const Stance& stance : row) {
      const Triple turn = turn_onto(stance.aim);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        keys[i].hand_F[axis] = rounded(stance.hand[axis]);
        keys[i].turn_F[axis] = rounded(turn[axis]);
      }
      keys[i].feet = rounded(stance.feet);
      ++i;
    }
  }
  return keys;
}

void print_keys(const Keys& keys, std::FILE* out) {
  constexpr std::array<const char*, kRows> kHeads = {
      "y = -1: septime, retreat in the middle, octave", "y = -0.5", "y = 0: quarte, guard, sixte",
      "y = 0.5: extensions", "y = 1: lunges high inside, low inside, low outside, high outside"};
  for (std::size_t i = 0; i < keys.size(); ++i) {
    if (i % kColumns == 0) std::fprintf(out, "    // %s\n", kHeads[i / kColumns]);
    const auto& [hand, turn, feet] = keys[i];
    std::fprintf(out, "    {{{%.4fF, %.4fF, %.4fF}}, {{%.4fF, %.4fF, %.4fF}}, %.1fF},\n",
                 double{hand[0]}, double{hand[1]}, double{hand[2]}, double{turn[0]},
                 double{turn[1]}, double{turn[2]}, double{feet});
  }
}

}  // namespace fight
