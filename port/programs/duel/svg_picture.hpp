// SPDX-License-Identifier: MIT
#pragma once
// A bout in one picture: from the side and from above, where the tips of the blades went (pale:
// early, dark: late), where blade met blade (a ring, larger for a harder beat), where the touch
// landed (a star), and how the fencers stood at the end; below, the same along the time. At most
// about 400 kB, however long the bout is.

#include <ostream>

#include "programs/duel/bout_drawing.hpp"
#include "programs/duel/bout_words.hpp"
#include "programs/duel/observer.hpp"

namespace batuta::host {

/// Collects while the bout goes on and draws at its end.
class SvgPicture final : public Observer {
 public:
  static constexpr int kMaxBeats = BoutStory::kMaxBeats;

  /// @param out  must outlive this; its state tells whether everything was written
  explicit SvgPicture(std::ostream& out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

 private:
  void draw_title(Canvas& canvas, const DuelRunner& runner) const;
  void draw_timeline(Canvas& canvas, const DuelRunner& runner) const;
  void draw_legend(Canvas& canvas) const;

  std::ostream& out_;
  BoutStory story_;
  TouchCursor touches_;
};

}  // namespace batuta::host
