// SPDX-License-Identifier: MIT
#pragma once
// A fencer of the library that sees (batuta/fencing/opponent.hpp), as a source of samples.

#include <optional>
#include <string>
#include <string_view>

#include "batuta/fencing/opponent.hpp"
#include "programs/devices/source.hpp"

namespace batuta::host {

/// Who plays, and which seed: one seed, one fencer.
struct SeeingScript {
  std::string_view name;
  fencing::Skill skill = fencing::Skill::kNovice;
  std::uint32_t seed = 1;
};

/// "novice", "club" or "master", with "@SEED" behind it or without.
std::optional<SeeingScript> seeing_script(std::string_view words);

/// Sees once a step, and moves its stick.
class SeeingDevice final : public Source {
 public:
  explicit SeeingDevice(const SeeingScript& script);

  std::string description() const override;
  double duration() const override;
  void rewind() override;
  bool sees() const override { return true; }
  void see(const fencing::Observation& sight, std::int32_t step_us) override;

 private:
  /// What the last see() came to. Bound: no loop.
  Status do_read(Microseconds now, InputSample& sample) override;

  SeeingScript script_;
  fencing::Opponent opponent_;
  std::uint32_t sequence_ = 0;
};

}  // namespace batuta::host
