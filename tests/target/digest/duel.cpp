// SPDX-License-Identifier: MIT
#include "batuta/fencing/duel.hpp"

#include <new>

#include "duel_fields.hpp"
#include "sections.hpp"

namespace batuta::digest {
using namespace fencing;
namespace {

using DuelType = Duel<>;

/// The one duel, too large for a stack; made anew for each recording.
DuelType& new_duel() {
  alignas(DuelType) static std::array<std::uint8_t, sizeof(DuelType)> place;
  return *new (place.data()) DuelType;
}

struct Sample {
  std::uint32_t step = 0;  ///< of the recording, at which the duel is given it
  Side side = Side::kLeft;
  InputSample input;
};

/// The samples of both sticks in the order in which they are due.
class Sticks {
 public:
  explicit Sticks(Input& input) : input_(input) { read(); }

  /// Takes out what is due at `step`. Bound: one sample a side.
  void take(std::uint32_t step) {
    given_ = {};
    while (more_ && next_.step == step) {
      samples_[index_of(next_.side)] = next_.input;
      given_[index_of(next_.side)] = true;
      read();
    }
  }
  /// Null where there is none.
  const InputSample* at(Side side) const {
    return given_[index_of(side)] ? &samples_[index_of(side)] : nullptr;
  }

 private:
  void read() {
    Record record;
    more_ = input_.next(record);
    next_.step = record.word();
    next_.side = record.word() == 0 ? Side::kLeft : Side::kRight;
    next_.input.time = record.word();
    next_.input.x = record.number();
    next_.input.y = record.number();
    next_.input.buttons = record.word();
    next_.input.sequence = record.word();
  }

  Input& input_;
  Sample next_;
  bool more_ = false;
  std::array<InputSample, 2> samples_;
  std::array<bool, 2> given_{};
};

Status start(DuelType& duel) {
  return duel.configure(duel_settings(), first_fencer<float>(), second_fencer<float>());
}

}  // namespace

void fence(Input& input, std::uint32_t number, std::uint32_t steps, Recorder& recorder) {
  if (!recorder.takes(Section::kDuel)) return;
  DuelType& duel = new_duel();
  Sticks sticks(input);
  Status status = start(duel);
  const std::uint32_t last = recorder.shortened(steps);
  for (std::uint32_t step = 0; step < last; ++step) {  // Bound: steps of the recording
    if (duel.bout().is_over()) status = start(duel);
    sticks.take(step);
    if (status == Status::kOk) status = duel.step(sticks.at(Side::kLeft), sticks.at(Side::kRight));
    Answer answer = recorder.begin(Section::kDuel, index_in(number, step));
    answer.add("status", status);
    add(answer, duel);
    recorder.end(Section::kDuel, index_in(number, step), answer);
  }
}

}  // namespace batuta::digest
