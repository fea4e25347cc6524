// SPDX-License-Identifier: MIT
#pragma once
// A device's force feedback as its own thread sees it: calls may take milliseconds.

#include <cstdint>
#include <string>

#include "programs/live/effect_set.hpp"
#include "programs/live/effects.hpp"

namespace batuta::host {

/// What a device can do to a hand.
enum class ForceKind : std::uint8_t {
  kNone,    ///< nothing, or it is not there
  kRumble,  ///< motors that shake
  kForce,   ///< a force with a direction
};

/// What became of an effect.
enum class Rendered : std::uint8_t {
  kDone,
  kLater,    ///< the device is busy: the force is still the last one, and it is to be tried again
  kRefused,  ///< the device is there and open, and takes none of its effects: it has no force
  kGone,     ///< the device is closed, and without a force as far as it can be reached
};

class ForceBackend {
 public:
  ForceBackend() = default;
  ForceBackend(const ForceBackend&) = delete;
  ForceBackend& operator=(const ForceBackend&) = delete;
  /// Leaves the device without a force.
  virtual ~ForceBackend() = default;

  /// Opens the device, or looks whether it is back. Does not wait for it.
  virtual ForceKind open() = 0;
  /// Leaves the device without a force.
  virtual void close() = 0;
  /// What the device can do, as far as it is known; kNone while it is closed, or after kRefused.
  virtual ForceKind kind() const = 0;
  /// Has the device render this from now on; what it does not take is rendered by the next best
  /// effect, or left out. It ends by itself, kEffectLength_ms after it was played last.
  virtual Rendered render(const Feel& feel) = 0;
  /// The next render() plays again what plays, and so it lasts anew. Not done by each of them: it
  /// is one more call of the system for each effect.
  virtual void renew() {}
  /// Whether the device that was opened is still there. If not, it is closed.
  virtual bool is_there() = 0;
  /// What was to be rendered since open(), and is not: the device refuses it, or does not know it.
  virtual EffectSet left_out() const { return {}; }
  /// Why there is no force, in a few words; empty: there is one, or the device is none that has.
  virtual std::string problem() const { return {}; }
  /// The last call on the thread that made the others: what a library keeps for each thread goes.
  virtual void end_thread() {}
};

}  // namespace batuta::host
