// SPDX-License-Identifier: MIT
#pragma once
// A duel as the program looks at it, whatever search it has.

#include "batuta/haptics/stick_forces.hpp"

namespace batuta::host {

/// How blades and touches are found.
enum class SearchKind : std::uint8_t {
  kAdvancement,  ///< nothing is missed
  kStepping,     ///< the paper's own, to compare with
};

/// Lower case, as on the command line.
inline const char* name_of(SearchKind search) {
  return search == SearchKind::kStepping ? "stepping" : "advancement";
}

using CertifiedDuel = fencing::Duel<>;
using PaperDuel = fencing::Duel<fencing::DuelScene<fencing::two_fencers, Stepping<float>>>;

class SeenDuel {
 public:
  using Events = std::decay_t<decltype(std::declval<CertifiedDuel>().world().events())>;

  SeenDuel() = default;
  SeenDuel(const SeenDuel&) = delete;
  SeenDuel& operator=(const SeenDuel&) = delete;
  virtual ~SeenDuel() = default;

  // As those of Duel.
  virtual const fencing::Bout<float>& bout() const = 0;
  virtual const fencing::DuelReport& report() const = 0;
  virtual std::uint32_t steps() const = 0;
  virtual float dt() const = 0;
  virtual std::uint64_t time_us(const fencing::Moment<float>& moment) const = 0;
  virtual const StickTracker<float>& stick(fencing::Side side) const = 0;
  virtual Capsule<float> blade_W(fencing::Side side) const = 0;
  virtual const fencing::BodyShape<float>& body_W(fencing::Side side) const = 0;
  virtual Pose<float> X_WF(fencing::Side side) const = 0;
  /// Of its world.
  virtual const Events& events() const = 0;
  virtual const StepReport<float>& step_report() const = 0;
  /// What the hands feel after its last step.
  virtual void feel(haptics::StickForces& forces, const std::array<bool, 2>& fresh) const = 0;
};

template <class DuelT>
class SeenDuelOf final : public SeenDuel {
 public:
  /// @param duel  outlives this
  explicit SeenDuelOf(const DuelT& duel) : duel_(duel) {}

  const fencing::Bout<float>& bout() const override { return duel_.bout(); }
  const fencing::DuelReport& report() const override { return duel_.report(); }
  std::uint32_t steps() const override { return duel_.steps(); }
  float dt() const override { return duel_.dt(); }
  std::uint64_t time_us(const fencing::Moment<float>& moment) const override {
    return duel_.time_us(moment);
  }
  const StickTracker<float>& stick(fencing::Side side) const override { return duel_.stick(side); }
  Capsule<float> blade_W(fencing::Side side) const override { return duel_.blade_W(side); }
  const fencing::BodyShape<float>& body_W(fencing::Side side) const override {
    return duel_.body_W(side);
  }
  Pose<float> X_WF(fencing::Side side) const override { return duel_.X_WF(side); }
  const Events& events() const override { return duel_.world().events(); }
  const StepReport<float>& step_report() const override { return duel_.world().report(); }
  void feel(haptics::StickForces& forces, const std::array<bool, 2>& fresh) const override {
    forces.advance(duel_, fresh);
  }

 private:
  const DuelT& duel_;
};

}  // namespace batuta::host
