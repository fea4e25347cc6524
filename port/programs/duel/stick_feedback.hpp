// SPDX-License-Identifier: MIT
#pragma once
// The way from a bout back into the hands at this machine: for each live device with a force, an
// output stage, and what went through it.

#include <array>
#include <cstdio>
#include <optional>

#include "batuta/haptics/output_stage.hpp"
#include "programs/duel/observer.hpp"
#include "programs/live/live_force.hpp"

namespace batuta::host {

class StickFeedback final : public Observer {
 public:
  /// @param forces  of the fencers' devices, or null; they outlive this
  explicit StickFeedback(const std::array<LiveForce*, 2>& forces);
  /// No force either after a bout that was given up on its way.
  ~StickFeedback() override;

  void on_start(const DuelRunner& runner) override;
  void on_step(const DuelRunner& runner) override;
  /// No force, at once.
  void on_end(const DuelRunner& runner) override;

  /// Null: the fencer's device has none.
  LiveForce* force(fencing::Side side) const { return forces_[index_of(side)]; }
  /// @pre force(side) is not null
  const haptics::OutputStage& stage(fencing::Side side) const { return *stages_[index_of(side)]; }

 private:
  std::array<LiveForce*, 2> forces_;
  std::array<std::optional<haptics::OutputStage>, 2> stages_;
};

/// At the end, how well the forces came through: some lines for people, or for each force an object
/// of the type "force".
class ForceLog final : public Observer {
 public:
  /// @param feedback  outlives this
  ForceLog(std::FILE* out, bool json, const StickFeedback& feedback)
      : out_(out), json_(json), feedback_(feedback) {}

  void on_start(const DuelRunner& /*runner*/) override {}
  void on_step(const DuelRunner& /*runner*/) override {}
  void on_end(const DuelRunner& runner) override;

 private:
  void print(fencing::Side side, LiveForce& force) const;
  void write_json(fencing::Side side, LiveForce& force) const;

  std::FILE* out_;
  bool json_;
  const StickFeedback& feedback_;
};

}  // namespace batuta::host
