// SPDX-License-Identifier: MIT
#pragma once
// From a feed to the latest sample, one turn after the other: what the thread of a live device does
// all day, here without the thread.

#include <atomic>
#include <memory>

#include "programs/live/feed.hpp"
#include "programs/live/latest.hpp"

namespace batuta::host {

class FeedPump {
 public:
  /// A device speaks when something changes. For as long as it is there, what it said last goes on
  /// to be true: it is said again, with the time, after so much silence. Longer than any device's
  /// report interval (16 ms at 62.5 Hz), so that a slow one does not seem to stop between two
  /// reports; shorter than what the forces take for silence (100 ms).
  static constexpr std::int32_t kRepeat_us = 20000;
  /// An unplugged device is looked for so often.
  static constexpr std::int32_t kRetry_us = 250000;

  /// @pre `feed` is open
  explicit FeedPump(std::unique_ptr<Feed> feed) : feed_(std::move(feed)) {}

  /// One turn. Of one thread: that of the device.
  void turn(Microseconds now);
  /// Before a turn: until there may be news. Of the same thread.
  void wait();
  /// As its last act.
  void end_thread() { feed_->end_thread(); }

  /// The latest sample, if it has not been taken yet. Of one thread, which may be another one.
  bool take(InputSample& sample) { return latest_.take(sample); }

  // Of any thread.
  bool is_attached() const { return attached_.load(std::memory_order_relaxed); }
  /// Times that the device went away.
  std::uint32_t unplugs() const { return unplugs_.load(std::memory_order_relaxed); }
  std::uint32_t losses() const { return losses_.load(std::memory_order_relaxed); }

 private:
  void publish();

  std::unique_ptr<Feed> feed_;
  Latest<InputSample> latest_;
  InputSample last_;         ///< published; its number counts over all re-openings
  Microseconds tried_ = 0;   ///< the last attempt to open again
  bool has_spoken_ = false;  ///< since it was plugged in
  std::atomic<bool> attached_{true};
  std::atomic<std::uint32_t> unplugs_{0};
  std::atomic<std::uint32_t> losses_{0};
};

}  // namespace batuta::host
