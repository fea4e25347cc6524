// SPDX-License-Identifier: MIT
#pragma once
// A fixed number of slots for objects of one type, named by handles that know when their object is
// gone. The book-keeping is one body of code for all types and sizes (PoolBase); Pool adds storage
// and types. RAM: N (sizeof(T) + 4) bytes, N / 8 for the bitmap, and a few words.

#include <cstddef>
#include <cstdint>
#include <iterator>
#include <new>
#include <type_traits>

#include "batuta/core/assert.hpp"
#include "batuta/core/handle.hpp"
#include "batuta/core/status.hpp"

namespace batuta {

namespace detail {

/// Which slots live, and in which generation. Not used directly.
class PoolBase {
 public:
  /// What index_of() answers where there is no object.
  static constexpr int kNoIndex = -1;

  PoolBase(const PoolBase&) = delete;
  PoolBase(PoolBase&&) = delete;
  PoolBase& operator=(const PoolBase&) = delete;
  PoolBase& operator=(PoolBase&&) = delete;

  /// Objects that live.
  int size() const { return size_; }
  /// Whether no object lives.
  bool empty() const { return size_ == 0; }
  /// N.
  int capacity() const { return capacity_; }
  /// Slots that can still be used: N, less those retired. A slot is retired when its 2^32 - 1
  /// generations are used up (at a thousand objects a second in one slot, after 49 days), so that a
  /// handle never names an object that is not its own.
  int usable_capacity() const { return capacity_ - retired_; }

  /// Ends all objects; their handles become stale.
  /// Bound: N slots.
  void clear();

 protected:
  static constexpr std::size_t kBitsPerWord = 32;  ///< bits of a word of the bitmap
  /// Words of a bitmap of so many slots.
  static constexpr std::size_t words_for(std::size_t slots) {
    return (slots + kBitsPerWord - 1) / kBitsPerWord;
  }

  /// @param generations  one for each slot, zeroed; owned by the derived pool, like `live`
  /// @param live         words_for(capacity) words of the bitmap, zeroed
  PoolBase(std::uint16_t number, std::uint16_t capacity, std::uint32_t* generations,
           std::uint32_t* live)
      : generations_(generations), live_(live), capacity_(capacity), number_(number) {}
  ~PoolBase() = default;

  /// The number that the pool was given.
  std::uint16_t number() const { return number_; }
  /// Of the last object made in a slot; 0: none yet. @pre index < N
  std::uint32_t generation(std::size_t index) const { return generations_[index]; }
  /// Whether a slot holds an object; false beyond the slots.
  bool is_live(std::size_t index) const {
    return index < capacity_ && (live_[index / kBitsPerWord] & bit_of(index)) != 0;
  }
  /// The slot of a live object that these three parts of a handle name, else kNoIndex.
  int find(std::uint16_t index1, std::uint16_t pool, std::uint32_t generation) const;
  /// Takes the lowest free slot into its next generation. @returns its index, or kNoIndex where
  /// none is free Bound: N slots.
  int acquire();
  /// @pre the slot is live
  void release(std::size_t index);
  /// Which slots live, and in which generation, and the number. What was read is brought in order,
  /// so that what is found to be no book-keeping of a pool does no harm.
  /// Bound: N slots.
  template <class ArchiveT>
  void archive_slots(ArchiveT& ar) {
    ar(number_);
    for (std::size_t i = 0; i < capacity_; ++i) ar(generations_[i]);  // Bound: N
    for (std::size_t word = 0; word < words_for(capacity_); ++word)
      ar(live_[word]);  // Bound: N / 32
    if (ar.reading()) ar.require(settle());
  }
  /// Takes over which slots of `other` live, and in which generation, and its number.
  /// @pre the same capacity. Bound: N slots.
  void copy_slots(const PoolBase& other);
  /// The first live slot at or behind `index`, N where there is none.
  /// Bound: N / 32 words.
  std::size_t next_live(std::size_t index) const;

 private:
  friend class PoolTestAccess;  // sets generations that a test could not reach by counting

  static constexpr std::uint32_t bit_of(std::size_t index) {
    return std::uint32_t{1} << (index % kBitsPerWord);
  }
  /// Ends what cannot live: beyond the slots, or without a generation; counts the others.
  /// @returns whether there was nothing to end. Bound: N slots.
  bool settle();

