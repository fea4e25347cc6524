// SPDX-License-Identifier: MIT
#include "samples.hpp"

namespace batuta::price {

bool SampleFile::open(const char* path) {
  file_ = digest::open_to_write(path);
  return file_ >= 0;
}

void SampleFile::add(const Sample& sample) {
  block_[filled_] = sample;
  ++filled_;
  if (filled_ == kBlock) flush();
}

bool SampleFile::close() {
  flush();
  return digest::close_file(file_) && ok_;
}

void SampleFile::flush() {
  ok_ = ok_ && digest::write_bytes(file_, block_, filled_ * sizeof(Sample));
  filled_ = 0;
}

}  // namespace batuta::price
