// SPDX-License-Identifier: MIT
#include "scripts.hpp"

#include <algorithm>

namespace fight {
namespace {

constexpr std::int32_t kStepUs = 1000;
constexpr double kStepSeconds = 0.001;

float on_stick(double x) {
  return static_cast<float>(std::clamp(x, -1.0, 1.0));
}

}  // namespace

Place Script::at(double time) const {
  Place place = from;
  for (const Move& move : moves) {
    if (time < move.start) break;
    const double s = std::clamp((time - move.start) / move.duration, 0.0, 1.0);
    const double share = s * s * (3 - 2 * s);
    place.x += share * (move.to.x - place.x);
    place.y += share * (move.to.y - place.y);
  }
  return place;
}

double Script::feet_at(double time) const {
  double order = 0;
  for (const FeetOrder& each : feet) {
    if (time >= each.start) order = each.order;
  }
  return order;
}

batuta::InputSample Script::sample(std::uint32_t step) const {
  const double time = step * kStepSeconds;
  const Place place = at(time);
  batuta::InputSample sample;
  sample.time = step * kStepUs;
  sample.sequence = step;
  sample.x = on_stick(place.x);
  sample.y = on_stick(place.y);
  sample.feet_y = on_stick(feet_at(time));
  return sample;
}

Place attack_place(Line line) {
  constexpr std::array<double, kLines> kAcross = {-1, -0.5, 0.5, 1};
  return {kAcross[static_cast<std::size_t>(line)], 1};
}

Place parry_place(Line line) {
  constexpr std::array<Place, kLines> kPlaces = {{{-1, 0}, {-1, -1}, {1, -1}, {1, 0}}};
  return kPlaces[static_cast<std::size_t>(line)];
}

Script on_guard(Jitter& jitter) {
  Script script;
  script.from = jitter.place({0, 0});
  return script;
}

Move lunge(Jitter& jitter, Line line, double start) {
  const double begins = jitter.start(start);
  const double lasts = jitter.duration(kLungeTime);
  return {begins, lasts, jitter.place(attack_place(line))};
}

Move parry(Jitter& jitter, Line line, const Move& attack, const Window& window) {
  const double begins = attack.at_share(jitter.between(window.from, window.to));
  const double lasts = jitter.duration(kParryTime);
  return {begins, lasts, jitter.place(parry_place(line))};
}

Move step_back(Jitter& jitter, double start) {
  const double begins = jitter.start(start);
  const double lasts = jitter.duration(kStepBackTime);
  return {begins, lasts, jitter.place(kRetreatPlace)};
}

Move recovery(Jitter& jitter, double start) {
  const double begins = jitter.start(start);
  const double lasts = jitter.duration(kRecoverTime);
  return {begins, lasts, jitter.place(kRetreatPlace)};
}

Move riposte(Jitter& jitter, Line line, double start) {
  const double begins = jitter.start(start);
  const double lasts = jitter.duration(kRiposteTime);
  return {begins, lasts, jitter.place(attack_place(line))};
}

Move flick(Jitter& jitter, const Place& to, double start) {
  const double begins = jitter.start(start);
  const double lasts = jitter.duration(kFlickTime);
  return {begins, lasts, jitter.place(to)};
}

Move thrust_after(Jitter& jitter, Line line, const Move& flick) {
  const double lasts = jitter.duration(kThrustTime);
  return {flick.end(), lasts, jitter.place(attack_place(line))};
}

}  // namespace fight