  std::uint32_t* generations_;  ///< of the last object made in the slot; 0: none yet
  std::uint32_t* live_;         ///< bit i % 32 of word i / 32: slot i holds an object
  int size_ = 0;
  int retired_ = 0;
  std::uint16_t capacity_;
  std::uint16_t number_;
};

}  // namespace detail

/// Up to N objects of type T. An object stays where it was made. New objects take the lowest free
/// slot, so that the same calls give the same slots everywhere.
/// @tparam T  trivially destructible: nothing happens when an object ends
/// @tparam N  1 ... 65535
/// Allocates: never. ISR-safe: from one context at a time.
template <class T, int N>
class Pool : public detail::PoolBase {
  static_assert(N >= 1 && N <= 65535, "Pool: choose 1 ... 65535 slots");
  static_assert(std::is_object_v<T> && std::is_trivially_destructible_v<T>,
                "Pool: objects must be trivially destructible");

 public:
  /// What it holds.
  using value_type = T;
  static constexpr int kCapacity = N;  ///< N.

  /// Walks over the live objects in the order of their slots. The object it stands on may be
  /// removed.
  template <bool kConst>
  class Iterator {
   public:
    /// Pool, or const Pool.
    using PoolType = std::conditional_t<kConst, const Pool, Pool>;
    /// It may be copied and gone over again.
    using iterator_category = std::forward_iterator_tag;
    /// What the pool holds.
    using value_type = T;
    /// As the standard asks; nothing is subtracted.
    using difference_type = std::ptrdiff_t;
    /// T, or const T.
    using reference = std::conditional_t<kConst, const T&, T&>;
    /// To T, or to const T.
    using pointer = std::conditional_t<kConst, const T*, T*>;

    /// Stands nowhere: to be assigned to.
    Iterator() = default;
    /// Stands on a slot of the pool. @pre the slot is live, or index is N: the end
    Iterator(PoolType& pool, std::size_t index) : pool_(&pool), index_(index) {}

    /// The slot it stands on; Pool::handle_at() makes a handle of it.
    std::size_t index() const { return index_; }
    /// The object it stands on. @pre that lives
    reference operator*() const { return *pool_->slot(index_); }
    /// The object it stands on. @pre that lives
    pointer operator->() const { return pool_->slot(index_); }
    /// On to the next object. Bound: N / 32 words.
    Iterator& operator++() {
      index_ = pool_->next_live(index_ + 1);
      return *this;
    }
    /// On to the next object; what it stood on before. Bound: N / 32 words.
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    /// Whether both stand on the same slot. @pre of one pool
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.index_ == b.index_; }
    /// Whether they stand on different slots. @pre of one pool
    friend bool operator!=(const Iterator& a, const Iterator& b) { return a.index_ != b.index_; }

   private:
    PoolType* pool_ = nullptr;
    std::size_t index_ = 0;
  };
  /// Walks over objects that may be changed.
  using iterator = Iterator<false>;
  /// Walks over objects that may be read.
  using const_iterator = Iterator<true>;

  /// @param number  tells this pool's handles from those of another pool of the same T
  // cppcheck-suppress uninitMemberVar ; deviation: pool-storage
  explicit Pool(std::uint16_t number = 0)
      : detail::PoolBase(number, static_cast<std::uint16_t>(N), generations_, live_) {}

  /// Makes an object from the arguments.
  /// @returns kOk with its handle | kPoolFull: no usable slot is free
  /// Bound: N slots.
  template <class... Args>
  Result<Handle<T>> make(const Args&... args) {
    const int index = acquire();
    if (index == kNoIndex) return failure<Handle<T>>(Status::kPoolFull);
    const auto i = static_cast<std::size_t>(index);
    ::new (storage_ + i * sizeof(T)) T(args...);  // deviation: placement-new
    return success(handle_of(i));
  }

  /// Ends an object. @returns kOk | kStaleHandle: null, foreign, or gone already
  Status remove(Handle<T> handle) {
    const int index = index_of(handle);
    if (index == kNoIndex) return Status::kStaleHandle;
    release(static_cast<std::size_t>(index));
    return Status::kOk;
  }

