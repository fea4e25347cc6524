// SPDX-License-Identifier: MIT

#include "batuta/haptics/coupling.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta::haptics {
namespace {

/// Of the length of a limited vector, which is a unit vector times the limit: coupling.md.
template <class Scalar>
constexpr Scalar kRoundedLimit = Scalar(1) - Scalar(8) * kRoundOff<Scalar>;

/// Enough for axes that differ by twelve powers of ten: src/haptics/coupling.md.
constexpr int kEasings = 12;

template <class Scalar>
Vec3<Scalar> limited(const Vec3<Scalar>& vector, Scalar limit) {
  // By way of the direction: limit / length is no number for a spring stretched far enough.
  return length(vector) > limit ? Vec3<Scalar>(limit * unit(vector)) : vector;
}

/// How far, and how fast, `from` has to go to be where `to` is. Velocities of both are those of
/// their points at from's origin: only so does the damper never push what it should brake.
template <class Scalar>
struct Stretch {
  Vec3<Scalar> shift_W;  ///< m
  Vec3<Scalar> v_W;      ///< m/s
  Vec3<Scalar> r_W;      ///< rotation vector, rad
  Vec3<Scalar> w_W;      ///< rad/s
};

template <class Scalar>
Stretch<Scalar> stretch_of(const MovingFrame<Scalar>& from, const MovingFrame<Scalar>& to) {
  const Vec3<Scalar> v_to_W = velocity_at(to.X_W, to.twist, from.X_W.p_W);
  const Quat<Scalar> turn = to.X_W.q_WB * from.X_W.q_WB.conjugate();
  Vec3<Scalar> r_W = log_map(turn);  // none where the turn is not a number: that has to show
  if (!is_finite(turn)) r_W.setConstant(std::numeric_limits<Scalar>::quiet_NaN());
  return {to.X_W.p_W - from.X_W.p_W, v_to_W - from.twist.v_W, r_W, to.twist.w_W - from.twist.w_W};
}

template <class Scalar>
Wrench<Scalar> within_limits(const CouplingSettings<Scalar>& settings,
                             const Wrench<Scalar>& wrench) {
  return {limited(wrench.force_W, settings.max_force),
          limited(wrench.moment_W, settings.max_moment)};
}

/// Of a spring that pulls no harder than `limit`.
template <class Scalar>
Scalar spring_energy(Scalar stiffness, Scalar limit, const Vec3<Scalar>& stretch_W) {
  const Scalar stretch = is_finite(stretch_W) ? length(stretch_W) : stretch_W.sum();
  const Scalar pull = stiffness * stretch;
  if (!(pull > limit)) return pull * stretch / 2;
  return limit * (stretch - limit / stiffness / 2);
}

template <class Scalar>
bool is_finite_wrench(const Wrench<Scalar>& wrench) {
  return is_finite(wrench.force_W) && is_finite(wrench.moment_W);
}

/// What a spring and damper that pull no harder than `limit` do to a mass at the end of the step:
/// the pull that, acting over it, leads to the stretch and the speed from which it comes.
/// @param rigid  the pull on a mass that does not give way, by axis
/// @param gives  by how much of the pull the mass has given way at the end, by axis, >= 0
template <class Scalar>
Vec3<Scalar> implicit_pull(const Vec3<Scalar>& rigid, const Vec3<Scalar>& gives, Scalar limit) {
  const auto eased = [&rigid, &gives](Scalar ease) {
    return Vec3<Scalar>((rigid.array() / (gives.array() + ease)).matrix());
  };
  Scalar ease = 1;
  Vec3<Scalar> pull = eased(ease);
  for (int i = 0; i < kEasings && length(pull) > limit; ++i) {  // Bound: kEasings
    const Scalar spread = (unit(pull).array().square() / (gives.array() + ease)).sum();
    ease += (length(pull) / limit - Scalar(1)) / spread;
    if (!is_finite(ease)) break;
    pull = eased(ease);
  }
  return limited(pull, limit);
}

}  // namespace

template <class Scalar>
Status validate(const CouplingSettings<Scalar>& settings) {
  const auto good = [](Scalar x) { return is_finite(x) && x >= Scalar(0); };
  const bool all = good(settings.stiffness) && good(settings.damping) &&
                   good(settings.turn_stiffness) && good(settings.turn_damping) &&
                   is_positive(settings.max_force) && is_positive(settings.max_moment);
  return all ? Status::kOk : Status::kInvalidArgument;
}

