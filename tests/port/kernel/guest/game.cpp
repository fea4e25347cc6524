// SPDX-License-Identifier: MIT
// What a game sees and does beside: what there is, changes, gain, a full pool, the end, the plug.

#include <cerrno>

#include "checks.hpp"
#include "effects.hpp"
#include "truth.hpp"

namespace guest {
namespace {

constexpr int kBlocks = 16;

}  // namespace

void capabilities(Checks& checks) {
  checks.begin("capabilities");
  const Stick& stick = checks.stick;
  checks.number("its name", 1, stick.name() == "batuta batuta force feedback stick" ? 1 : 0);
  checks.number("effects at the same time", kBlocks, stick.effects());
  const std::pair<const char*, int> those[] = {
      {"constant", FF_CONSTANT}, {"ramp", FF_RAMP},         {"periodic", FF_PERIODIC},
      {"sine", FF_SINE},         {"square", FF_SQUARE},     {"triangle", FF_TRIANGLE},
      {"saw up", FF_SAW_UP},     {"saw down", FF_SAW_DOWN}, {"spring", FF_SPRING},
      {"damper", FF_DAMPER},     {"friction", FF_FRICTION}, {"inertia", FF_INERTIA},
      {"rumble", FF_RUMBLE},     {"gain", FF_GAIN}};
  for (const auto& [name, code] : those) checks.number(name, 1, stick.has(EV_FF, code) ? 1 : 0);
  checks.number("no autocentre", 0, stick.has(EV_FF, FF_AUTOCENTER) ? 1 : 0);
  checks.number("no custom force", 0, stick.has(EV_FF, FF_CUSTOM) ? 1 : 0);
}

void position(Checks& checks) {
  checks.begin("position");
  Movement movement;
  movement.from = {0.5, 0.25};
  movement.buttons = 0x8001;
  const Stick& stick = checks.stick;
  // One report at a time: the host takes it when it likes.
  for (int turn = 0; turn < 10000 && stick.axis(ABS_X) != 16384; ++turn) {
    checks.line.move(1, movement);
  }
  checks.number("right", 16384, stick.axis(ABS_X));
  checks.number("up", -8192, stick.axis(ABS_Y));
  checks.number("first button", 1, stick.pressed(BTN_TRIGGER) ? 1 : 0);
  checks.number("second button", 0, stick.pressed(BTN_THUMB) ? 1 : 0);
  checks.number("sixteenth button", 1, stick.pressed(BTN_DEAD) ? 1 : 0);
}

void changes(Checks& checks) {
  checks.begin("change");
  ff_effect e = constant(0x2000, kRight, 1000);
  checks.start(e);
  checks.later("before", 99, pointing(level(0x2000), kRight));
  const auto change = [&](const char* what, const Force& wanted) {
    checks.number(std::string(what) + " taken", 0, checks.stick.upload(e));
    checks.stick.settle();
    checks.later(what, 100, wanted);
  };
  e.u.constant.level = -0x5000;
  change("size", pointing(level(-0x5000), kRight));
  e.direction = kUp;
  change("direction", pointing(level(-0x5000), kUp));
  e.u.constant.envelope.fade_length = 1000;
  change("envelope", pointing(0.601 * level(-0x5000), kUp));
  e.replay.length = 400;
  e.u.constant.envelope.fade_length = 0;
  change("length", {});
  checks.end(e);
  ff_effect wave_ = periodic(FF_SINE, 0x2000, kLeft, 400);
  checks.start(wave_);
  checks.later("wave before", 300, pointing(level(0x2000) * wave(FF_SINE, 0.75), kLeft));
  wave_.u.periodic.magnitude = 0x6000;
  checks.number("wave taken", 0, checks.stick.upload(wave_));
  checks.stick.settle();
  checks.later("wave goes on", 50, pointing(level(0x6000) * wave(FF_SINE, 0.875), kLeft));
  checks.end(wave_);
}

void gain(Checks& checks) {
  checks.begin("gain");
  for (const unsigned direction : {kRight, kUp}) {
    ff_effect e = constant(0x6000, direction);
    checks.start(e);
    for (const auto& [name, value] :
         {std::pair("two fifths", 0x6666U), std::pair("none", 0U), std::pair("all", 0xFFFFU)}) {
      checks.stick.gain(value);
      checks.later(name, 1, pointing(level(0x6000) * value / 65535.0, direction));
    }
    checks.end(e);
  }
}

/// The kernel makes a sine of it: drivers/input/ff-core.c; a third of the strong motor and a sixth
/// of the weak one, 50 ms, down.
void rumble(Checks& checks) {
  checks.begin("rumble");
  ff_effect e = effect(FF_RUMBLE, kDown);
  e.u.rumble = {0x9000, 0x6000};
  checks.start(e);
  checks.later("a fifth of its period", 10,
               pointing(level(0x9000 / 3 + 0x6000 / 6) * wave(FF_SINE, 0.2), kDown));
  checks.end(e);
}

void together(Checks& checks) {
  checks.begin("together");
  ff_effect one = constant(0x3000, kRight);
  ff_effect other = constant(0x2000, kUp);
  ff_effect third = constant(0x7000, kRight);
  checks.start(one);
  checks.start(other);
  checks.later("two", 1, {level(0x3000), level(0x2000)});
  checks.start(third);
  checks.later("no more than all", 1, {1, level(0x2000)});
  checks.number("three play", 3, checks.line.look().playing);
  checks.number("stopped", 0, checks.stick.stop(one.id));
  checks.stick.settle();
  checks.later("two of three", 1, {level(0x7000), level(0x2000)});
  checks.number("erased", 0, checks.stick.erase(one.id));
  checks.number("erased", 0, checks.stick.erase(third.id));
  checks.stick.settle();
  checks.later("the other one", 1, {0, level(0x2000)});
  checks.end(other);
}

void pool(Checks& checks) {
  checks.begin("pool");
  ff_effect all[kBlocks];
  int taken = 0;
  for (ff_effect& e : all) {
    e = constant(0x0600, kLeft);
    if (checks.stick.upload(e) == 0 && checks.stick.play(e.id, 1) == 0) ++taken;
  }
  checks.number("taken", kBlocks, taken);
  checks.stick.settle();
  checks.later("all of them", 1, pointing(kBlocks * 0.0468, kLeft));  // 0x0600 in whole steps
  ff_effect more = constant(0x4000, kUp);
  checks.number("one too many: ENOSPC", ENOSPC, checks.stick.upload(more));
  checks.later("as before", 1, pointing(kBlocks * 0.0468, kLeft));
  checks.number("erased", 0, checks.stick.erase(all[5].id));
  checks.stick.settle();  // the driver sends what frees a block and what asks for one by two ways
  checks.start(more);
  checks.later("room for another one", 1, {-(kBlocks - 1) * 0.0468, level(0x4000)});
  for (const ff_effect& e : all) {
    if (&e != &all[5]) taken -= checks.stick.erase(e.id) == 0 ? 1 : 0;
  }
  checks.number("erased", 1, taken);
  checks.end(more);
}

/// A program that ends takes its effects with it.
void leaving(Checks& checks) {
  checks.begin("end of a program");
  {
    Stick stick(checks.line);
    ff_effect e = constant(0x6000, kRight);
    checks.number("taken", 0, stick.upload(e));
    checks.number("plays", 0, stick.play(e.id, 1));
    stick.settle();
    checks.later("before it", 2, {level(0x6000), 0});
  }
  checks.stick.settle();
  checks.later("after it", 1, {});
  checks.number("none plays", 0, checks.line.look().playing);
}

void unplugging(Checks& checks) {
  checks.begin("plug");
  ff_effect e = constant(0x6000, kRight);
  {
    Stick stick(checks.line);
    checks.number("taken", 0, stick.upload(e));
    checks.number("plays", 0, stick.play(e.id, 1));
    stick.settle();
    checks.later("before", 2, {level(0x6000), 0});
    checks.line.unplug();
    checks.force("at once", {}, checks.line.look().force);
    checks.later("unplugged", 100, {});
    int error = 0;
    for (int turn = 0; turn < 10000 && error == 0; ++turn) {
      checks.line.look();
      error = stick.play(e.id, 1);
    }
    checks.number("ENODEV", ENODEV, error);
  }
  checks.line.plug();
  Stick again(checks.line);
  Checks anew(checks.line, again);
  anew.begin("plug");
  again.settle();
  anew.later("plugged in again", 100, {});
  anew.number("effects", kBlocks, again.effects());
  e.id = -1;
  anew.start(e);
  anew.later("plays again", 1, {level(0x6000), 0});
  anew.end(e);
  pool(anew);
}

}  // namespace guest
