// SPDX-License-Identifier: MIT
#pragma once
// The state of an object as bytes, the same on every machine: to save it, to restore it, and to
// compare two machines by a hash. A type lists its members once, for all of these ways:
//   `template <class ArchiveT> void archive(ArchiveT& ar) { ar(first_, second_); }`
// as a member, or as a free function archive(ar, x) beside the type. A structured binding in front
// of the list makes a member that was forgotten an error. One class for all ways, so that a list
// is compiled once. Bytes: src/record/archive.md.

#include <array>
#include <cstring>

#include "batuta/core/handle.hpp"
#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"

namespace batuta {

/// Goes over the members of an object, in one of four ways; made by the classes below. What does
/// not fit or is out of its range is noted once and for all: from then on nothing is changed.
/// Every call: constant time but for the members that it is given. Allocates: never.
class Archive {
 public:
  Archive(const Archive&) = delete;
  Archive& operator=(const Archive&) = delete;

  /// A number, an enumeration (see last_of()), an array, or whatever lists its members.
  template <class T>
  void operator()(T& x);
  /// One after the other.
  template <class T, class Next, class... More>
  void operator()(T& x, Next& next, More&... more) {
    (*this)(x);
    (*this)(next);
    ((*this)(more), ...);
  }
  /// The same, in a way that leaves it as it is. @pre not reading()
  template <class T>
  void look_at(const T& x) {
    BATUTA_ASSERT(!reading());
    (*this)(const_cast<T&>(x));
  }

  /// How many of `room` places are used. @returns 0 ... room; what was given, once status() is bad
  int count(int used, int room);
  /// A constant of the type that its members do not show: part of the fingerprint, not of the
  /// bytes.
  void constant(std::uint32_t value) {
    if (shaping()) shape(value);
  }
  /// What the ranges of single members cannot say, after reading; and of what is written, which who
  /// reads would refuse.
  void require(bool condition) {
    if (!condition && (reading() || writing()) && ok()) status_ = Status::kInvalidArgument;
  }

  /// Whether members are taken from bytes.
  bool reading() const { return way_ == Way::kRead; }
  /// Whether members are made into bytes that will be read.
  bool writing() const { return way_ == Way::kWrite; }
  /// Asks for the shape of the type: everything that it has room for, once.
  bool shaping() const { return way_ == Way::kShape; }
  /// Whether status() is kOk.
  bool ok() const { return status_ == Status::kOk; }
  /// @returns kOk | kPoolFull (writing: more than there is room for) | kInvalidArgument (a value
  /// out of its range; reading: also fewer bytes than there are members)
  Status status() const { return status_; }
  /// Bytes so far.
  int position() const { return position_; }
  /// All numbers so far were such that sums of products of four of them are finite, and all
  /// quaternions of unit length to within 2^-10. They need not be, for a body that has become
  /// unusable is saved as it is; who needs it asks.
  bool all_sane() const { return all_sane_; }
  /// A quaternion was met: all_sane() looks at its squared length.
  void note_quaternion(float squared_length);

 protected:
  /// What is done with the members.
  enum class Way : std::uint8_t { kRead, kWrite, kHash, kShape };

  /// @param source  bytes to read; else null
  /// @param target  room to write; else null
  /// @param size    of either, bytes
  Archive(Way way, const std::uint8_t* source, std::uint8_t* target, int size)
      : source_(source), target_(target), size_(size), way_(way) {}
  ~Archive() = default;
  /// Of the bytes so far (kHash), or of the shape so far (kShape).
  std::uint64_t digest() const { return digest_; }
  /// Bytes of the last real number, 0: there was none.
  std::uint8_t scalar_size() const { return scalar_size_; }

 private:
  /// Moves the lowest `width` bytes, 1 ... 4. @returns what was read; else what was given
  std::uint32_t move(std::uint32_t value, int width);
  std::uint64_t move_long(std::uint64_t value);
  void mix(std::uint8_t byte);
  void shape(std::uint32_t code);
  template <class T>
  void integer(T& x);
  void choice(std::uint8_t& value, std::uint8_t last);
  void real(float& x);
  void real(double& x);

