// SPDX-License-Identifier: MIT
#pragma once
// Reads the file of queries in blocks (its form: section.hpp).

#include "answer.hpp"
#include "io.hpp"
#include "section.hpp"

namespace batuta::digest {

/// A record, taken field by field.
class Record {
 public:
  std::uint32_t word() {
    const std::uint32_t value = words_[next_];
    next_ = next_ + 1 == words_.size() ? 0 : next_ + 1;
    return value;
  }
  float number() { return float_of(word()); }
  Vec3<float> vector() {
    const float x = number();
    const float y = number();
    const float z = number();
    return {x, y, z};
  }
  /// As it is in the file: w first, and only nearly unit.
  Quat<float> quaternion() {
    const float w = number();
    const Vec3<float> xyz = vector();
    return {w, xyz.x(), xyz.y(), xyz.z()};
  }

 private:
  friend class Input;
  std::array<std::uint32_t, kMostWords> words_{};
  std::size_t next_ = 0;
};

class Input {
 public:
  /// @returns whether it is a file of queries
  bool open(const char* path);
  void close();

  /// The next chunk; what is left of the last one is passed over.
  /// @returns false at the end of the file, or where it makes no sense: ask ok()
  bool next(ChunkHead& head);
  /// The next record of the chunk. @returns false at its end, or where the file is cut off
  bool next(Record& record);

  bool ok() const { return ok_; }

 private:
  bool word(std::uint32_t& value);

  static constexpr std::size_t kBlockWords = 4096;
  std::array<std::uint32_t, kBlockWords> block_{};
  std::size_t next_ = 0;
  std::size_t filled_ = 0;
  File file_ = -1;
  std::uint32_t records_left_ = 0;
  std::uint32_t words_ = 0;
  bool ok_ = false;
};

}  // namespace batuta::digest
