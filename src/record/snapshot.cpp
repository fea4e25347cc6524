// SPDX-License-Identifier: MIT
#include "batuta/record/snapshot.hpp"

#include "batuta/core/crc32.hpp"

namespace batuta {
namespace {

constexpr std::uint32_t kMagic = 0x53544142U;  // "BATS"

struct HeadBytes {
  std::uint32_t magic = kMagic;
  SnapshotHead head;
  std::uint8_t zero = 0;

  void archive(Archive& ar) {
    ar(magic, head.version, head.scalar, zero, head.fingerprint, head.length);
  }
};

}  // namespace

SnapshotHead head_of(const ArchiveShape& shape, int length) {
  SnapshotHead head;
  head.scalar = shape.scalar();
  head.fingerprint = shape.fingerprint();
  head.length = static_cast<std::uint32_t>(length);
  return head;
}

void write_head(const SnapshotHead& head, std::uint8_t* bytes) {
  ArchiveWriter writer(bytes, kSnapshotHead);
  HeadBytes words;
  words.head = head;
  writer(words);
  BATUTA_INVARIANT(writer.position() == kSnapshotHead);
}

Restored read_head(const std::uint8_t* bytes, int size, SnapshotHead& wanted) {
  ArchiveReader reader(bytes, size);
  HeadBytes words;
  words.magic = 0;
  reader(words);
  if (words.magic != kMagic) return Restored::kForeign;
  if (!reader.ok()) return Restored::kDamaged;
  const SnapshotHead& head = words.head;
  if (head.version != wanted.version || words.zero != 0) return Restored::kOtherVersion;
  if (head.scalar != wanted.scalar) return Restored::kOtherScalar;
  if (head.fingerprint != wanted.fingerprint) return Restored::kOtherScene;
  wanted.length = head.length;
  return Restored::kOk;
}

void seal(std::uint8_t* bytes, int size) {
  std::uint32_t sum = crc32(bytes, size);
  ArchiveWriter writer(bytes + size, kCheckSum);
  writer(sum);
}

bool is_sealed(const std::uint8_t* bytes, int size) {
  if (size < kCheckSum) return false;
  const int count = size - kCheckSum;
  std::uint32_t sum = 0;
  ArchiveReader reader(bytes + count, kCheckSum);
  reader(sum);
  return sum == crc32(bytes, count);
}

}  // namespace batuta
