// SPDX-License-Identifier: MIT
// Asks a duel for what its scene leaves out, or for a scene that no duel can have.
#include "batuta/fencing/duel_definitions.hpp"

#ifndef OFF
#define OFF kSleep
#endif
#ifndef CALL
#define CALL steps()
#endif
#ifndef CAPSULES
#define CAPSULES 1
#endif
#ifndef SEARCH
#define SEARCH batuta::Advancement<float>
#endif

struct Drill : batuta::DuelScene<float, batuta::Advancement<float>> {
  static constexpr bool OFF = false;
  static constexpr int kCapsulesPerBody = CAPSULES;
};

void use(const batuta::Duel<float, SEARCH, Drill>& duel) {
  (void)duel.CALL;
}
