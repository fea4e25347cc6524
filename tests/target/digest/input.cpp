// SPDX-License-Identifier: MIT
#include "input.hpp"

namespace batuta::digest {

bool Input::open(const char* path) {
  file_ = open_to_read(path);
  std::uint32_t magic = 0;
  ok_ = file_ >= 0 && word(magic) && magic == kMagic;
  return ok_;
}

void Input::close() {
  if (file_ >= 0) (void)close_file(file_);
  file_ = -1;
}

bool Input::word(std::uint32_t& value) {
  if (next_ == filled_) {
    filled_ = read_bytes(file_, block_.data(), sizeof block_) / sizeof(std::uint32_t);
    next_ = 0;
    if (filled_ == 0) return false;
  }
  value = block_[next_];
  ++next_;
  return true;
}

bool Input::next(ChunkHead& head) {
  Record passed_over;
  while (next(passed_over)) continue;  // Bound: records of the chunk
  if (!ok_ || !word(head.chunk)) return false;
  ok_ = word(head.records) && word(head.words) && word(head.parameter) && head.words <= kMostWords;
  records_left_ = ok_ ? head.records : 0;
  words_ = head.words;
  return ok_;
}

bool Input::next(Record& record) {
  if (records_left_ == 0) return false;
  --records_left_;
  record.next_ = 0;
  for (std::uint32_t i = 0; i < words_; ++i) {  // Bound: kMostWords
    ok_ = ok_ && word(record.words_[i]);
  }
  if (!ok_) records_left_ = 0;
  return ok_;
}

}  // namespace batuta::digest
