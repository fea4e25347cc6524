// SPDX-License-Identifier: MIT

#include "programs/duel/progress_bar.hpp"

#include <algorithm>

namespace batuta::host {

void ProgressBar::on_step(const DuelRunner& runner) {
  const bool log_writes = !runner.duel().events().empty() || !runner.duel().bout().touches.empty();
  if (log_writes) erase();
  const int percent = static_cast<int>(100 * std::min(1.0, runner.now() / runner.limit()));
  if (percent != shown_ && !log_writes) draw(percent);
}

void ProgressBar::draw(int percent) {
  constexpr int kCells = 40;
  std::fputs("\r[", out_);
  for (int i = 0; i < kCells; ++i) std::fputc(i * 100 < percent * kCells ? '#' : ' ', out_);
  std::fprintf(out_, "] %3d %%", percent);
  std::fflush(out_);
  shown_ = percent;
}

void ProgressBar::erase() {
  if (shown_ < 0) return;
  std::fputs("\r\033[K", out_);
  std::fflush(out_);
  shown_ = -1;
}

}  // namespace batuta::host
