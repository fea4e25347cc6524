// SPDX-License-Identifier: MIT

#include "batuta/haptics/coupling.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta {
namespace {

template <class Scalar>
Vec3<Scalar> limited(const Vec3<Scalar>& vector, Scalar limit) {
  const Scalar size = length(vector);
  return size > limit ? Vec3<Scalar>((limit / size) * vector) : vector;
}

/// How far, and how fast, `from` has to go to be where `to` is. Velocities of both are those of
/// their points at from's origin: only so does the damper never push what it should brake.
template <class Scalar>
struct Stretch {
  Vec3<Scalar> p_W;  ///< m
  Vec3<Scalar> v_W;  ///< m/s
  Vec3<Scalar> r_W;  ///< rotation vector, rad
  Vec3<Scalar> w_W;  ///< rad/s
};

template <class Scalar>
Stretch<Scalar> stretch_of(const MovingFrame<Scalar>& from, const MovingFrame<Scalar>& to) {
  const Vec3<Scalar> v_to_W = velocity_at(to.X_W, to.twist, from.X_W.p_W);
  return {to.X_W.p_W - from.X_W.p_W, v_to_W - from.twist.v_W,
          log_map(Quat<Scalar>(to.X_W.q_WB * from.X_W.q_WB.conjugate())),
          to.twist.w_W - from.twist.w_W};
}

template <class Scalar>
Wrench<Scalar> within_limits(const CouplingSettings<Scalar>& settings,
                             const Wrench<Scalar>& wrench) {
  return {limited(wrench.force_W, settings.max_force),
          limited(wrench.moment_W, settings.max_moment)};
}

/// Of a spring that pulls no harder than `limit`.
template <class Scalar>
Scalar spring_energy(Scalar stiffness, Scalar limit, Scalar stretch) {
  const Scalar pull = stiffness * stretch;
  if (!(pull > limit)) return pull * stretch / 2;
  return limit * (stretch - limit / stiffness / 2);
}

template <class Scalar>
bool is_finite_wrench(const Wrench<Scalar>& wrench) {
  return is_finite(wrench.force_W) && is_finite(wrench.moment_W);
}

/// What a spring and damper does to a mass at the end of the step: the force that, acting over it,
/// leads to the stretch and the speed from which it comes.
/// @param yielding  1/kg or 1/(kg m^2): how readily the mass gives way
template <class Scalar>
Scalar implicit_pull(Scalar stiffness, Scalar damping, Scalar yielding, Scalar dt, Scalar stretch,
                     Scalar rate) {
  const Scalar slope = dt * stiffness + damping;
  return (stiffness * stretch + slope * rate) / (Scalar(1) + dt * slope * yielding);
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
Wrench<Scalar> coupling_wrench(const CouplingSettings<Scalar>& settings,
                               const MovingFrame<Scalar>& commanded,
                               const MovingFrame<Scalar>& actual) {
  const Stretch<Scalar> stretch = stretch_of(commanded, actual);
  const Wrench<Scalar> wrench = within_limits<Scalar>(
      settings, {settings.stiffness * stretch.p_W + settings.damping * stretch.v_W,
                 settings.turn_stiffness * stretch.r_W + settings.turn_damping * stretch.w_W});
  return is_finite_wrench(wrench) ? wrench : Wrench<Scalar>{};
}

template <class Scalar>
Scalar stored_energy(const CouplingSettings<Scalar>& settings, const Pose<Scalar>& commanded_W,
                     const Pose<Scalar>& actual_W) {
  const Stretch<Scalar> stretch = stretch_of<Scalar>({commanded_W, {}}, {actual_W, {}});
  return spring_energy(settings.stiffness, settings.max_force, length(stretch.p_W)) +
         spring_energy(settings.turn_stiffness, settings.max_moment, length(stretch.r_W));
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
  Wrench<Scalar> pull;
  Vec3<Scalar> moment_B;
  for (int i = 0; i < 3; ++i) {  // Bound: three axes
    pull.force_W(i) = implicit_pull(settings.stiffness, settings.damping, body.inverse_mass, dt,
                                    stretch.p_W(i), stretch.v_W(i));
    moment_B(i) = implicit_pull(settings.turn_stiffness, settings.turn_damping,
                                body.inverse_moments(i), dt, r_B(i), w_B(i));
  }
  pull.moment_W = body.X_WB.q_WB * moment_B;
  pull = within_limits(settings, pull);
  const Status status = apply(body, pull.force_W, pull.moment_W, dt);
  if (status != Status::kOk) return failure<Wrench<Scalar>>(status);
  return success(Wrench<Scalar>{-pull.force_W, -pull.moment_W});
}

#define BATUTA_INSTANTIATE(S)                                                           \
  template Status validate(const CouplingSettings<S>&);                                 \
  template Wrench<S> coupling_wrench(const CouplingSettings<S>&, const MovingFrame<S>&, \
                                     const MovingFrame<S>&);                            \
  template S stored_energy(const CouplingSettings<S>&, const Pose<S>&, const Pose<S>&); \
  template Result<Wrench<S>> couple(const CouplingSettings<S>&, const MovingFrame<S>&, Body<S>&, S);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
