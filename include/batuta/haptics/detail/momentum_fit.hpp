// SPDX-License-Identifier: MIT
#pragma once
// Mass, damping, friction, spring, offset and delay of an axis by least squares on its momentum, in
// windows of smooth weight: nothing is differentiated but the weight. Units: force in shares of the
// range, time in periods. Mathematics: src/haptics/device_measurement.md.

#include <array>

#include "batuta/core/types.hpp"

namespace batuta::detail {

/// What a fit says of a number.
struct Fitted {
  float value = 0;
  float sigma = 0;  ///< standard error
};

/// Fit of u(t - delay) = mass q'' + damping q' + friction sgn q' + stiffness q + offset.
struct MomentumResult {
  Fitted mass;           ///< shares periods^2/u
  Fitted damping;        ///< shares periods/u
  Fitted friction;       ///< shares
  Fitted stiffness;      ///< shares/u
  Fitted offset;         ///< shares
  Fitted delay;          ///< periods
  float residual = 0;    ///< root mean square of what is left, shares
  float expected = 0;    ///< of that, what the encoder makes
  float response = 0;    ///< root mean square of the force, shares
  float coarsest = 0;    ///< step of an encoder that would make all that is left, u
  bool is_good = false;  ///< all directions were seen, and a delay within the range
};

/// Of one axis. Allocates: never.
class MomentumFit {
 public:
  static constexpr int kWindow = 64;     ///< periods
  static constexpr int kHop = 16;        ///< periods from one window to the next
  static constexpr int kMostDelay = 16;  ///< whole periods
  static constexpr int kUnknowns = 5;    ///< beside the delay
  static constexpr int kDelays = kMostDelay + 2;
  static constexpr int kColumns = kUnknowns + kDelays;

  /// A period. @param position  at its end, u; of no meaning where not `fresh`
  /// @param applied  share that the device was told at its beginning  @pre finite
  /// Bound: kWindow kDelays + kColumns^2.
  void take(float position, float applied, bool fresh);

  /// Windows that were used.
  int rows() const { return rows_; }
  /// @param encoder_step  u  Bound: 5 kMostDelay kColumns.
  MomentumResult solve(float encoder_step) const;

 private:
  static constexpr int kRing = 128;  ///< a power of two, > kWindow + kDelays
  using Row = std::array<float, kColumns>;

  float position(int back) const { return positions_[static_cast<unsigned>(at_ - back) % kRing]; }
  float applied(int back) const { return applied_[static_cast<unsigned>(at_ - back) % kRing]; }
  int way() const;
  void add_window(int way);
  void rotate_in(Row& row);

  std::array<float, kRing> positions_{};
  std::array<float, kRing> applied_{};  ///< share over the period that ends here
  std::array<Row, kColumns> R_{};       ///< upper triangle
  int at_ = kRing;                      ///< the latest, modulo kRing
  int run_ = 0;                         ///< samples without a hole, at most kWindow + 1
  int steps_ = 0;                       ///< at most kDelays + kWindow
  int hop_ = 0;
  int rows_ = 0;
};

}  // namespace batuta::detail
