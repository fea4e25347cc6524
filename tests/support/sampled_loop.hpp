// SPDX-License-Identifier: MIT
#pragma once
// A sampled spring and damper closed around a simulated axis, and what is measured of it: stored
// energy and the stiffness at which it begins to grow. Double.

#include <algorithm>
#include <array>
#include <cmath>

#include "batuta/haptics/gain_advisor.hpp"
#include "shared/simulated/axis.hpp"
#include "shared/simulated/encoder.hpp"

namespace batuta::test {

using port_simulated::AxisSettings;
using port_simulated::SimulatedAxis;

/// What is closed around the axis.
struct LoopSettings {
  AxisSettings axis;
  haptics::Gains<double> gains;
  int delay = 0;            ///< whole periods, < kMostLag
  double encoder_step = 0;  ///< u
  double centre = 0;        ///< where the spring is at rest, u
};

class SampledLoop {
 public:
  static constexpr int kMostLag = 6;

  /// @pre the axis' settings are valid, the delay is below kMostLag
  explicit SampledLoop(const LoopSettings& settings) : settings_(settings) {
    const Status status = axis_.configure(settings.axis);
    BATUTA_ASSERT(status == Status::kOk);
  }

  /// At a place it has been at for ever.
  void place(double position, double velocity) {
    axis_.place(position, velocity, 0);
    places_.fill(position);
    seen_.fill(port_simulated::encoded(position, settings_.encoder_step));
    held_ = 0;
  }

  /// The force of the spring and the damper for the coming period, J/u.
  double demanded() const {
    const auto lag = static_cast<std::size_t>(settings_.delay);
    const double rate = (seen_[lag] - seen_[lag + 1]) / settings_.axis.period;
    return -settings_.gains.stiffness * (seen_[lag] - settings_.centre) -
           settings_.gains.damping * rate;
  }

  /// One period under that force, or under another one.
  void step() { step(demanded()); }
  void step(double force) {
    held_ = force;
    axis_.advance(force, axis_.hand());
    std::rotate(places_.rbegin(), places_.rbegin() + 1, places_.rend());
    std::rotate(seen_.rbegin(), seen_.rbegin() + 1, seen_.rend());
    places_[0] = axis_.position();
    seen_[0] = port_simulated::encoded(axis_.position(), settings_.encoder_step);
  }

  /// What the proof of src/haptics/gain_advisor.md shows to fall: energy of stick and hand, of the
  /// spring, and what the samples on their way can still hand out, J.
  double stored() const {
    const haptics::Gains<double>& gains = settings_.gains;
    double sum = 0;
    for (int j = 0; j < settings_.delay; ++j) {  // Bound: kMostLag
      sum += gains.stiffness * (settings_.delay - j) * way_squared(j);
    }
    for (int j = 0; j <= settings_.delay; ++j) {  // Bound: kMostLag
      sum += std::abs(gains.damping) / settings_.axis.period * way_squared(j);
    }
    const double bent = axis_.position() - settings_.centre;
    return axis_.energy() + 0.5 * (gains.stiffness * bent * bent + sum);
  }

  SimulatedAxis& axis() { return axis_; }
  const SimulatedAxis& axis() const { return axis_; }
  double held() const { return held_; }     ///< over the last period, J/u
  double seen() const { return seen_[0]; }  ///< by the encoder, u
  const LoopSettings& settings() const { return settings_; }

 private:
  double way_squared(int j) const {
    const auto i = static_cast<std::size_t>(j);
    const double way = places_[i] - places_[i + 1];
    return way * way;
  }

  LoopSettings settings_;
  SimulatedAxis axis_;
  std::array<double, kMostLag + 1> places_{};  ///< [0]: the latest
  std::array<double, kMostLag + 1> seen_{};
  double held_ = 0;
};

/// Whether a pushed loop without friction has more energy in the last quarter of its steps than in
/// the quarter before.
inline bool grows(const LoopSettings& settings, int steps) {
  SampledLoop loop(settings);
  loop.place(1, 0);
  std::array<double, 4> most{};
  for (int i = 0; i < steps; ++i) {
    loop.step();
    double& quarter = most[static_cast<std::size_t>(4LL * i / steps)];
    quarter = std::max(quarter, loop.stored());
  }
  return !(most[3] <= most[2]);
}

/// How far the stick goes, back and forth, in the last fifth of some steps, u.
inline double last_way(const LoopSettings& settings, double start, double speed, int steps) {
  SampledLoop loop(settings);
  loop.place(start, speed);
  double way = 0;
  for (int i = 0; i < steps; ++i) {
    const double before = loop.axis().position();
    loop.step();
    if (i >= steps / 5 * 4) way += std::abs(loop.axis().position() - before);
  }
  return way;
}

/// Where a property of a stiffness begins, by bisection between a K that does not have it and one
/// that has. @pre has(high) and not has(low)
template <class Has>
double onset(double low, double high, const Has& has) {
  constexpr int kHalvings = 14;  // to 1e-4 of the span
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (low + high);
    (has(middle) ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

}  // namespace batuta::test
