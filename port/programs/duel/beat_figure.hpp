// SPDX-License-Identifier: MIT
#pragma once
// The hardest beat of a bout as [Kavan fig. 6] shows one: the weapons before the contact, at it and
// after it, with their velocities as arrows; from the side and from above. Velocities are those of
// the step before the beat and of the step after it, by differences of the blades' places.

#include <array>
#include <ostream>

#include "programs/duel/bout_drawing.hpp"
#include "programs/duel/observer.hpp"

namespace batuta::host {

/// Both blades at an instant, or how fast the ends of their axes move.
struct BladeEnds {
  std::array<Vec3<float>, 2> guard = {Vec3<float>::Zero(), Vec3<float>::Zero()};  ///< by side
  std::array<Vec3<float>, 2> tip = {Vec3<float>::Zero(), Vec3<float>::Zero()};
};

/// A beat with what was before and after it.
struct SeenBeat {
  bool found = false;
  Beat beat;
  Vec3<float> normal_W = Vec3<float>::Zero();  ///< out of the right blade
  float v_rel = 0;                             ///< along the normal, before, m/s
  BladeEnds earlier;                           ///< BeatFigure::kLead steps before the contact, m
  BladeEnds before;                            ///< at the end of the step before, m
  BladeEnds contact;                           ///< m
  BladeEnds after;                             ///< at the end of the step of the beat, m
  BladeEnds later;                             ///< kLead steps after it, or when the bout ended, m
  BladeEnds v_before;                          ///< m/s
  BladeEnds v_after;                           ///< m/s
  int age = 0;                                 ///< steps since; 0: nothing is known of after
};

/// Looks for it while the bout goes on and draws it at the end.
class BeatFigure final : public Observer {
 public:
  static constexpr int kLead = 25;             ///< steps
  static constexpr double kScale = 200;        ///< pixels a metre
  static constexpr double kArrowScale = 40;    ///< pixels for 1 m/s, where that leaves arrows short
  static constexpr double kLongest = 140;      ///< of an arrow, pixels: half a panel
  static constexpr int kArrows = 5;            ///< of a blade: guard, ..., tip
  static constexpr Pixel kPanel = {400, 280};  ///< pixels
  static constexpr Pixel kFirstPanel = {20, 90};
  static constexpr Pixel kPanelStep = {420, 320};  ///< to the next column, the next row

  /// @param out  must outlive this; its state tells whether everything was written
  explicit BeatFigure(std::ostream& out) : out_(out) {}

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  void on_end(const DuelRunner& runner) override;

  /// The hardest one of which the step after is known.
  const SeenBeat& hardest() const { return hardest_.age > 0 ? hardest_ : harder_before_; }

 private:
  const BladeEnds& ends_at(std::uint32_t step) const { return ends_[step % ends_.size()]; }
  void see(const DuelRunner& runner, const ContactEvent<float>& event);
  void follow(std::uint32_t step);

  std::ostream& out_;
  std::array<BladeEnds, kLead + 2> ends_{};  ///< after step i at i modulo its size
  float dt_ = 0;                             ///< s
  SeenBeat hardest_;
  SeenBeat harder_before_;  ///< the last one of which the step after was known
};

}  // namespace batuta::host