  const std::uint8_t* source_;  ///< reading
  std::uint8_t* target_;        ///< writing
  int size_;
  int position_ = 0;
  std::uint64_t digest_ = 14695981039346656037U;
  Way way_;
  Status status_ = Status::kOk;
  bool all_sane_ = true;
  std::uint8_t scalar_size_ = 0;
};

/// Appends to a buffer of the caller's. sizeof(T) bytes are enough for a T: no member takes more
/// bytes than in memory.
class ArchiveWriter : public Archive {
 public:
  /// @pre room for `capacity` bytes, >= 0
  ArchiveWriter(std::uint8_t* bytes, int capacity)
      : Archive(Way::kWrite, nullptr, bytes, capacity) {}
};

/// Takes the members from bytes of which nothing is believed.
class ArchiveReader : public Archive {
 public:
  /// @pre `size` bytes, >= 0
  ArchiveReader(const std::uint8_t* bytes, int size) : Archive(Way::kRead, bytes, nullptr, size) {}
  /// All bytes were taken, and every one of them was good.
  bool is_done(int size) const { return ok() && position() == size; }
};

/// FNV-1a with 64 bits over the bytes that would be written.
class ArchiveHash : public Archive {
 public:
  /// Of no bytes yet.
  ArchiveHash() : Archive(Way::kHash, nullptr, nullptr, 0) {}
  /// The hash of all members so far.
  std::uint64_t value() const { return digest(); }
};

/// What the archive of a type looks like: its members, ranges and capacities. Two types of one
/// fingerprint can read each other's bytes.
class ArchiveShape : public Archive {
 public:
  /// Of no members yet.
  ArchiveShape() : Archive(Way::kShape, nullptr, nullptr, 0) {}
  /// The fingerprint of all members so far.
  std::uint64_t fingerprint() const { return digest(); }
  /// Of the last floating-point member, 4 or 8; 0 where there is none.
  std::uint8_t scalar() const { return scalar_size(); }
};

/// ArchiveHash of a state: two states with one hash go on alike.
template <class T>
std::uint64_t hash_of(const T& state) {
  ArchiveHash hash;
  hash.look_at(state);
  return hash.value();
}

namespace detail {

template <class T, class = void>
struct ListsItself : std::false_type {};
template <class T>
struct ListsItself<T, std::void_t<decltype(std::declval<T&>().archive(std::declval<Archive&>()))>>
    : std::true_type {};

}  // namespace detail

template <class T>
void Archive::integer(T& x) {
  if (shaping()) {
    shape(0x10U + sizeof(T));
  } else if constexpr (sizeof(T) == 8) {
    x = static_cast<T>(move_long(static_cast<std::uint64_t>(x)));
  } else {
    x = static_cast<T>(move(static_cast<std::uint32_t>(x), static_cast<int>(sizeof(T))));
  }
}

template <class T>
void Archive::operator()(T& x) {
  static_assert(!std::is_pointer_v<T>, "archive: an address has no meaning elsewhere");
  if constexpr (std::is_same_v<T, bool>) {
    auto byte = static_cast<std::uint8_t>(x ? 1 : 0);
    choice(byte, 1);
    x = byte != 0;
  } else if constexpr (std::is_enum_v<T>) {
    static_assert(sizeof(T) == 1, "archive: an enumeration is one byte");
    auto byte = static_cast<std::uint8_t>(x);
    choice(byte, static_cast<std::uint8_t>(last_of(x)));
    x = static_cast<T>(byte);
  } else if constexpr (std::is_integral_v<T>) {
    integer(x);
  } else if constexpr (std::is_floating_point_v<T>) {
    real(x);
  } else if constexpr (detail::ListsItself<T>::value) {
    x.archive(*this);
  } else {
    archive(*this, x);
  }
}

/// An array: its members one after the other.
template <class T, std::size_t N>
void archive(Archive& ar, std::array<T, N>& items) {
  ar.constant(static_cast<std::uint32_t>(N));
  for (T& item : items) {  // Bound: N; of their shape, one speaks for all
    ar(item);
    if (ar.shaping()) return;
  }
}

/// A matrix of fixed size: its numbers, column by column.
template <class Scalar, int kRows, int kColumns>
void archive(Archive& ar, Eigen::Matrix<Scalar, kRows, kColumns>& m) {
  static_assert(kRows > 0 && kColumns > 0, "archive: fixed sizes only");
  ar.constant(static_cast<std::uint32_t>(kRows * kColumns));
  for (int i = 0; i < kRows * kColumns; ++i) ar(m.data()[i]);  // Bound: its size
}

/// x, y, z, w.
template <class Scalar>
void archive(Archive& ar, Quat<Scalar>& q) {
  ar(q.coeffs());
  ar.note_quaternion(static_cast<float>(q.squaredNorm()));
}

/// Whether it names anything is found out where it is used.
template <class T>
void archive(Archive& ar, Handle<T>& handle) {
  auto& [index1, pool, generation] = handle;
  ar(index1, pool, generation);
}

}  // namespace batuta
