// SPDX-License-Identifier: MIT
#pragma once
// The loop of the program: devices -> duel, one step after the other, with the sums that a summary
// needs. It neither prints nor allocates: observers are told after each step.

#include <array>
#include <chrono>
#include <limits>

#include "programs/devices/source.hpp"
#include "programs/duel/played_bout.hpp"

namespace batuta::host {

/// How a bout ended.
enum class Ending : std::uint8_t {
  kNone,    ///< it is still going on
  kWon,     ///< one fencer has more touches, when there were enough or the time was over
  kDouble,  ///< a bout to one touch, with two within the window
  kDraw,    ///< as many touches for either, when the recordings, or the time, were at an end
};

/// The touches of the left and the right fencer that count, with that of an exchange which nobody
/// has ended yet.
std::array<int, 2> score_of(const fencing::Bout<float>& bout);

/// Of one fencer's device.
struct DeviceTally {
  std::uint32_t samples = 0;  ///< handed out
  std::uint32_t refused = 0;  ///< not handed out: outside the stick's square
  bool ended = false;   ///< the recording was over before the bout; the stick stayed where it was
  double ended_at = 0;  ///< s
};

/// Sums over the bout.
struct Tally {
  std::array<DeviceTally, 2> devices;
  std::uint32_t beats = 0;   ///< contacts that began with a blow
  std::uint32_t begins = 0;  ///< contact events of each kind
  std::uint32_t persists = 0;
  std::uint32_t ends = 0;
  std::uint32_t events_dropped = 0;  ///< answered, but not recorded
  /// Not answered any more in their step: the blades were held
  std::uint32_t contacts_dropped = 0;
  /// Between the blades after any step, m
  float smallest_gap = std::numeric_limits<float>::infinity();
  float deepest_overlap = 0;  ///< found by a search when it began, m
  float longest_hold = 0;     ///< of a blade whose way was not known to be free, s
  std::uint64_t host_ns = 0;  ///< time in SteppedBout::step()
  std::uint64_t host_ns_worst = 0;
};

/// What bout it is.
struct BoutRules {
  int touches = 1;  ///< to which it goes
  SearchKind search = SearchKind::kAdvancement;
  float distance = fencing::Salle<float>().distance;  ///< of the fencers on guard, m
};

class DuelRunner {
 public:
  using DuelType = SeenDuel;
  static constexpr Microseconds kStep_us = 1000;
  /// Where no source ends: a bout of the preliminary rounds.
  static constexpr double kBoutLength = 180;

  /// @param limit  s; infinite: as long as the longest recording
  DuelRunner(Source& left, Source& right, double limit, const BoutRules& rules = {});

  /// Puts the fencers on guard.
  Status start();

  /// One step of kStep_us. @returns whether the bout goes on. @pre start() was kOk
  bool step();

  /// Of the last step(): other than kOk, there was none, and the bout has not come to its end.
  Status status() const { return status_; }
  Ending ending() const { return ending_; }
  const BoutRules& rules() const { return rules_; }
  const DuelType& duel() const { return bout_->duel(); }
  /// The duel with the forces on the sticks and the samples of the last step.
  const PlayedBout& bout() const { return *bout_; }
  const Tally& tally() const { return tally_; }
  const Source& source(fencing::Side side) const { return *sources_[index_of(side)]; }
  /// When the bout ends without a touch, s.
  double limit() const { return limit_; }
  /// Simulated time since the start, s.
  double now() const { return bout_->steps() * static_cast<double>(kStep_us) / 1e6; }

 private:
  const InputSample* read(fencing::Side side, InputSample& sample);
  void add_up(std::chrono::nanoseconds spent);
  Ending judge() const;

  std::array<Source*, 2> sources_;
  BoutRules rules_;
  std::unique_ptr<PlayedBout> bout_;
  Tally tally_;
  double limit_;
  Ending ending_ = Ending::kNone;
  Status status_ = Status::kOk;
};

}  // namespace batuta::host
