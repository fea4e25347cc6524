// SPDX-License-Identifier: MIT
#pragma once
// A stick of two simulated axes as a port: what a real one is to the library, with encoders, a held
// force, a delay and a hand. Time is simulated as well: advance() makes it pass.

#include "batuta/port/force.hpp"
#include "batuta/port/input.hpp"
#include "shared/simulated/axis.hpp"

namespace batuta::port_simulated {

/// Most whole periods from a command until its force is held.
inline constexpr int kMostDelay = 16;

struct StickSettings {
  AxisSettings x;                  ///< its coordinate is the sample's: centre 0, rim +-1, so u = 1
  AxisSettings y;                  ///< of the same period
  double force_limit = 1;          ///< N m per unit of the stick, > 0: what a command of 1 makes
  double encoder_step = 0;         ///< >= 0; 0: as fine as a float is
  int delay = 0;                   ///< 0 ... kMostDelay whole periods
  Microseconds silence = 100'000;  ///< us, > 0: without a command for that long, no force
};

/// Reads and writes what `advance()` left; one thread. Both devices are parts of the stick.
class SimulatedStick {
 public:
  SimulatedStick();
  SimulatedStick(const SimulatedStick&) = delete;  // its devices know their stick
  SimulatedStick& operator=(const SimulatedStick&) = delete;
  ~SimulatedStick() = default;

  /// Also centres it, still, at time 0.
  /// @returns kOk | kInvalidArgument: out of range, the periods differ, or the period is not a
  /// whole number of us (nothing changed)
  Status configure(const StickSettings& settings);

  /// One period passes: the command that is due is held, the hand goes to `hand`, a sample is taken
  /// at the end. @pre finite
  void advance(const Vec2<double>& hand);

  /// Gone, or there again: neither samples nor forces while it is gone.
  void plug(bool is_plugged);

  InputDevice& input() { return input_; }
  ForceDevice& force() { return force_; }

  Microseconds now() const { return now_; }
  const SimulatedAxis& x() const { return x_; }
  const SimulatedAxis& y() const { return y_; }
  /// The force that was held over the last period, N m per unit.
  const Vec2<double>& held() const { return held_; }

 private:
  class Input final : public InputDevice {
   public:
    explicit Input(SimulatedStick& stick) : stick_(stick) {}

   private:
    Status do_read(Microseconds now, InputSample& sample) override;
    SimulatedStick& stick_;
  };
  class Force final : public ForceDevice {
   public:
    explicit Force(SimulatedStick& stick) : stick_(stick) {}

   private:
    Status do_write(const ForceCommand& command) override;
    SimulatedStick& stick_;
  };

  Vec2<double> due();
  float seen(double position) const;

  StickSettings settings_;
  SimulatedAxis x_;
  SimulatedAxis y_;
  Input input_;
  Force force_;
  Vec2<double> commands_[kMostDelay + 1];  ///< [0]: the latest
  Vec2<double> held_ = Vec2<double>::Zero();
  InputSample sample_;
  Microseconds period_ = 0;
  Microseconds now_ = 0;
  Microseconds commanded_ = 0;  ///< when the latest command came
  bool is_new_ = false;
  bool is_plugged_ = true;
};

}  // namespace batuta::port_simulated
