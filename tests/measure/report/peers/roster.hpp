// SPDX-License-Identifier: MIT
#pragma once
// Who takes part: each engine's adapter gives its peers here. One that is not installed has no
// adapter, and is named with the reason instead.

#include <string>
#include <vector>

#include "peer.hpp"

// Adapters may be shared libraries with hidden symbols; these are what they show.
#define BATUTA_PEERS_SHOWN __attribute__((visibility("default")))

namespace batuta::peers {

std::vector<PeerPtr> batuta_peers();
BATUTA_PEERS_SHOWN std::vector<PeerPtr> bullet_peers();
BATUTA_PEERS_SHOWN std::vector<PeerPtr> fcl_peers();
BATUTA_PEERS_SHOWN std::vector<PeerPtr> ode_peers();

struct Roster {
  std::vector<PeerPtr> present;
  std::vector<std::string> absent;  ///< names of engines
};
Roster make_roster();

}  // namespace batuta::peers
