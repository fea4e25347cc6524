// SPDX-License-Identifier: MIT

#include "programs/duel/run_record.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr int kBuffer = Recorder::kRoom<DuelRunner::DuelType>;

}  // namespace

RunRecord::RunRecord(FileSink& file)
    : buffer_(static_cast<std::size_t>(kBuffer)), recorder_(file, buffer_.data(), kBuffer) {}

void RunRecord::on_start(const DuelRunner& runner) {
  // A duel that its own settings made can be saved, and the buffer is made for it.
  (void)recorder_.begin<DuelInput>(runner.duel(), kHashEvery);
}

void RunRecord::on_step(const DuelRunner& runner) {
  DuelInput input;
  for (const Side side : {Side::kLeft, Side::kRight}) input.set(side, runner.bout().used(side));
  recorder_.step(input, runner.duel());
}

// A disk that is full takes no end mark: whoever closes the file hears of it.
void RunRecord::on_end(const DuelRunner& runner) {
  (void)recorder_.end(runner.duel());
  (void)recorder_.flush();
}

}  // namespace batuta::host
