// SPDX-License-Identifier: MIT

#include "programs/live/feed_pump.hpp"

#include <chrono>
#include <thread>

namespace batuta::host {

void FeedPump::wait() {
  if (is_attached()) {
    feed_->wait();
  } else {
    constexpr std::chrono::milliseconds kPause(5);  // a program that ends does not wait for more
    std::this_thread::sleep_for(kPause);
  }
}

void FeedPump::turn(Microseconds now) {
  if (!is_attached()) {
    if (elapsed_us(tried_, now) < kRetry_us) return;
    tried_ = now;
    if (!feed_->reopen()) return;
    attached_ = true;
    has_spoken_ = false;
  }
  InputSample sample = last_;
  const News news = feed_->look(sample);
  losses_ = feed_->losses();
  if (news == News::kGone) {
    attached_ = false;
    tried_ = now;
    ++unplugs_;
    return;
  }
  const bool repeat =
      news == News::kNone && has_spoken_ && elapsed_us(last_.time, now) >= kRepeat_us;
  if (news == News::kNone && !repeat) return;
  sample.sequence = last_.sequence + 1;
  if (repeat || is_later(sample.time, now)) sample.time = now;
  last_ = sample;
  has_spoken_ = true;
  publish();
}

void FeedPump::publish() {
  latest_.put(last_);
}

}  // namespace batuta::host
