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

/// What is in fixed slots.
template <int N>
class SlotStates {
  static_assert(N >= 1 && N <= 65535, "SlotStates: slots are counted in 16 bits");

 public:
  /// Not a constant expression: a list that is a global is made by code, not copied from flash.
  SlotStates() { states_.fill(State::kEmpty); }

  bool contains(std::uint16_t slot) const { return states_[slot] != State::kEmpty; }
  /// Idle or empty.
  bool is_idle(std::uint16_t slot) const { return states_[slot] != State::kBusy; }

 protected:
  void fill(std::uint16_t slot, bool idle) { states_[slot] = idle ? State::kIdle : State::kBusy; }
  void clear(std::uint16_t slot) { states_[slot] = State::kEmpty; }

 private:
  enum class State : std::uint8_t { kEmpty, kIdle, kBusy };

  std::array<State, static_cast<std::size_t>(N)> states_;
};

/// Few boxes: each with each, in ascending order of (first, second), and nothing to sort. The
/// members are those of ManyBoxes.
template <class Scalar, int N>
class FewBoxes : public SlotStates<N> {
  using Slot = std::uint16_t;

 public:
  void set(Slot slot, const Aabb<Scalar>& box, bool idle) {
    boxes_[slot] = box;
    this->fill(slot, idle);
  }
  void remove(Slot slot) { this->clear(slot); }
  /// @pre contains(slot)
  const Aabb<Scalar>& box(Slot slot) const { return boxes_[slot]; }
  void sort() {}

  template <class Found>
  void for_each_pair(const Found& found) const {
    for (Slot i = 0; i < kSlots; ++i) {  // Bound: N
      if (!this->contains(i)) continue;
      for (Slot k = static_cast<Slot>(i + 1); k < kSlots; ++k) {  // Bound: N
        if (this->is_idle(i) && this->is_idle(k)) continue;
        if (do_overlap(i, k)) found(ProxyPair{i, k});
      }
    }
  }

  template <class Found>
  void for_each_partner(Slot slot, const Found& found) const {
    for (Slot k = 0; k < kSlots; ++k) {  // Bound: N
      if (k != slot && do_overlap(slot, k)) found(k);
    }
  }

 private:
  static constexpr auto kSlots = static_cast<Slot>(N);

  /// @pre contains(a)
  bool do_overlap(Slot a, Slot b) const {
    return this->contains(b) && overlaps<Scalar, 6>(boxes_[a], boxes_[b]);
  }

  std::array<Aabb<Scalar>, static_cast<std::size_t>(N)> boxes_;
};

/// Boxes in order along an axis, each kept at its place in the order: who looks ahead reads
/// neighbours in memory.
/// @tparam kAxis  the one along which boxes are spread most: 0 x, 1 y, 2 z
template <class Scalar, int N, int kAxis>
class ManyBoxes : public SlotStates<N> {
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

  /// Nothing happens where the slot is empty. Leaves the empty box, which is last along every axis.
  /// Bound: no loop.
  void remove(Slot slot);

  /// @pre contains(slot)
  const Aabb<Scalar>& box(Slot slot) const { return boxes_[places_[slot]]; }

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

  Scalar low(std::size_t place) const { return boxes_[place].low[kSweep]; }
  Scalar high(std::size_t place) const { return boxes_[place].high[kSweep]; }
  bool is_idle_at(std::size_t place) const { return this->is_idle(order_[place]); }
  /// Whether the box of a slot that begins at `start` stands before who is at a place.
  bool precedes(Scalar start, Slot slot, std::size_t place) const {
    return start < low(place) || (start == low(place) && slot < order_[place]);
  }
  /// What settles most of the boxes that overlap along the axis, without a call. Which of the two
  /// is on which side is a coin's toss, so it is not asked (sweep.md).
  bool are_apart_across(std::size_t a, std::size_t b) const {
    const Aabb<Scalar>& P = boxes_[a];
    const Aabb<Scalar>& Q = boxes_[b];
    return min_of(P.high[kAcross], Q.high[kAcross]) < max_of(P.low[kAcross], Q.low[kAcross]);
  }
  bool do_overlap(std::size_t a, std::size_t b) const {
    return this->contains(order_[b]) && overlaps<Scalar, 6>(boxes_[a], boxes_[b]);
  }
  bool is_sorted() const;
  static std::size_t end_of(std::size_t block) { return min_of((block + 1) * kBlock, kSlots); }