template <class Scalar>
Wrench<Scalar> raw_coupling_wrench(const CouplingSettings<Scalar>& settings,
                                   const MovingFrame<Scalar>& commanded,
                                   const MovingFrame<Scalar>& actual) {
  const Stretch<Scalar> stretch = stretch_of(commanded, actual);
  return within_limits<Scalar>(
      settings, {settings.stiffness * stretch.shift_W + settings.damping * stretch.v_W,
                 settings.turn_stiffness * stretch.r_W + settings.turn_damping * stretch.w_W});
}

template <class Scalar>
Wrench<Scalar> coupling_wrench(const CouplingSettings<Scalar>& settings,
                               const MovingFrame<Scalar>& commanded,
                               const MovingFrame<Scalar>& actual) {
  const Wrench<Scalar> wrench = raw_coupling_wrench(settings, commanded, actual);
  return is_finite_wrench(wrench) ? wrench : Wrench<Scalar>{};
}

template <class Scalar>
bool is_at_limit(const CouplingSettings<Scalar>& settings, const Wrench<Scalar>& wrench) {
  return length(wrench.force_W) >= kRoundedLimit<Scalar> * settings.max_force ||
         length(wrench.moment_W) >= kRoundedLimit<Scalar> * settings.max_moment;
}

template <class Scalar>
Scalar stored_energy(const CouplingSettings<Scalar>& settings, const Pose<Scalar>& commanded_W,
                     const Pose<Scalar>& actual_W) {
  const Stretch<Scalar> stretch = stretch_of<Scalar>({commanded_W, {}}, {actual_W, {}});
  return spring_energy(settings.stiffness, settings.max_force, stretch.shift_W) +
         spring_energy(settings.turn_stiffness, settings.max_moment, stretch.r_W);
}

template <class Scalar>
Result<Wrench<Scalar>> couple(const CouplingSettings<Scalar>& settings,
                              const MovingFrame<Scalar>& commanded_W, Body<Scalar>& body,
                              Scalar dt) {
  if (!is_positive(dt)) return failure<Wrench<Scalar>>(Status::kInvalidArgument);
  const Stretch<Scalar> stretch = stretch_of({body.X_WB, twist_of(body)}, commanded_W);
  const Quat<Scalar> q_BW = body.X_WB.q_WB.conjugate();
  const Vec3<Scalar> r_B = q_BW * stretch.r_W;
  const Vec3<Scalar> w_B = q_BW * stretch.w_W;
  const Scalar slope = dt * settings.stiffness + settings.damping;
  const Scalar turn_slope = dt * settings.turn_stiffness + settings.turn_damping;
  const Vec3<Scalar> force_W = settings.stiffness * stretch.shift_W + slope * stretch.v_W;
  const Vec3<Scalar> moment_B = settings.turn_stiffness * r_B + turn_slope * w_B;
  const Vec3<Scalar> gives = Vec3<Scalar>::Constant(dt * slope * body.inverse_mass);
  const Vec3<Scalar> turn_gives = dt * turn_slope * body.inverse_moments;
  Wrench<Scalar> pull;
  pull.force_W = implicit_pull(force_W, gives, settings.max_force);
  pull.moment_W = body.X_WB.q_WB * implicit_pull(moment_B, turn_gives, settings.max_moment);
  const Status status = apply(body, pull.force_W, pull.moment_W, dt);
  if (status != Status::kOk) return failure<Wrench<Scalar>>(status);
  return success(Wrench<Scalar>{-pull.force_W, -pull.moment_W});
}

#define BATUTA_INSTANTIATE(S)                                                               \
  template Status validate(const CouplingSettings<S>&);                                     \
  template Wrench<S> raw_coupling_wrench(const CouplingSettings<S>&, const MovingFrame<S>&, \
                                         const MovingFrame<S>&);                            \
  template Wrench<S> coupling_wrench(const CouplingSettings<S>&, const MovingFrame<S>&,     \
                                     const MovingFrame<S>&);                                \
  template bool is_at_limit(const CouplingSettings<S>&, const Wrench<S>&);                  \
  template S stored_energy(const CouplingSettings<S>&, const Pose<S>&, const Pose<S>&);     \
  template Result<Wrench<S>> couple(const CouplingSettings<S>&, const MovingFrame<S>&, Body<S>&, S);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta::haptics
