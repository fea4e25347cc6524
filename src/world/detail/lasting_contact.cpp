// SPDX-License-Identifier: MIT
#include "batuta/world/detail/lasting_contact.hpp"

namespace batuta::detail {
namespace {

template <class Traits, class Scalar>
void prepare_point(ContactPoint<Traits>& point, const SolvedBody<Scalar>& A,
                   const SolvedBody<Scalar>& B) {
  const Scalar mass = A.inverse_mass + B.inverse_mass;
  const Vec3<Scalar> from_B = arm_B(point, A, B);
  const auto turned_by = [&](const Vec3<Scalar>& d) {  // the turns of both, seen at the point
    const Vec3<Scalar> of_A = A.inverse_inertia_W * point.arm_A_W.cross(d);
    const Vec3<Scalar> of_B = B.inverse_inertia_W * from_B.cross(d);
    return Vec3<Scalar>(of_A.cross(point.arm_A_W) + of_B.cross(from_B));
  };
  point.softness = mass + point.normal_W.dot(turned_by(point.normal_W));
  if constexpr (Traits::kFriction) {
    const auto tangents = tangents_of(point.normal_W);
    const Vec3<Scalar> along = turned_by(tangents.along_W);
    const Vec3<Scalar> across = turned_by(tangents.across_W);
    point.softness_across = {mass + tangents.along_W.dot(along), tangents.across_W.dot(along),
                             mass + tangents.across_W.dot(across)};
  }
}

/// The impulse of the step over what was left of it; 0 where nothing was left. Of the rolling
/// resistance that was spent nothing is kept: it went with the normal impulse.
template <class Traits, class Scalar = typename Traits::Scalar>
Scalar whole_of_left(const ContactPoint<Traits>& point) {
  const Scalar whole = point.normal + point.spent_normal;
  return point.normal > Scalar(0) ? whole / point.normal : Scalar(0);
}

}  // namespace

template <class Traits, class Scalar>
void prepare(LastingContact<Traits>& contact, const SolvedBody<Scalar>& A,
             const SolvedBody<Scalar>& B, Scalar time) {
  constexpr Scalar kUpTo = Scalar(0.6);      // of D: what is nearer may not approach (world.md)
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.room = max_of(Scalar(0), point.gap - kUpTo * contact.rest_gap) / time;
    point.opening = 0;
    prepare_point(point, A, B);
  }
}

template <class Traits, class Scalar>
Scalar fastest_approach(const LastingContact<Traits>& contact, const SolvedBody<Scalar>& A,
                        const SolvedBody<Scalar>& B) {
  Scalar fastest = std::numeric_limits<Scalar>::max();
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    fastest = min_of(fastest, point.normal_W.dot(velocity_across(point, A, B)));
  }
  return fastest;
}

template <class Traits, class Scalar>
void push_share(const LastingContact<Traits>& contact, SolvedBody<Scalar>& A, SolvedBody<Scalar>& B,
                Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    const auto& point = contact.points[static_cast<std::size_t>(i)];
    push_at<Traits, Scalar>(point, A, B, share * impulse_at(point).J_W);
    if constexpr (Traits::kRolling) {
      A.w_W += A.inverse_inertia_W * (share * point.rolling_W);
      B.w_W -= B.inverse_inertia_W * (share * point.rolling_W);
    }
  }
}

template <class Traits, class Scalar>
void scale_impulses(LastingContact<Traits>& contact, Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.normal *= share;
    if constexpr (Traits::kFriction) {
      point.along *= share;
      point.across *= share;
    }
    if constexpr (Traits::kRolling) point.rolling_W *= share;
  }
}

template <class Traits, class Scalar>
void spend(LastingContact<Traits>& contact, Scalar share) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    point.spent_normal += share * point.normal;
    point.normal -= share * point.normal;
    if constexpr (Traits::kFriction) {
      point.spent_along += share * point.along;
      point.spent_across += share * point.across;
      point.along -= share * point.along;
      point.across -= share * point.across;
    }
    if constexpr (Traits::kRolling) point.rolling_W -= share * point.rolling_W;
  }
}

template <class Traits>
void take_together(LastingContact<Traits>& contact) {
  for (int i = 0; i < contact.count; ++i) {  // Bound: 2
    auto& point = contact.points[static_cast<std::size_t>(i)];
    if constexpr (Traits::kRolling) point.rolling_W *= whole_of_left(point);
    point.normal += point.spent_normal;
    point.spent_normal = 0;
    if constexpr (Traits::kFriction) {
      point.along += point.spent_along;
      point.across += point.spent_across;
      point.spent_along = point.spent_across = 0;
    }
  }
}

#define BATUTA_INSTANTIATE_CONTACT(S, F, R, L)                                               \
  template void prepare(LastingContact<ContactTraits<S, F, R, L>>&, const SolvedBody<S>&,    \
                        const SolvedBody<S>&, S);                                            \
  template S fastest_approach(const LastingContact<ContactTraits<S, F, R, L>>&,              \
                              const SolvedBody<S>&, const SolvedBody<S>&);                   \
  template void push_share(const LastingContact<ContactTraits<S, F, R, L>>&, SolvedBody<S>&, \
                           SolvedBody<S>&, S);                                               \
  template void scale_impulses(LastingContact<ContactTraits<S, F, R, L>>&, S);               \
  template void spend(LastingContact<ContactTraits<S, F, R, L>>&, S);                        \
  template void take_together(LastingContact<ContactTraits<S, F, R, L>>&);
#define BATUTA_INSTANTIATE(S) BATUTA_FOR_EACH_CONTACT(BATUTA_INSTANTIATE_CONTACT, S)
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_INSTANTIATE_CONTACT

}  // namespace batuta::detail
