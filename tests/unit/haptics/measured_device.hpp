// SPDX-License-Identifier: MIT
#pragma once
// A simulated axis that is measured, with all that a real one may do wrong on the way.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "batuta/haptics/device_measurement.hpp"
#include "draws.hpp"
#include "shared/simulated/axis.hpp"
#include "shared/simulated/encoder.hpp"

namespace batuta::test {

/// What is measured, in the units of gain_advisor.hpp.
struct MeasuredDevice {
  double period = 1e-3;
  double told_period = 0;  ///< MeasurementSettings::period, where not `period`
  double mass = 0.03;
  double damping = 0.2;
  double friction = 0.2;
  double force_limit = 10;
  double encoder_step = 0.5e-3;
  double delay = 2;            ///< periods; where not whole, in parts of 1 / kParts
  double jitter = 0;           ///< of a sample's time, share of a period
  double lost = 0;             ///< share of the samples
  double play = 0;             ///< between motor and encoder, u
  double stiffness = 0;        ///< of a spring, or of a hand
  double known_stiffness = 0;  ///< of what may be a spring: MeasurementSettings
  double weight = 0;           ///< J/u, always
  double cogging = 0;          ///< J/u: of a force that depends on the place
  double let_through = 1;      ///< share of what is asked that the device is told
  double drag = 0;             ///< J s^2/u^3: of a force that goes with the square of the speed
  double saturation = 0;       ///< force tanh(saturation u) / saturation of a share u; 0: force u
  double lag = 0;              ///< periods: time constant of the motor's force
  double bent = 0;             ///< u: encoder shows q + bent sin(kBends q)
  double extra = 0;            ///< of friction at rest beyond that in motion: Stribeck's
  double extra_speed = 0.05;   ///< u/s: by exp(-(v / this)^2)
  double stray = 0;            ///< share of the samples that are off the encoder's grid
  int stray_at = -1;           ///< period of one that is
  double held_stiffness = 0;   ///< of a hand that holds it at 0 from period held_from to held_to
  double held_damping = 0;     ///< likewise
  int held_from = 0;
  int held_to = 1 << 30;
};

/// One that may be drawn: masses over a factor of 30, friction of a thousandth to a fifth of the
/// motor, encoders of 400 to 100 000 steps.
inline MeasuredDevice any_device(std::uint64_t index) {
  Draws draws(51, 0, index);
  const auto any = [&draws](double low, double high) {
    return low * std::exp(draws.unit() * std::log(high / low));
  };
  MeasuredDevice device;
  device.force_limit = any(2, 40);
  device.mass = any(0.003, 0.1);
  device.damping = any(0.01, 1);
  device.friction = device.force_limit * any(0.003, 0.2);
  device.encoder_step = any(2e-5, 5e-3);
  device.delay = static_cast<int>(draws.between(0, 9));
  if (draws.chance(0.1)) device.damping = 0;
  if (draws.chance(0.1)) device.friction = 0;
  if (draws.chance(0.1)) device.encoder_step = 0;
  return device;
}

class Measuring {
 public:
  static constexpr int kMostDelay = 64;
  static constexpr double kCogs = 25;  ///< rad/u
  static constexpr double kBends = 25;
  static constexpr int kParts = 8;  ///< of a period, where the device needs them

  explicit Measuring(const MeasuredDevice& device, std::uint64_t seed = 1)
      : device_(device), draws_(52, 0, seed) {
    const bool is_plain = device.delay == std::floor(device.delay) && device.drag == 0 &&
                          device.lag == 0 && device.extra == 0 && device.held_stiffness == 0 &&
                          device.held_damping == 0;
    parts_ = is_plain ? 1 : kParts;
    port_simulated::AxisSettings axis;
    axis.period = device.period / parts_;
    axis.mass = device.mass;
    axis.damping = device.damping;
    axis.friction = device.friction + device.extra;
    axis.hand_stiffness = device.stiffness;
    axis.travel = 1;
    EXPECT_EQ(axis_.configure(axis), Status::kOk);
    settings.period =
        static_cast<float>(device.told_period > 0 ? device.told_period : device.period);
    settings.force_limit = static_cast<float>(device.force_limit);
    settings.most_stiffness = static_cast<float>(device.known_stiffness);
    shift_ = device.encoder_step * draws_.between(-0.5, 0.5);
    EXPECT_EQ(measurement.configure(settings), Status::kOk);
  }

