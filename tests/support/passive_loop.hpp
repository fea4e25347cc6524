// SPDX-License-Identifier: MIT
#pragma once
// A sampled spring on a simulated axis, with passivity observer and controller between it and the
// actuator.

#include "batuta/haptics/passivity.hpp"
#include "sampled_loop.hpp"

namespace batuta::test {

/// How the spring is closed around the stick.
struct Way {
  bool is_on = true;    ///< the controller; the observer always is
  bool is_told = true;  ///< what the spring stores
  int delay = 0;        ///< whole periods on the way to the actuator, < SampledLoop::kMostLag
};

template <class S>
class PassiveLoop {
 public:
  static constexpr double kDebt = 0.02;      ///< of the energy at first
  static constexpr double kRounding = 1e-3;  ///< as credit: bits of float positions

  /// The stick comes with a speed of 1. @pre no delay and no encoder in `settings`
  PassiveLoop(const LoopSettings& settings, const Way& way) : loop_(settings), way_(way) {
    loop_.place(0, 1);
    first_ = loop_.axis().energy();
    haptics::PassivitySettings<S> passive;
    passive.period = static_cast<S>(settings.axis.period);
    passive.device_damping = static_cast<S>(settings.axis.damping);
    passive.most_credit = static_cast<S>(way.is_told ? kRounding * first_ : first_);
    passive.most_debt = static_cast<S>(kDebt * first_);
    passive.largest_damping = passive.device_damping;
    passive.largest_force = S(1e6F);
    const Status status = observer_.configure(passive);
    BATUTA_ASSERT(status == Status::kOk);
    const Status placed = observer_.restart({S(0), S(0)});
    BATUTA_ASSERT(placed == Status::kOk);
  }

  /// Looks at the sample, and sends what is to be held.
  void look() {
    const double bent = loop_.seen();
    const double stored = way_.is_told ? 0.5 * loop_.settings().gains.stiffness * bent * bent : 0;
    const Status status = observer_.observe({static_cast<S>(loop_.held()), S(0)},
                                            {static_cast<S>(bent), S(0)}, static_cast<S>(stored));
    BATUTA_ASSERT(status == Status::kOk);
    const Vec2<S> demanded(static_cast<S>(loop_.demanded()), S(0));
    const Vec2<S> sent =
        way_.is_on ? haptics::passive_force(observer_, demanded).value.force : demanded;
    std::rotate(sent_.rbegin(), sent_.rbegin() + 1, sent_.rend());
    sent_[0] = static_cast<double>(sent.x());
  }

  /// A period passes.
  void pass() { loop_.step(sent_[static_cast<std::size_t>(way_.delay)]); }

  /// Of stick and hand, over the first: the plant's own book, which knows nothing of the observer.
  double energy() const { return loop_.axis().energy() / first_; }
  const haptics::PassivityObserver<S>& observer() const { return observer_; }

 private:
  SampledLoop loop_;
  Way way_;
  haptics::PassivityObserver<S> observer_;
  std::array<double, SampledLoop::kMostLag> sent_{};  ///< [0]: the latest
  double first_ = 1;
};

}  // namespace batuta::test
