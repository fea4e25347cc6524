// SPDX-License-Identifier: MIT
// What a game sends once and leaves alone: constant, ramp, waves, their envelopes and times.

#include "checks.hpp"
#include "effects.hpp"
#include "truth.hpp"

namespace guest {

void directions(Checks& checks) {
  checks.begin("constant");
  const char* const names[] = {"down", "down left", "left",  "up left",
                               "up",   "up right",  "right", "down right"};
  for (int i = 0; i < 8; ++i) {
    ff_effect e = constant(0x6000, i * 0x2000U);
    checks.start(e);
    checks.later(names[i], 1, pointing(level(0x6000), e.direction));
    checks.end(e);
  }
  ff_effect e = constant(-0x3000, kRight);
  checks.start(e);
  checks.later("right, negative", 1, pointing(level(-0x3000), kRight));
  checks.number("stopped", 0, checks.stick.stop(e.id));
  checks.stick.settle();
  checks.later("after the stop", 1, {});
  checks.end(e);
}

void ramp(Checks& checks) {
  checks.begin("ramp");
  const double from = level(-0x4000);
  const double way = level(0x6000) - from;
  for (const unsigned direction : {kLeft, kUp}) {
    ff_effect e = effect(FF_RAMP, direction, 1000);
    e.u.ramp.start_level = -0x4000;
    e.u.ramp.end_level = 0x6000;
    checks.start(e);
    checks.later("after 1 ms", 1, pointing(from + 0.001 * way, direction));
    checks.later("after 250 ms", 249, pointing(from + 0.25 * way, direction));
    checks.later("after 900 ms", 650, pointing(from + 0.9 * way, direction));
    checks.later("after 1000 ms", 100, {});
    checks.end(e);
  }
}

void waves(Checks& checks) {
  const std::pair<const char*, int> kinds[] = {{"sine", FF_SINE},
                                               {"square", FF_SQUARE},
                                               {"triangle", FF_TRIANGLE},
                                               {"saw up", FF_SAW_UP},
                                               {"saw down", FF_SAW_DOWN}};
  for (const auto& [name, waveform] : kinds) {
    checks.begin(name);
    ff_effect e = periodic(waveform, 0x5000, kRight, 400);
    e.u.periodic.offset = 0x1000;
    checks.start(e);
    int before = 0;
    for (const int at : {50, 130, 250, 390, 450}) {
      const double size = level(0x1000) + level(0x5000) * wave(waveform, at / 400.0);
      checks.later("after " + std::to_string(at) + " ms", at - before, pointing(size, kRight));
      before = at;
    }
    checks.end(e);
    ff_effect late = periodic(waveform, 0x5000, kUp, 400);
    late.u.periodic.phase = 0x2000;
    checks.start(late);
    checks.later("an eighth ahead", 100,
                 pointing(level(0x5000) * wave(waveform, 0.125 + 0.25), kUp));
    checks.end(late);
  }
}

void envelope(Checks& checks) {
  checks.begin("envelope");
  for (const unsigned direction : {kRight, kDown}) {
    for (const int size : {0x6000, -0x6000}) {
      ff_effect e = constant(size, direction, 1000);
      e.u.constant.envelope = {200, 0x2000, 400, 0x1000};
      const double sign = size > 0 ? 1 : -1;
      checks.start(e);
      checks.later("half of the attack", 100, pointing(sign * level(0x4000), direction));
      checks.later("between", 300, pointing(sign * level(0x6000), direction));
      checks.later("half of the fade", 400, pointing(sign * level(0x3800), direction));
      checks.later("over", 200, {});
      checks.end(e);
    }
  }
}

void times(Checks& checks) {
  checks.begin("times");
  ff_effect e = constant(0x4000, kUp, 200);
  e.replay.delay = 100;
  checks.start(e, 3);
  const Force full = pointing(level(0x4000), kUp);
  checks.later("in the delay", 99, {});
  checks.later("behind the delay", 2, full);
  checks.later("the second time", 250, full);
  checks.later("the third time", 348, full);
  checks.later("three times are over", 1, {});
  checks.number("none plays", 0, checks.line.look().playing);
  checks.end(e);
  ff_effect long_one = constant(0x4000, kUp);
  checks.start(long_one);
  checks.later("without end, after a minute", 60000, full);
  checks.end(long_one);
}

}  // namespace guest
