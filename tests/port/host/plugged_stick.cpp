// SPDX-License-Identifier: MIT
// A stick of the fake kernel, plugged into the whole of batuta-duel: as its environment says it is,
// it refuses things, and on the way out it tells what was done to it.
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>

#include "fake_stick.hpp"

namespace batuta::test {
namespace {

struct PluggedStick : FakeStick {
  PluggedStick() {
    also_at("/dev/input/by-id/fake0");
    has(EV_FF, FF_CONSTANT).has(EV_FF, FF_SPRING).room_for_effects(16);
    const char* const given = std::getenv("BATUTA_TEST_STICK");
    const char* const wish = given == nullptr ? "" : given;
    if (std::strcmp(wish, "read-only") == 0) refuse_writing(EACCES);
    if (std::strcmp(wish, "no-spring") == 0) refuse_effects(EINVAL, FF_SPRING);
    if (std::strcmp(wish, "no-effects") == 0) refuse_effects(ENOSPC);
  }
  ~PluggedStick() {
    std::fprintf(stderr, "stick: opened %d times, still open %d, effects left %d, uploads %d\n",
                 openings(), open_files(), static_cast<int>(effects().size()), uploads());
    for (const ff_effect& effect : removed()) {
      std::fprintf(stderr, "stick: removed an effect of type %#x, at %d\n", unsigned{effect.type},
                   strength(effect));
    }
    std::fprintf(stderr, "stick: the strongest force was %d, spring %d\n", strongest(FF_CONSTANT),
                 strongest(FF_SPRING));
  }
};

PluggedStick stick;

}  // namespace
}  // namespace batuta::test
