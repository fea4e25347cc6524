// SPDX-License-Identifier: MIT
#include "batuta/record/snapshot.hpp"

#include "batuta/core/crc32.hpp"

namespace batuta {
namespace {

constexpr std::uint32_t kMagic = 0x53544142U;  // "BATS"

struct HeadBytes {
  std::uint32_t magic = kMagic;
  detail::SnapshotHead head;
  std::uint8_t zero = 0;

  void archive(Archive& ar) {
    ar(magic, head.version, head.scalar, zero, head.fingerprint, head.length);
  }
};

}  // namespace

detail::SnapshotHead detail::head_of(const ArchiveShape& shape, int length) {
  detail::SnapshotHead head;
  head.scalar = shape.scalar();
  head.fingerprint = shape.fingerprint();
  head.length = static_cast<std::uint32_t>(length);
  return head;
}

void detail::write_head(const detail::SnapshotHead& head, std::uint8_t* bytes) {
  ArchiveWriter writer(bytes, detail::kSnapshotHead);
  HeadBytes words;
  words.head = head;
  writer(words);
  BATUTA_INVARIANT(writer.position() == detail::kSnapshotHead);
}

Restored detail::read_head(const std::uint8_t* bytes, int size, detail::SnapshotHead& wanted) {
  ArchiveReader reader(bytes, size);
  HeadBytes words;
  words.magic = 0;
  reader(words);
  if (words.magic != kMagic) return Restored::kForeign;
  if (!reader.ok()) return Restored::kDamaged;
  const detail::SnapshotHead& head = words.head;
  if (head.version != wanted.version) {
    wanted.version = head.version;
    return Restored::kOtherVersion;
  }
  if (words.zero != 0) return Restored::kDamaged;  // no file of this version has it
  if (head.scalar != wanted.scalar) return Restored::kOtherScalar;
  wanted.length = head.length;
  if (head.fingerprint != wanted.fingerprint) return Restored::kOtherScene;
  return Restored::kOk;
}

void detail::seal(std::uint8_t* bytes, int size) {
  std::uint32_t sum = crc32(bytes, size);
  ArchiveWriter writer(bytes + size, detail::kCheckSum);
  writer(sum);
}

bool detail::is_sealed(const std::uint8_t* bytes, int size) {
  if (size < detail::kCheckSum) return false;
  const int count = size - detail::kCheckSum;
  std::uint32_t sum = 0;
  ArchiveReader reader(bytes + count, detail::kCheckSum);
  reader(sum);
  return sum == crc32(bytes, count);
}

}  // namespace batuta
