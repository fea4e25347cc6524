// SPDX-License-Identifier: MIT
#pragma once
// What the window of --view shows, on any canvas: the salle from the side and from above, the
// score, and for each fencer the stick with the force on it.

#include "programs/duel/view/view_controls.hpp"
#include "programs/duel/view/view_state.hpp"

namespace batuta::host {

/// Who fences, for people.
struct ViewNames {
  std::string left;
  std::string right;
};

class ViewScreen {
 public:
  static constexpr int kWidth = 1060;  ///< pixels of the canvas
  static constexpr int kHeight = 1086;
  static constexpr double kMargin = 30;
  /// Where the two views of the salle are.
  static constexpr SalleView kSide{false, {kMargin, 96}};
  static constexpr SalleView kAbove{true, {kMargin, 628}};

  explicit ViewScreen(ViewNames names) : names_(std::move(names)) {}

  /// What has happened since the last state is added to the story; another bout begins a new one.
  /// Bound: ViewState::kRecent.
  void take(const ViewState& state);
  void draw(Canvas& canvas, const ViewControls& controls) const;

  const BoutStory& story() const { return story_; }

 private:
  void draw_head(Canvas& canvas, const ViewControls& controls) const;
  void draw_foot(Canvas& canvas) const;
  void draw_stick(Canvas& canvas, fencing::Side side) const;

  ViewNames names_;
  ViewState state_;
  BoutStory story_;
};

}  // namespace batuta::host
