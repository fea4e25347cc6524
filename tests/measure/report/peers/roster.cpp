// SPDX-License-Identifier: MIT
#include "roster.hpp"

#include <iterator>

namespace batuta::peers {

namespace {

void append(std::vector<PeerPtr>& all, std::vector<PeerPtr> more) {
  all.insert(all.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

}  // namespace

Roster make_roster() {
  Roster roster;
  append(roster.present, batuta_peers());
#ifdef BATUTA_PEERS_BULLET
  append(roster.present, bullet_peers());
#else
  roster.absent.emplace_back("bullet");
#endif
#ifdef BATUTA_PEERS_FCL
  append(roster.present, fcl_peers());
#else
  roster.absent.emplace_back("fcl");
#endif
#ifdef BATUTA_PEERS_ODE
  append(roster.present, ode_peers());
#else
  roster.absent.emplace_back("ode");
#endif
  return roster;
}

}  // namespace batuta::peers
