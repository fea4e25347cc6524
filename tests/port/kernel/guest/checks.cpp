// SPDX-License-Identifier: MIT

#include "checks.hpp"

#include <cmath>
#include <cstdio>

namespace guest {

void Checks::force(const std::string& what, const Force& wanted, const Force& is) const {
  const bool good = std::fabs(is.x - wanted.x) <= kStep && std::fabs(is.y - wanted.y) <= kStep;
  std::printf("%s %s: %s: %.4f %.4f: %.4f %.4f\n", good ? "ok" : "WRONG", group_, what.c_str(),
              wanted.x, wanted.y, is.x, is.y);
}

void Checks::number(const std::string& what, long wanted, long is) const {
  std::printf("%s %s: %s: %ld: %ld\n", wanted == is ? "ok" : "WRONG", group_, what.c_str(), wanted,
              is);
}

void Checks::start(ff_effect& effect, int times) {
  const int error = stick.upload(effect);
  if (error != 0) give_up(("an effect is not taken: error " + std::to_string(error)).c_str());
  if (stick.play(effect.id, times) != 0) give_up("an effect does not play");
  stick.settle();
  line.move(1, {});
}

void Checks::end(const ff_effect& effect) {
  number("erased", 0, stick.erase(effect.id));
  stick.settle();
  force("after it", {}, line.move(1, {}).force);
}

void Checks::later(const std::string& what, int milliseconds, const Force& wanted) {
  force(what, wanted, line.move(milliseconds, {}).force);
}

}  // namespace guest
