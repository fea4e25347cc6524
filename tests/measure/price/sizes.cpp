// SPDX-License-Identifier: MIT
// Sizes as sizes of symbols, so that they can be read without running anything. Never linked.

#include "batuta/fencing/duel.hpp"
#include "batuta/world/scenes.hpp"

#ifdef BATUTA_PRICE_FIRMWARE
#include "platforms/mps2/uart.hpp"
#include "shared/firmware/application.hpp"
#endif

namespace {

using namespace batuta;
using namespace batuta::fencing;

}  // namespace

extern "C" {
char price_sizeof_Capsule[sizeof(Capsule<float>)];
char price_sizeof_Body[sizeof(Body<float>)];
char price_sizeof_MovingPair[sizeof(MovingPair<float>)];
char price_sizeof_SearchResult[sizeof(SearchResult<float>)];
char price_sizeof_World_of_two_capsules[sizeof(World<TwoBlades>)];
char price_sizeof_World_of_the_duel[sizeof(World<Duel<>::SceneType>)];
char price_sizeof_Duel[sizeof(Duel<>)];

#ifdef BATUTA_PRICE_FIRMWARE
// What the firmware keeps for bytes on their way in and out: as large as an application wants.
char price_sizeof_buffers[mps2::Uart::kReceiveCapacity + mps2::Uart::kTransmitCapacity +
                          firmware::Application::kSendBytes];
#endif
}
