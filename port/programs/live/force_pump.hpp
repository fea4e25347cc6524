// SPDX-License-Identifier: MIT
#pragma once
// From the latest command to a device's effects, one turn after the other: what the thread of a
// force does all day, here without the thread. The simulation hands commands over and never waits;
// the latest wins, and of what it overwrites, the hardest is remembered for the rumble.

#include <atomic>
#include <memory>

#include "batuta/port/clock.hpp"
#include "programs/live/force_backend.hpp"
#include "programs/live/latest.hpp"

namespace batuta::host {

/// How well the commands came through, as measured.
struct ForceReport {
  std::uint32_t sent = 0;             ///< effects handed to the device
  std::uint32_t silences = 0;         ///< times that commands stopped and the force was taken away
  std::uint32_t unplugs = 0;          ///< times that the device went away
  std::uint32_t stalls = 0;           ///< times that it was busy for too long, and was closed
  ForceKind kind = ForceKind::kNone;  ///< what it was told by last; kNone: it takes nothing
  EffectSet left_out;  ///< that were wanted: the device refused them, or does not know them
  std::int32_t worst_period_us = 0;  ///< between two effects while the force changes
  double mean_period_us = 0;
  double jitter_us = 0;           ///< mean distance of a period from the one that is meant
  std::int32_t worst_age_us = 0;  ///< of a command when its effect had been handed over
  double mean_age_us = 0;
};

/// What does not depend on the bout.
struct ForceOptions {
  Condition spring;
  Condition damper;
};

class ForcePump {
 public:
  /// A turn of the thread, and so the shortest time between two forces.
  static constexpr std::int32_t kTurn_us = 1000;
  /// Shaking motors hear nothing faster, and some drivers block for the whole transfer: SDL's own
  /// rumble thread and others keep to the same 10 ms.
  static constexpr std::int32_t kRumblePeriod_us = 10000;
  /// What is felt is played again so often, since it ends by itself: half of what a rumble of SDL
  /// lasts, a third of an effect's length.
  static constexpr std::int32_t kRefresh_us = 50000;
  /// Without a command for so long, there is no force; nor is there one that the device has kept
  /// for so long because it was too busy for the next.
  static constexpr std::int32_t kSilence_us = 100000;
  static_assert(kSilence_us < kEffectLength_ms * 1000,
                "a held force ends by a word of the program");
  /// A device is looked for so often while it is away, and looked after while it has nothing to do.
  static constexpr std::int32_t kRetry_us = 250000;

  /// @param clock  may be read from both threads; outlives this
  ForcePump(std::unique_ptr<ForceBackend> backend, const ForceOptions& options, Clock& clock)
      : backend_(std::move(backend)), options_(options), clock_(clock) {}

  /// From the simulation's thread. Bound: one turn of a loop, repeated only if the other thread
  /// took the hardest force in just that moment.
  /// @param own  share of the device's own spring and damper, 0 ... 1
  void put(float x, float y, float own = 1);

  /// One turn, on the device's thread.
  void turn();
  /// Takes the force away. On the device's thread, as its last act.
  void drop_force();
  /// Leaves a device alone that has no force. On the device's thread.
  void close() { backend_->close(); }
  /// As ForceBackend::problem(), before close(). On the device's thread.
  std::string problem() const { return backend_->problem(); }

  // Of any thread.
  ForceKind kind() const { return kind_.load(std::memory_order_relaxed); }
  /// As of some milliseconds ago. Of one thread, which may be another one than turn()'s.
  const ForceReport& report();

 private:
  struct Command {
    float x = 0;
    float y = 0;
    float own = 0;
    Microseconds time = 0;
  };
  /// Sums for the report.
  struct Sums {
    double period_us = 0;
    double jitter_us = 0;
    double age_us = 0;
    std::uint32_t periods = 0;
    std::uint32_t ages = 0;
  };

  bool attach(Microseconds now);
  void take_command(Microseconds now);
  Feel feel() const;
  bool is_due(const Feel& feel, Microseconds now) const;
  bool has_changed(const Feel& feel) const;
  bool is_felt(const Feel& feel) const;
  bool is_to_renew(const Feel& feel, Microseconds now) const;
  void send(const Feel& feel, Microseconds now);
  void look_after(Microseconds now);
  void lose();
  void settle(Rendered rendered, Microseconds now);
  void stall(Microseconds now);
  bool is_given_up();
  bool is_off() const;
  void measure(bool changed, Microseconds now);

  std::unique_ptr<ForceBackend> backend_;
  ForceOptions options_;
  Clock& clock_;
  Latest<Command> commands_;
  std::atomic<float> hardest_{0.0F};
  std::atomic<ForceKind> kind_{ForceKind::kNone};
  Latest<ForceReport> reports_;
  ForceReport read_report_;

  // Of the device's thread.
  Command command_;
  Feel sent_;
  Microseconds sent_at_ = 0;
  Microseconds renewed_at_ = 0;  ///< since when what plays has not been played again
  Microseconds tried_ = 0;       ///< the last time that the device answered, or did not
  float held_ = 0;               ///< what is left of the last blow for the rumble
  Microseconds busy_since_ = 0;
  bool busy_ = false;
  bool given_up_ = false;  ///< the device is there, and takes nothing
  bool has_tried_ = false;
  bool applied_ = false;  ///< sent_ is what the device renders
  bool fresh_ = false;    ///< the command has not been sent yet
  bool silent_ = true;
  ForceReport report_;
  Sums sums_;
};

}  // namespace batuta::host
