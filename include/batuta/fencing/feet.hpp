// SPDX-License-Identifier: MIT
#pragma once
// Where a fencer's feet have carried him on the strip: forward and back at bounded speeds, with a
// bounded acceleration, and never so fast that he could not stop before the end of the strip, or
// before an opponent who stops as soon as he can. The way is continuous with its velocity.
// Mathematics: src/fencing/feet.md. Along the strip, from where the fencer began; SI units.

#include <array>

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta::fencing {

/// Largest speed of feet, m/s.
template <class Scalar>
inline constexpr Scalar kFastestFeet = Scalar(100);
/// Least acceleration of feet, m/s^2.
template <class Scalar>
inline constexpr Scalar kLeastPush = Scalar(0.01F);
/// Largest acceleration of feet, m/s^2.
template <class Scalar>
inline constexpr Scalar kLargestPush = Scalar(10000);

/// How feet move.
template <class Scalar>
struct FeetSettings {
  Scalar forward_speed = Scalar(1.5F);   ///< of an advance, m/s, > 0, <= kFastestFeet
  Scalar backward_speed = Scalar(1.8F);  ///< of a retreat, m/s, > 0, <= kFastestFeet
  Scalar acceleration = Scalar(14);  ///< most, to either side, m/s^2, kLeastPush ... kLargestPush
};

/// @returns kOk | kInvalidArgument: out of range
template <class Scalar>
Status validate(const FeetSettings<Scalar>& settings);

/// How far feet may still go, m; less than zero counts as zero.
template <class Scalar>
struct FeetRoom {
  Scalar forward = 0;   ///< to where they have to stand at the latest
  Scalar backward = 0;  ///< the same, behind
};

/// One fencer's feet. Whoever moves them keeps the settings. Allocates: never.
template <class Scalar>
class Feet {
 public:
  /// Back to where the fencer began, still.
  void stand() { *this = Feet(); }

  /// Moves on by one step.
  /// @param order  -1 ... 1: share of the speed backward or forward
  /// @param room   at the start of the step; a way to stop in it is kept
  /// @pre valid settings, the same in each step; finite; -1 <= order <= 1; dt > 0, s
  void advance(const FeetSettings<Scalar>& settings, Scalar order, const FeetRoom<Scalar>& room,
               Scalar dt);

  /// How far forward they are from where they began, m.
  Scalar way() const { return way_; }
  /// Forward, m/s.
  Scalar velocity() const { return velocity_; }
  /// What they still need forward to stand, m. @pre valid
  Scalar stopping_way(const FeetSettings<Scalar>& settings) const;
  /// Whether they are no faster than they may. @pre valid
  bool is_within(const FeetSettings<Scalar>& settings) const;

  /// Its state, for record/archive.hpp.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    auto& [way, velocity] = *this;
    ar(way, velocity);
  }

 private:
  Scalar way_ = 0;
  Scalar velocity_ = 0;
};

/// The feet of both fencers, by index_of(side).
template <class Scalar>
using BothFeet = std::array<Feet<Scalar>, 2>;

/// The room of two fencers who face each other, by index_of(side). What lies between them is
/// theirs in halves, beyond what either needs to stop.
/// @param between  from the one to the other, without what has to stay between them, m
/// @param behind   of each, m
/// @pre valid; finite
/// Bound: no loop.
template <class Scalar>
std::array<FeetRoom<Scalar>, 2> rooms_of(const BothFeet<Scalar>& feet,
                                         const FeetSettings<Scalar>& settings, Scalar between,
                                         const Vec2<Scalar>& behind);

}  // namespace batuta::fencing
