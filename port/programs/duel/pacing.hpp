// SPDX-License-Identifier: MIT
#pragma once
// When the next step of a bout is made: at once, as it happens, or as a viewer wants it.

#include "platforms/host/clock.hpp"
#include "programs/duel/pace.hpp"
#include "programs/duel/view/view_controls.hpp"

namespace batuta::host {

class Pacing {
 public:
  /// @param realtime  a step takes as long as what it simulates
  /// @param controls  of a viewer, or null; outlives this
  Pacing(bool realtime, ViewControls* controls);

  /// A step is over: waits until the next one is to be made.
  /// @returns false: there is none, somebody has ended the bout
  bool wait();

 private:
  bool wait_for_viewer();
  void wait_for_clock();

  bool realtime_;
  ViewControls* controls_;
  HostClock clock_;
  Pace pace_;
  int slowness_ = 1;  ///< that pace_ was made for
};

/// A bout that is over stays in sight. @returns what its viewer wants then: kQuit also for an
/// interrupt
ViewWish wait_for_wish(const ViewControls& controls);

}  // namespace batuta::host
