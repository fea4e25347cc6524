// SPDX-License-Identifier: MIT
#include "recorder.hpp"

#include "text.hpp"

namespace batuta::digest {

bool Recorder::open() {
  if (options_.hashes == nullptr) return true;
  file_ = open_to_write(options_.hashes);
  return file_ >= 0;
}

bool Recorder::close() {
  if (file_ < 0) return true;
  flush();
  const bool closed = close_file(file_);
  file_ = -1;
  return closed && written_;
}

void Recorder::end(Section section, std::uint32_t index, const Answer& answer) {
  const std::uint64_t hash = answer.hash();
  Sum& sum = sums_[static_cast<std::size_t>(section)];
  sum.digest.add(index);
  sum.digest.add(hash);
  ++sum.queries;
  if (file_ < 0) return;
  block_[filled_] = {static_cast<std::uint32_t>(section), index, static_cast<std::uint32_t>(hash),
                     static_cast<std::uint32_t>(hash >> 32U)};
  ++filled_;
  if (filled_ == kBlock) flush();
}

void Recorder::flush() {
  const auto bytes = static_cast<std::uint32_t>(filled_ * sizeof(HashRecord));
  written_ = write_bytes(file_, block_.data(), bytes) && written_;
  filled_ = 0;
}

void Recorder::print() const {
  if (options_.shown.any) return;
  for (std::size_t i = 0; i < kSections; ++i) {  // Bound: kSections
    if (sums_[i].queries == 0) continue;
    Text line;
    line << kSectionNames[i] << " queries " << sums_[i].queries << " every " << options_.every
         << " digest ";
    say((line.hex(sums_[i].digest.value()) << "\n").c_str());
  }
}

void Recorder::on_word(const char* field, std::uint32_t word) {
  Text line;
  line << field << " ";
  say((line.hex(word) << "\n").c_str());
}

}  // namespace batuta::digest
