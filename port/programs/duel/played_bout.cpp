// SPDX-License-Identifier: MIT

#include "programs/duel/played_bout.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

template <class DuelT, SearchKind kSearch>
class PlayedBoutOf final : public PlayedBout {
 public:
  PlayedBoutOf() : duel_(bout_.duel()) {}

  Status start(const haptics::BoutSettings& settings) override { return bout_.start(settings); }
  Status step(const InputSample* left, const InputSample* right) override {
    return bout_.step(left, right);
  }
  const SeenDuel& duel() const override { return duel_; }
  const haptics::StickForces& forces() const override { return bout_.forces(); }
  const InputSample* used(Side side) const override { return bout_.used(side); }
  bool is_alive(Side side) const override { return bout_.is_alive(side); }

  // A duel that its own settings made can be saved, and the buffer is made for it.
  void begin(Recorder& recorder, std::uint32_t hash_every) const override {
    (void)recorder.begin<DuelInput>(bout_.duel(), hash_every);
  }
  void record(Recorder& recorder, const DuelInput& input) const override {
    recorder.step(input, bout_.duel());
  }
  void end(Recorder& recorder) const override { (void)recorder.end(bout_.duel()); }

  SearchKind search() const override { return kSearch; }
  const haptics::SteppedBout* on_board() const override {
    if constexpr (kSearch == SearchKind::kAdvancement) return &bout_;
    return nullptr;
  }

 private:
  haptics::SteppedBoutOf<DuelT> bout_;
  SeenDuelOf<DuelT> duel_;
};

}  // namespace

std::unique_ptr<PlayedBout> make_bout(SearchKind search) {
  if (search == SearchKind::kStepping) {
    return std::make_unique<PlayedBoutOf<PaperDuel, SearchKind::kStepping>>();
  }
  return std::make_unique<PlayedBoutOf<CertifiedDuel, SearchKind::kAdvancement>>();
}

}  // namespace batuta::host
