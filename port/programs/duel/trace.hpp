// SPDX-License-Identifier: MIT
#pragma once
// The way of a point over a whole bout in bounded memory: what is finer than a spacing is left out,
// and the spacing grows when the memory is full.

#include <array>
#include <cstddef>

#include "batuta/core/types.hpp"

namespace batuta::host {

struct TracePoint {
  float time = 0;  ///< s
  Vec3<float> p_W = Vec3<float>::Zero();
};

class Trace {
 public:
  static constexpr std::size_t kCapacity = 3000;

  void add(const TracePoint& point) {
    if (size_ == kCapacity) thin_out();
    if (size_ > 0 && (point.p_W - points_[size_ - 1].p_W).norm() < spacing_) return;
    points_[size_++] = point;
  }
  std::size_t size() const { return size_; }
  const TracePoint& operator[](std::size_t i) const { return points_[i]; }
  /// Two points are at least so far apart, m.
  float spacing() const { return spacing_; }

 private:
  /// Every point is a spacing from the last one that stays; at the latest every second one goes
  /// after a few rounds.
  void thin_out() {
    while (size_ > kCapacity / 2) {  // Bound: the spacing doubles up to the size of the salle
      spacing_ *= 2;
      std::size_t kept = 1;
      for (std::size_t i = 1; i < size_; ++i) {
        if ((points_[i].p_W - points_[kept - 1].p_W).norm() >= spacing_)
          points_[kept++] = points_[i];
      }
      size_ = kept;
    }
  }

  std::array<TracePoint, kCapacity> points_{};
  std::size_t size_ = 0;
  float spacing_ = 0.004F;
};

}  // namespace batuta::host
