// SPDX-License-Identifier: MIT
#pragma once
// Who wants to know how a bout goes: logs, picture, progress bar.

#include "programs/duel/duel_runner.hpp"

namespace batuta::host {

class Observer {
 public:
  Observer() = default;
  Observer(const Observer&) = delete;
  Observer& operator=(const Observer&) = delete;
  virtual ~Observer() = default;

  /// The fencers are on guard.
  virtual void on_start(const DuelRunner& runner) = 0;
  /// A step is over. Allocates nothing.
  virtual void on_step(const DuelRunner& runner) = 0;
  /// The bout is over.
  virtual void on_end(const DuelRunner& runner) = 0;
};

}  // namespace batuta::host