  void widen(std::size_t place);
  void sink(std::size_t place);  ///< @pre place > 0
  template <class Found>
  void idle_before(std::size_t place, const Found& found) const;
  template <class Found>
  void report(std::size_t a, std::size_t b, const Found& found) const {
    if (!do_overlap(a, b)) return;
    found(ProxyPair{min_of(order_[a], order_[b]), max_of(order_[a], order_[b])});
  }

  std::array<Aabb<Scalar>, kSlots> boxes_;  ///< by place
  std::array<Block, kBlocks> blocks_;
  std::array<Slot, kSlots> order_;  ///< all slots by place; after sort() ascending, empty ones last
  std::array<Slot, kSlots> places_;  ///< by slot
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
  boxes_[places_[slot]] = box;
  this->fill(slot, idle);
  widen(places_[slot]);
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::remove(Slot slot) {
  boxes_[places_[slot]] = {};
  this->clear(slot);
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::widen(std::size_t place) {
  Block& block = blocks_[place / kBlock];
  block.low = min_of(block.low, low(place));
  block.high = max_of(block.high, high(place));
  if (is_idle_at(place)) block.idle_high = max_of(block.idle_high, high(place));
}

/// Down to its place among those before it, which are in order.
template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::sink(std::size_t place) {
  const Slot slot = order_[place];
  if (!precedes(low(place), slot, place - 1)) return;
  const Aabb<Scalar> box = boxes_[place];
  std::size_t k = place;
  for (; k > 0 && precedes(box.low[kSweep], slot, k - 1); --k) {  // Bound: place
    boxes_[k] = boxes_[k - 1];
    order_[k] = order_[k - 1];
  }
  boxes_[k] = box;
  order_[k] = slot;
}

template <class Scalar, int N, int kAxis>
void ManyBoxes<Scalar, N, kAxis>::sort() {
  for (std::size_t i = 1; i < kSlots; ++i) sink(i);  // Bound: N
  blocks_.fill({});
  for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: N
    places_[order_[i]] = static_cast<Slot>(i);
    widen(i);
  }
}

template <class Scalar, int N, int kAxis>
bool ManyBoxes<Scalar, N, kAxis>::is_sorted() const {
  for (std::size_t i = 1; i < kSlots; ++i) {  // Bound: N
    if (precedes(low(i), order_[i], i - 1)) return false;
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
    if (is_idle_at(i)) {
      idle_high = max_of(idle_high, high(i));
      continue;
    }
    if (!(idle_high < low(i))) idle_before(i, found);
    const Scalar end = high(i);
    for (std::size_t k = i + 1; k < kSlots && !(end < low(k)); ++k) {  // Bound: N
      if (!are_apart_across(i, k)) report(i, k, found);
    }
  }
}

template <class Scalar, int N, int kAxis>
template <class Found>
void ManyBoxes<Scalar, N, kAxis>::idle_before(std::size_t place, const Found& found) const {
  for (std::size_t b = 0; b * kBlock < place; ++b) {  // Bound: N / kBlock
    if (blocks_[b].idle_high < low(place)) continue;
    const std::size_t end = min_of(place, end_of(b));
    for (std::size_t k = b * kBlock; k < end; ++k) {  // Bound: kBlock
      if (is_idle_at(k)) report(place, k, found);
    }
  }
}

template <class Scalar, int N, int kAxis>
template <class Found>
void ManyBoxes<Scalar, N, kAxis>::for_each_partner(Slot slot, const Found& found) const {
  const std::size_t place = places_[slot];
  for (std::size_t b = 0; b < kBlocks; ++b) {  // Bound: N / kBlock
    if (blocks_[b].high < low(place) || high(place) < blocks_[b].low) continue;
    for (std::size_t k = b * kBlock; k < end_of(b); ++k) {  // Bound: kBlock
      if (k != place && do_overlap(place, k)) found(order_[k]);
    }
  }
}

}  // namespace batuta::detail
