// SPDX-License-Identifier: MIT
#pragma once
// The bout that the program plays, with the search that was asked for.

#include <memory>

#include "batuta/haptics/stepped_bout.hpp"
#include "batuta/record/duel.hpp"
#include "batuta/record/recorder.hpp"
#include "programs/duel/seen_duel.hpp"

namespace batuta::host {

class PlayedBout {
 public:
  PlayedBout() = default;
  PlayedBout(const PlayedBout&) = delete;
  PlayedBout& operator=(const PlayedBout&) = delete;
  virtual ~PlayedBout() = default;

  // As those of haptics::SteppedBout.
  virtual Status start(const haptics::BoutSettings& settings) = 0;
  virtual Status step(const InputSample* left, const InputSample* right) = 0;
  virtual const SeenDuel& duel() const = 0;
  virtual const haptics::StickForces& forces() const = 0;
  virtual const InputSample* used(fencing::Side side) const = 0;
  virtual bool is_alive(fencing::Side side) const = 0;
  std::uint32_t steps() const { return duel().steps(); }

  // As those of Recorder.
  virtual void begin(Recorder& recorder, std::uint32_t hash_every) const = 0;
  virtual void record(Recorder& recorder, const fencing::DuelInput& input) const = 0;
  virtual void end(Recorder& recorder) const = 0;

  virtual SearchKind search() const = 0;
  /// As a board plays it; null: no board has this search.
  virtual const haptics::SteppedBout* on_board() const = 0;
};

std::unique_ptr<PlayedBout> make_bout(SearchKind search);

/// Bytes that a recorder of either bout asks for.
inline constexpr int kRecorderRoom =
    max_of(Recorder::kRoom<CertifiedDuel>, Recorder::kRoom<PaperDuel>);

}  // namespace batuta::host