  /// To the end. @returns how it ended
  haptics::MeasurementState run() {
    while (measurement.state() == haptics::MeasurementState::kRunning) step(0);
    return measurement.state();
  }

  /// A period. @param hand  where a hand wants the stick, if there is one
  void step(double hand) {
    const double late = device_.jitter * draws_.between(-1, 1) * device_.period;
    haptics::MeasurementInput input;
    input.fresh = !draws_.chance(device_.lost);
    input.time = first_time + static_cast<Microseconds>(std::lround(1e6 * (time_ + late)));
    input.position = seen(axis_.position() + late * axis_.velocity());
    input.applied = told_;
    const float asked = measurement.step(input);
    told_ = asked * static_cast<float>(device_.let_through);
    largest_share = std::max(largest_share, std::abs(asked));
    std::rotate(sent_.rbegin(), sent_.rbegin() + 1, sent_.rend());
    sent_[0] = device_.force_limit * static_cast<double>(told_);
    for (int i = 0; i < parts_; ++i) {
      const double since = static_cast<double>(i) / parts_;
      const auto age = static_cast<std::size_t>(std::ceil(device_.delay - since));
      axis_.advance(motor(sent_[age]) + rest_of_forces(), hand);
    }
    ++periods_;
    farthest = std::max(farthest, std::abs(axis_.position()));
    time_ += device_.period;
  }

  /// Where the stick is in truth, u.
  double position() const { return axis_.position(); }

  haptics::MeasurementSettings settings;
  haptics::DeviceMeasurement measurement;
  Microseconds first_time = 0;  ///< to be set before the first step
  float largest_share = 0;      ///< asked for
  double farthest = 0;          ///< from the centre, where the stick was in truth

 private:
  /// What the motor makes of a force.
  double motor(double force) {
    const double share = device_.saturation * force / device_.force_limit;
    if (share != 0) force *= std::tanh(share) / share;
    if (device_.lag > 0) lagging_ += (force - lagging_) * -std::expm1(-1 / device_.lag / parts_);
    return device_.lag > 0 ? lagging_ : force;
  }

  double rest_of_forces() const {
    const double v = axis_.velocity();
    const double slow = v / device_.extra_speed;
    const double way = v < 0 ? -1 : 1;
    const double less = -device_.extra * std::expm1(-slow * slow) * way;  // friction at speed
    const bool is_held = periods_ >= device_.held_from && periods_ < device_.held_to;
    const double hand =
        is_held ? -device_.held_stiffness * axis_.position() - device_.held_damping * v : 0;
    return device_.weight + device_.cogging * std::sin(kCogs * axis_.position()) -
           device_.drag * v * std::abs(v) + less + hand;
  }

  float seen(double position) {
    position += device_.bent * std::sin(kBends * position);
    const bool is_stray = draws_.chance(device_.stray) || periods_ == device_.stray_at;
    const double off = is_stray ? device_.encoder_step * draws_.between(-0.5, 0.5) : 0;
    linked_ = clamp(linked_, position - device_.play / 2, position + device_.play / 2);
    return static_cast<float>(off +
                              port_simulated::encoded(linked_ + shift_, device_.encoder_step));
  }

  MeasuredDevice device_;
  port_simulated::SimulatedAxis axis_;
  Draws draws_;
  std::array<double, kMostDelay> sent_{};  ///< [0]: the latest
  double time_ = 0;
  double lagging_ = 0;  ///< force of the motor
  int parts_ = 1;       ///< of a period
  int periods_ = 0;
  double shift_ = 0;   ///< of the encoder's grid
  double linked_ = 0;  ///< what the encoder sits on
  float told_ = 0;
};

}  // namespace batuta::test
