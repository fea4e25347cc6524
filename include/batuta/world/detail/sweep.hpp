// SPDX-License-Identifier: MIT
#pragma once
// Which boxes overlap: sweep and prune over fixed arrays. Boxes are kept in ascending order along
// one axis from step to step (insertion sort: cheap where little changes), and in blocks of
// neighbours that know what they span, so that long boxes and boxes at rest cost the others next to
// nothing. Few boxes are tested each with each. What was measured: src/world/detail/sweep.md.

#include "batuta/geometry/kdop.hpp"
#include "batuta/world/detail/proxy_pair.hpp"

namespace batuta::detail {

/// Most boxes for which testing each with each is as fast as an order, and a quarter of its code.
inline constexpr int kFewBoxes = 16;

/// Boxes in fixed slots.
template <class Scalar, int N>
class BoxSlots {
  static_assert(N >= 1 && N <= 65535, "BoxSlots: slots are counted in 16 bits");

 public:
  /// Not a constant expression: a list that is a global is made by code, not copied from flash.
  BoxSlots() { states_.fill(State::kEmpty); }

  bool contains(std::uint16_t slot) const { return states_[slot] != State::kEmpty; }
  /// @pre contains(slot)
  const Aabb<Scalar>& box(std::uint16_t slot) const { return boxes_[slot]; }
  /// Idle or empty.
  bool is_idle(std::uint16_t slot) const { return states_[slot] != State::kBusy; }

 protected:
  void put(std::uint16_t slot, const Aabb<Scalar>& box, bool idle) {
    boxes_[slot] = box;
    states_[slot] = idle ? State::kIdle : State::kBusy;
  }
  /// Leaves the empty box, which is last along every axis.
  void clear(std::uint16_t slot) {
    boxes_[slot] = {};
    states_[slot] = State::kEmpty;
  }
  /// @pre contains(a)
  bool do_overlap(std::uint16_t a, std::uint16_t b) const {
    return contains(b) && overlaps<Scalar, 6>(boxes_[a], boxes_[b]);
  }

 private:
  enum class State : std::uint8_t { kEmpty, kIdle, kBusy };

  std::array<Aabb<Scalar>, static_cast<std::size_t>(N)> boxes_;
  std::array<State, static_cast<std::size_t>(N)> states_;
};

/// Few boxes: each with each, in ascending order of (first, second), and nothing to sort. The
/// members are those of ManyBoxes.
template <class Scalar, int N>
class FewBoxes : public BoxSlots<Scalar, N> {
  using Slot = std::uint16_t;

 public:
  void set(Slot slot, const Aabb<Scalar>& box, bool idle) { this->put(slot, box, idle); }
  void remove(Slot slot) { this->clear(slot); }
  void sort() {}

  template <class Found>
  void for_each_pair(const Found& found) const {
    for (Slot i = 0; i < kSlots; ++i) {  // Bound: N
      if (!this->contains(i)) continue;
      for (Slot k = static_cast<Slot>(i + 1); k < kSlots; ++k) {  // Bound: N
        if (this->is_idle(i) && this->is_idle(k)) continue;
        if (this->do_overlap(i, k)) found(ProxyPair{i, k});
      }
    }
  }

  template <class Found>
  void for_each_partner(Slot slot, const Found& found) const {
    for (Slot k = 0; k < kSlots; ++k) {  // Bound: N
      if (k != slot && this->do_overlap(slot, k)) found(k);
    }
  }

 private:
  static constexpr auto kSlots = static_cast<Slot>(N);
};

/// Boxes in order along an axis.
/// @tparam kAxis  the one along which boxes are spread most: 0 x, 1 y, 2 z
template <class Scalar, int N, int kAxis>
class ManyBoxes : public BoxSlots<Scalar, N> {
  static_assert(kAxis >= 0 && kAxis < 3, "SweepList: choose axis 0 (x), 1 (y) or 2 (z)");
  using Slot = std::uint16_t;

 public:
  ManyBoxes();

  /// Puts or moves a box. Bound: no loop.
  /// @param box   no NaN; may be unbounded (lowest ... max)
  /// @param idle  nothing of it moves, and nothing has to be found for it unless a box that is not
  ///   idle overlaps it
  /// @pre slot < N
  void set(Slot slot, const Aabb<Scalar>& box, bool idle);

  /// Nothing happens where the slot is empty. Bound: no loop.
  void remove(Slot slot) { this->clear(slot); }

  /// Restores the order: along the axis, then by slot, so that it depends on nothing but the boxes.
  /// Bound: N steps where little changed, N (N - 1) / 2 at worst.
  void sort();

  /// Calls found(ProxyPair{first, second}), first < second, once for every two overlapping boxes
  /// (touching counts) of which at least one is not idle. Idle boxes among themselves cost nothing
  /// but being passed. @pre sort() since the last set() or remove()
  /// Bound: N (N - 1) / 2 box tests.
  template <class Found>
  void for_each_pair(const Found& found) const;

  /// Calls found(other) once for every box, idle or not, that overlaps the one of `slot`. Sorted or
  /// not, it misses none; sorted, it is fast.
  /// @pre contains(slot)
  /// Bound: N box tests.
  template <class Found>
  void for_each_partner(Slot slot, const Found& found) const;

 private:
  /// What is known of kBlock neighbours in the order: never less than they span.
  struct Block {
    Scalar low = std::numeric_limits<Scalar>::max();
    Scalar high = std::numeric_limits<Scalar>::lowest();
    Scalar idle_high = std::numeric_limits<Scalar>::lowest();  ///< of the idle ones among them
  };
  static constexpr std::size_t kSlots = static_cast<std::size_t>(N);
  static constexpr std::size_t kBlock = 16;
  static constexpr std::size_t kBlocks = (kSlots + kBlock - 1) / kBlock;
  static constexpr std::size_t kSweep = static_cast<std::size_t>(kAxis);
  static constexpr std::size_t kAcross = (kSweep + 1) % 3;

