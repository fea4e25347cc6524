// SPDX-License-Identifier: MIT
#pragma once
// A state saved in a buffer of the caller's, and restored on this machine or another, to go on with
// the same bits. Format, byte by byte: src/record/archive.md.

#include "batuta/record/archive.hpp"

namespace batuta {

/// Why bytes are not taken for a state.
enum class [[nodiscard]] Restored : std::uint8_t{
    kOk,            ///< the state is the one that was saved
    kForeign,       ///< not a saved state
    kOtherVersion,  ///< of the format
    kOtherScalar,   ///< float here and double there
    kOtherScene,    ///< other members, capacities or constants
    kDamaged,       ///< too short, too long, or the check sum is another
    /// A value out of its range under a good check sum: no accident. The only answer after which
    /// the state is not what it was: each member has a value that it may have, but they need not
    /// fit together.
    kOutOfRange,
};

namespace detail {

/// Of the format that save() writes; another one is not read.
inline constexpr std::uint16_t kSnapshotVersion = 1;
inline constexpr int kSnapshotHead = 20;  ///< bytes in front of the state
inline constexpr int kCheckSum = 4;       ///< bytes behind it

}  // namespace detail

/// Bytes with room for a saved T.
template <class T>
inline constexpr int kSnapshotRoom = detail::kSnapshotHead +
                                     static_cast<int>(sizeof(T)) + detail::kCheckSum;

namespace detail {

/// What stands in front of a state.
struct SnapshotHead {
  std::uint16_t version = kSnapshotVersion;  ///< of the format
  std::uint8_t scalar = 0;                   ///< bytes of a number: 4, 8; 0 where there are none
  std::uint64_t fingerprint = 0;             ///< of the state's type
  std::uint32_t length = 0;                  ///< bytes of the state
};

/// The head of a state. @param shape  has gone over the state  @param length  bytes of the state
SnapshotHead head_of(const ArchiveShape& shape, int length);
/// Writes the head to the front of `bytes`. @pre room for kSnapshotHead bytes
void write_head(const SnapshotHead& head, std::uint8_t* bytes);
/// Whether `bytes` begin with a head, and whether it is that of `wanted`, length apart. The length
/// found is put into `wanted`, for kOk and kOtherScene, and for kOtherVersion the version. @returns
/// kOk | kForeign | kOtherVersion | kOtherScalar | kOtherScene | kDamaged (too short)
Restored read_head(const std::uint8_t* bytes, int size, SnapshotHead& wanted);
/// Puts the check sum behind the `size` bytes. @pre room for kCheckSum more
void seal(std::uint8_t* bytes, int size);
/// Whether the last kCheckSum of `size` bytes are the check sum of those before.
bool is_sealed(const std::uint8_t* bytes, int size);

/// The head of a state, but for its length, which is 0. Bound: the members of the state.
template <class T>
SnapshotHead head_for(const T& state) {
  ArchiveShape shape;
  shape.look_at(state);
  return head_of(shape, 0);
}

}  // namespace detail

/// Writes a state as bytes: head, members, check sum.
/// @param[out] bytes  room for `capacity`; kSnapshotRoom<T> are enough
/// @returns kOk with the bytes used | kPoolFull | kInvalidArgument (a member out of its range)
/// Bound: the members of the state. Allocates: never.
template <class T>
Result<int> save(const T& state, std::uint8_t* bytes, int capacity) {
  if (capacity < detail::kSnapshotHead + detail::kCheckSum) return failure<int>(Status::kPoolFull);
  ArchiveWriter writer(bytes + detail::kSnapshotHead,
                       capacity - detail::kSnapshotHead - detail::kCheckSum);
  writer.look_at(state);
  if (!writer.ok()) return failure<int>(writer.status());
  detail::SnapshotHead head = detail::head_for(state);
  head.length = static_cast<std::uint32_t>(writer.position());
  detail::write_head(head, bytes);
  const int size = detail::kSnapshotHead + writer.position();
  detail::seal(bytes, size);
  return success(size + detail::kCheckSum);
}

/// Reads a state that save() wrote. Nothing is changed before scene and check sum are found to be
/// good.
/// @returns kOk, or why not (Restored); the state has changed for kOk and kOutOfRange alone
/// Bound: the members of the state. Allocates: never.
template <class T>
Restored restore(T& state, const std::uint8_t* bytes, int size) {
  detail::SnapshotHead head = detail::head_for(state);
  const Restored found = detail::read_head(bytes, size, head);
  if (found != Restored::kOk) return found;
  const auto length = static_cast<std::uint32_t>(size - detail::kSnapshotHead);
  if (length < detail::kCheckSum || head.length != length - detail::kCheckSum ||
      !detail::is_sealed(bytes, size)) {
    return Restored::kDamaged;
  }
  ArchiveReader reader(bytes + detail::kSnapshotHead, static_cast<int>(head.length));
  reader(state);
  return reader.is_done(static_cast<int>(head.length)) ? Restored::kOk : Restored::kOutOfRange;
}

}  // namespace batuta
