// SPDX-License-Identifier: MIT
#pragma once
// Who plays the side that is not the board's own, where no host does. An application names one of
// these; what it does not name is neither stored nor called nor linked.

namespace batuta::firmware {

/// Nobody: the other fencer stands on guard until samples come over the link.
struct NoRival {
  static constexpr bool kPlays = false;
  struct Settings {};
};

}  // namespace batuta::firmware
