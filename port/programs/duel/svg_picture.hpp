// SPDX-License-Identifier: MIT
#pragma once
// A bout in one picture: from the side and from above, where the tips of the blades went (pale:
// early, dark: late), where blade met blade (a ring, larger for a harder beat), where the touch
// landed (a star), and how the fencers stood at the end; below, the same along the time. At most
// about 400 kB, however long the bout is.

#include <array>
#include <ostream>

#include "programs/duel/observer.hpp"
#include "programs/duel/svg_canvas.hpp"
#include "programs/duel/trace.hpp"

namespace batuta::host {

/// Collects while the bout goes on and draws at its end.
class SvgPicture final : public Observer {
 public:
  static constexpr int kMaxBeats = 400;

  /// @param out  must outlive this; its state tells whether everything was written
  explicit SvgPicture(std::ostream& out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

 private:
  /// From salle to pixels, one of two ways.
  struct View;
  struct Beat {
    double time = 0;
    float impulse = 0;
    Vec3<float> point_W = Vec3<float>::Zero();
  };

  void add_beat(const Beat& beat);
  void draw_title(SvgCanvas& canvas, const DuelRunner& runner) const;
  void draw_view(SvgCanvas& canvas, const DuelRunner& runner, const View& view) const;
  void draw_fencer(SvgCanvas& canvas, const DuelRunner& runner, const View& view,
                   fencing::Side side) const;
  void draw_trace(SvgCanvas& canvas, const View& view, fencing::Side side, double end) const;
  void draw_beats(SvgCanvas& canvas, const View& view) const;
  void draw_touches(SvgCanvas& canvas, const DuelRunner& runner, const View& view) const;
  void draw_timeline(SvgCanvas& canvas, const DuelRunner& runner) const;
  void draw_legend(SvgCanvas& canvas) const;

  std::ostream& out_;
  std::array<Trace, 2> tips_;
  FixedList<Beat, kMaxBeats> beats_;  ///< the hardest ones, if there are more
  std::uint32_t beats_left_out_ = 0;
};

}  // namespace batuta::host
