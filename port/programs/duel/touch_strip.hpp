// SPDX-License-Identifier: MIT
#pragma once
// How the last touch of a bout came about: both fencers in a strip of pictures, from the side, at
// equal times before it.

#include <array>
#include <optional>
#include <ostream>

#include "programs/duel/bout_drawing.hpp"
#include "programs/duel/bout_words.hpp"
#include "programs/duel/observer.hpp"

namespace batuta::host {

/// Keeps the latest postures while the bout goes on, and draws at the end.
class TouchStrip final : public Observer {
 public:
  static constexpr int kPictures = 6;           ///< the last one at the touch
  static constexpr int kSpacing = 60;           ///< steps between two pictures
  static constexpr double kReach = 1.95;        ///< of a picture, to either side, m
  static constexpr double kWidth = 400;         ///< of a picture, pixels
  static constexpr Pixel kFirst = {20, 70};     ///< its upper left corner
  static constexpr Pixel kToNext = {420, 240};  ///< to the next column, the next row
  static constexpr int kColumns = 3;

  /// @param out  must outlive this; its state tells whether everything was written
  explicit TouchStrip(std::ostream& out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

  /// Where picture i is. @pre 0 <= i < kPictures
  static SalleView view_of(int i, double middle);

 private:
  /// The latest ones, a step apart; the last touch is at the end of its way through them.
  static constexpr std::size_t kKept = (kPictures - 1) * kSpacing + 1;

  std::ostream& out_;
  std::array<Postures, kKept> latest_{};  ///< after step i at i modulo kKept
  TouchCursor touches_;
  std::optional<TouchMark> touch_;
  std::array<Postures, kPictures> pictures_{};
};

}  // namespace batuta::host
