// SPDX-License-Identifier: MIT

#include "programs/duel/run_record.hpp"

namespace batuta::host {
using namespace fencing;
RunRecord::RunRecord(FileSink& file)
    : buffer_(static_cast<std::size_t>(kRecorderRoom)),
      recorder_(file, buffer_.data(), kRecorderRoom) {}

void RunRecord::on_start(const DuelRunner& runner) {
  runner.bout().begin(recorder_, kHashEvery);
}

void RunRecord::on_step(const DuelRunner& runner) {
  DuelInput input;
  for (const Side side : {Side::kLeft, Side::kRight}) input.set(side, runner.bout().used(side));
  runner.bout().record(recorder_, input);
}

// A disk that is full takes no end mark: whoever closes the file hears of it.
void RunRecord::on_end(const DuelRunner& runner) {
  runner.bout().end(recorder_);
  (void)recorder_.flush();
}

}  // namespace batuta::host