  Scalar low(Slot slot) const { return this->box(slot).low[kSweep]; }
  Scalar high(Slot slot) const { return this->box(slot).high[kSweep]; }
  bool precedes(Slot a, Slot b) const {
    const Scalar low_a = low(a);
    const Scalar low_b = low(b);
    return low_a < low_b || (low_a == low_b && a < b);
  }
  /// What settles most of the boxes that overlap along the axis, without a call.
  bool are_apart_across(Slot a, Slot b) const {
    const Aabb<Scalar>& P = this->box(a);
    const Aabb<Scalar>& Q = this->box(b);
    return P.high[kAcross] < Q.low[kAcross] || Q.high[kAcross] < P.low[kAcross];
  }
  bool is_sorted() const;
  static std::size_t end_of(std::size_t block) { return min_of((block + 1) * kBlock, kSlots); }

  void widen(Block& block, Slot slot);
  template <class Found>
  void idle_before(std::size_t place, const Found& found) const;
  template <class Found>
  void report(Slot a, Slot b, const Found& found) const {
    if (this->do_overlap(a, b)) found(ProxyPair{min_of(a, b), max_of(a, b)});
  }

  std::array<Block, kBlocks> blocks_;
  std::array<Slot, kSlots> order_;   ///< all slots; after sort() ascending, empty ones last
  std::array<Slot, kSlots> places_;  ///< of the slots in the order
};

/// Boxes in fixed slots, and the pairs of them that overlap.
template <class Scalar, int N, int kAxis = 0>
class SweepList
    : public std::conditional_t<N <= kFewBoxes, FewBoxes<Scalar, N>, ManyBoxes<Scalar, N, kAxis>> {
};

template <class Scalar, int N, int kAxis>
ManyBoxes<Scalar, N, kAxis>::ManyBoxes() {
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: N
    order_[i] = places_[i] = static_cast<Slot>(i);
  }
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::set(Slot slot, const Aabb<Scalar>& box, bool idle) {
  this->put(slot, box, idle);
  widen(blocks_[places_[slot] / kBlock], slot);
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::widen(Block& block, Slot slot) {
  block.low = min_of(block.low, low(slot));
  block.high = max_of(block.high, high(slot));
  if (this->is_idle(slot)) block.idle_high = max_of(block.idle_high, high(slot));
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::sort() {
  for (std::size_t i = 1; i < kSlots; ++i) {  // Bound: N
    const Slot moving = order_[i];
    std::size_t k = i;
    for (; k > 0 && precedes(moving, order_[k - 1]); --k) order_[k] = order_[k - 1];  // Bound: i
    order_[k] = moving;
  }
  blocks_.fill({});
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: N
    places_[order_[i]] = static_cast<Slot>(i);
    widen(blocks_[i / kBlock], order_[i]);
  }
}

template <class Scalar, int N, int kAxis>
bool ManyBoxes<Scalar, N, kAxis>::is_sorted() const {
  for (std::size_t i = 1; i < kSlots; ++i) {  // Bound: N
    if (precedes(order_[i], order_[i - 1])) return false;
  }
  return true;
}

/// A pair belongs to the first of the two in the order that is not idle: the other is ahead of it,
/// or idle and began before it.
template <class Scalar, int N, int kAxis>
template <class Found>
void ManyBoxes<Scalar, N, kAxis>::for_each_pair(const Found& found) const {
  BATUTA_SLOW_CHECK(is_sorted());
  Scalar idle_high = std::numeric_limits<Scalar>::lowest();  // of the idle boxes passed
  for (std::size_t i = 0; i < kSlots; ++i) {                 // Bound: N
    const Slot slot = order_[i];
    if (this->is_idle(slot)) {
      idle_high = max_of(idle_high, high(slot));
      continue;
    }
    if (!(idle_high < low(slot))) idle_before(i, found);
    const Scalar end = high(slot);
    for (std::size_t k = i + 1; k < kSlots && !(end < low(order_[k])); ++k) {  // Bound: N
      if (!are_apart_across(slot, order_[k])) report(slot, order_[k], found);
    }
  }
}

template <class Scalar, int N, int kAxis>
template <class Found>
void ManyBoxes<Scalar, N, kAxis>::idle_before(std::size_t place, const Found& found) const {
  const Slot slot = order_[place];
  const Scalar start = low(slot);
  for (std::size_t b = 0; b * kBlock < place; ++b) {  // Bound: N / kBlock
    if (blocks_[b].idle_high < start) continue;
    const std::size_t end = min_of(place, end_of(b));
    for (std::size_t k = b * kBlock; k < end; ++k) {  // Bound: kBlock
      if (this->is_idle(order_[k])) report(slot, order_[k], found);
    }
  }
}

template <class Scalar, int N, int kAxis>
template <class Found>
void ManyBoxes<Scalar, N, kAxis>::for_each_partner(Slot slot, const Found& found) const {
  const Scalar start = low(slot);
  const Scalar end = high(slot);
  for (std::size_t b = 0; b < kBlocks; ++b) {  // Bound: N / kBlock
    if (blocks_[b].high < start || end < blocks_[b].low) continue;
    for (std::size_t k = b * kBlock; k < end_of(b); ++k) {  // Bound: kBlock
      const Slot other = order_[k];
      if (other != slot && this->do_overlap(slot, other)) found(other);
    }
  }
}

}  // namespace batuta::detail
