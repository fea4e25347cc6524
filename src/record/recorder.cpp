// SPDX-License-Identifier: MIT
#include "batuta/record/recorder.hpp"

namespace batuta {

bool Recorder::flush() {
  const int taken = sink_.write(buffer_, filled_);
  filled_ -= taken;
  if (taken > 0 && filled_ > 0) {
    std::memmove(buffer_, buffer_ + taken, static_cast<std::size_t>(filled_));
  }
  return filled_ == 0;
}

/// Room for at least so many bytes more.
bool Recorder::make_room(int bytes) {
  (void)flush();
  return capacity_ - filled_ >= bytes;
}

void Recorder::start(int bytes) {
  filled_ = bytes;
  steps_ = 0;
  lost_ = 0;
}

/// @pre the body stands behind the room for its head
void Recorder::close(detail::RecordKind kind, int body) {
  std::uint8_t* const record = buffer_ + filled_;
  record[0] = static_cast<std::uint8_t>(kind);
  record[1] = static_cast<std::uint8_t>(body);
  record[2] = static_cast<std::uint8_t>(body >> 8);
  detail::seal(record, detail::kRecordHead + body);
  filled_ += detail::kRecordHead + body + detail::kCheckSum;
  (void)flush();
}

}  // namespace batuta
