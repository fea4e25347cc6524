// SPDX-License-Identifier: MIT
#pragma once
// The salle from the side and from above, as every picture of a bout shows it: how the fencers
// stand, where the tips of their blades went (pale: early, dark: late), where blade met blade (a
// ring, larger for a harder beat), where a touch landed (a star).

#include <array>

#include "programs/duel/bout_story.hpp"
#include "programs/duel/canvas.hpp"

namespace batuta::host {

struct Palette {
  Colour early;
  Colour late;
  Colour body;
};
const Palette& palette(fencing::Side side);

inline constexpr Colour kGrey = {120, 120, 120};
inline constexpr Colour kBeat = {20, 130, 60};
inline constexpr Colour kTouch = {215, 0, 30};

/// How both fencers stand.
struct Postures {
  std::array<fencing::BodyShape<float>, 2> body_W{};
  std::array<Capsule<float>, 2> blade_W{};
  double time = 0;    ///< s since the start of the bout
  double middle = 0;  ///< x of the salle midway between where both stand, m
};
Postures postures_of(const DuelRunner::DuelType& duel);
/// Far enough to either side of their middle for both with their blades, m; SalleView::kReach at
/// least.
double reach_of(const Postures& postures);

/// From salle to pixels, one of two ways.
struct SalleView {
  static constexpr double kReach = 2.0;     ///< m, what `reach` is where nothing else is asked
  static constexpr double kTallest = 2.0;   ///< m, at that reach
  static constexpr double kBroadest = 0.7;  ///< to either side of the middle line, m, the same
  static constexpr double kWidth = 1000;    ///< pixels, what `width` is where nothing else is asked

  bool from_above = false;
  Pixel corner;           ///< upper left
  double middle = 0;      ///< x of the salle in the middle of the view, m
  double reach = kReach;  ///< of the salle to either side of it, m, > 0
  double width = kWidth;  ///< pixels

  /// Pixels a metre.
  double scale() const { return width / (2 * reach); }
  /// Whatever the reach is.
  Pixel size() const {
    return {width, (from_above ? 2 * kBroadest : kTallest) * width / (2 * kReach)};
  }
  Pixel at(const Vec3<float>& p_W) const;
};

/// A ring's area goes with the impulse.
double ring_radius(float impulse);

/// Both bodies and both blades.
void draw_fencers(Canvas& canvas, const SalleView& view, const Postures& postures);
/// The box of a view, with a line at each metre of the strip, and a dark one at its ends.
void draw_strip(Canvas& canvas, const SalleView& view);

void draw_salle(Canvas& canvas, const SalleView& view, const Postures& postures,
                const BoutStory& story);

}  // namespace batuta::host
