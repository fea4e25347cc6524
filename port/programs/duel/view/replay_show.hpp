// SPDX-License-Identifier: MIT
#pragma once
// A recorded bout in the window of --view.

#include "programs/duel/replay.hpp"
#include "programs/duel/view/view.hpp"

namespace batuta::host {

/// Goes through a recorded bout as it happened, as often as the viewer wants.
/// @returns what became of it the last time
Replay show_replay(const std::string& path, View& view, ViewFeed& feed);

}  // namespace batuta::host