  /// Becomes a copy of `saved`: the same objects in the same slots, known by the same handles. By
  /// name, so that no pool is copied by accident.
  /// Bound: N slots.
  void restore(const Pool& saved) {
    if (&saved == this) return;
    for (std::size_t i = 0; i < kSlots; ++i) {  // Bound: N
      if (!saved.is_live(i)) continue;
      ::new (storage_ + i * sizeof(T)) T(*saved.slot(i));  // deviation: placement-new
    }
    copy_slots(saved);
  }

  /// Live objects, known by the same handles where they are read. Stack: one T.
  /// @pre T{} is good, and is written over where it is read
  /// Bound: N slots.
  template <class ArchiveT>
  void archive(ArchiveT& ar) {
    if (ar.shaping()) {
      constexpr std::uint32_t kPool = 0x4C4F4F50U;  // "POOL": no array
      T blank{};
      ar.constant(kPool);
      ar.constant(static_cast<std::uint32_t>(N));
      return ar(blank);
    }
    archive_slots(ar);
    for (std::size_t i = next_live(0); i < kSlots; i = next_live(i + 1)) {  // Bound: N
      if (ar.reading()) ::new (storage_ + i * sizeof(T)) T{};  // deviation: placement-new
      ar(*slot(i));
    }
  }

  /// The object, or null for a null, foreign or stale handle.
  T* get(Handle<T> handle) {
    const int index = index_of(handle);
    return index == kNoIndex ? nullptr : slot(static_cast<std::size_t>(index));
  }
  /// The object, or null for a null, foreign or stale handle.
  const T* get(Handle<T> handle) const {
    const int index = index_of(handle);
    return index == kNoIndex ? nullptr : slot(static_cast<std::size_t>(index));
  }

  /// The object's slot, for tables beside the pool; kNoIndex for a null, foreign or stale handle.
  int index_of(Handle<T> handle) const {
    return find(handle.index1, handle.pool, handle.generation);
  }
  /// The handle of the object in a slot; null where there is none.
  Handle<T> handle_at(std::size_t index) const {
    return is_live(index) ? handle_of(index) : Handle<T>{};
  }
  /// The object in a slot. @pre the slot is live, which only slow checks look after
  T& at(std::size_t index) {
    BATUTA_SLOW_CHECK(is_live(index));
    return *std::launder(reinterpret_cast<T*>(storage_ + index * sizeof(T)));
  }
  /// The object in a slot. @pre the slot is live, which only slow checks look after
  const T& at(std::size_t index) const {
    BATUTA_SLOW_CHECK(is_live(index));
    return *std::launder(reinterpret_cast<const T*>(storage_ + index * sizeof(T)));
  }
  /// The object in a slot; null where there is none.
  T* at_index(std::size_t index) { return is_live(index) ? slot(index) : nullptr; }
  /// The object in a slot; null where there is none.
  const T* at_index(std::size_t index) const { return is_live(index) ? slot(index) : nullptr; }

  /// The live object of the lowest slot. Bound: N / 32 words.
  iterator begin() { return {*this, next_live(0)}; }
  /// Behind the last slot.
  iterator end() { return {*this, static_cast<std::size_t>(N)}; }
  /// The live object of the lowest slot. Bound: N / 32 words.
  const_iterator begin() const { return {*this, next_live(0)}; }
  /// Behind the last slot.
  const_iterator end() const { return {*this, static_cast<std::size_t>(N)}; }

 private:
  static constexpr auto kSlots = static_cast<std::size_t>(N);

  Handle<T> handle_of(std::size_t index) const {
    return {static_cast<std::uint16_t>(index + 1), number(), generation(index)};
  }
  /// @pre the slot is live
  T* slot(std::size_t index) {
    BATUTA_INVARIANT(is_live(index));
    return std::launder(reinterpret_cast<T*>(storage_ + index * sizeof(T)));
  }
  const T* slot(std::size_t index) const {
    BATUTA_INVARIANT(is_live(index));
    return std::launder(reinterpret_cast<const T*>(storage_ + index * sizeof(T)));
  }

  std::uint32_t generations_[kSlots] = {};
  std::uint32_t live_[words_for(kSlots)] = {};
  alignas(T) unsigned char storage_[kSlots * sizeof(T)];
};

}  // namespace batuta
