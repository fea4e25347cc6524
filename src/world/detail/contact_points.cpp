// SPDX-License-Identifier: MIT
#include "batuta/world/detail/lasting_contact.hpp"

#include "batuta/geometry/direction.hpp"

namespace batuta::detail {
namespace {

/// Where axes run along each other: the ends of the shorter one are so near the other one that a
/// tilt within D is possible, times kTilt (world.md, "Lines").
template <class Scalar>
bool may_be_line(const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W, Scalar rest_gap) {
  constexpr Scalar kTilt = 128;
  const Vec3<Scalar> d_A = A_W.axis.direction();
  const Vec3<Scalar> d_B = B_W.axis.direction();
  const Scalar a = d_A.squaredNorm();
  const Scalar b = d_B.squaredNorm();
  const Scalar across = d_A.cross(d_B).squaredNorm();  // of both lengths and the angle
  const Scalar longer = max_of(a, b);
  return min_of(a, b) > Scalar(0) && across < kTilt * (A_W.radius + B_W.radius) * rest_gap * longer;
}

/// A point of a contact while it is looked for.
template <class Scalar>
struct FoundPoint {
  Vec3<Scalar> point_W = Vec3<Scalar>::Zero();
  Vec3<Scalar> normal_W = Vec3<Scalar>::UnitX();  ///< out of B
  Scalar gap = 0;                                 ///< m
  Scalar place = 0;                               ///< along the shorter axis, m
};

/// A point between two places on the axes; nearer to the smaller radius, where it is known best.
template <class Scalar>
FoundPoint<Scalar> point_between(const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
                                 const Vec3<Scalar>& on_A, const Vec3<Scalar>& on_B,
                                 const Vec3<Scalar>& normal_BA_W, Scalar gap) {
  FoundPoint<Scalar> point;
  point.normal_W = normal_BA_W;
  point.gap = gap;
  if (A_W.radius < B_W.radius) {
    point.point_W = on_A - (A_W.radius + gap / 2) * normal_BA_W;
  } else {
    point.point_W = on_B + (B_W.radius + gap / 2) * normal_BA_W;
  }
  return point;
}

/// The ends of a line of contact, and the closest points between or beyond them.
template <class Scalar>
struct LineEnds {
  std::array<FoundPoint<Scalar>, 2> ends;  ///< by place
  bool found = false;

  void offer(const FoundPoint<Scalar>& point) {
    if (!found) ends = {point, point};
    if (point.place < ends[0].place) ends[0] = point;
    if (point.place > ends[1].place) ends[1] = point;
    found = true;
  }
  Scalar span() const { return ends[1].place - ends[0].place; }
  /// Axes that cross a little are nearer to each other between the ends than at them. Then both
  /// ends are those of a straight line through the nearest point, with its normal and its gap: what
  /// holds at both ends holds between them.
  void dip_to(const FoundPoint<Scalar>& nearest, const Vec3<Scalar>& along) {
    const Scalar share = clamp((nearest.place - ends[0].place) / span(), Scalar(0), Scalar(1));
    const Scalar dip = ends[0].gap + share * (ends[1].gap - ends[0].gap) - nearest.gap;
    if (!(dip > Scalar(0))) return;
    for (FoundPoint<Scalar>& end : ends) {  // Bound: 2
      end.gap = nearest.gap;
      end.normal_W = nearest.normal_W;
      end.point_W = nearest.point_W + (end.place - nearest.place) * along;
    }
  }
};

/// The end of an axis over the other axis, where that is as near as the closest points, to D.
template <class Scalar>
void offer_end(LineEnds<Scalar>& line, const Capsule<Scalar>& A_W, const Capsule<Scalar>& B_W,
               int which, Scalar farthest, const Vec3<Scalar>& along) {
  const bool of_A = which < 2;
  const Segment<Scalar>& own = of_A ? A_W.axis : B_W.axis;
  const Vec3<Scalar> end = which % 2 == 0 ? own.a : own.b;
  const auto other = closest_point(of_A ? B_W.axis : A_W.axis, end);
  const Scalar gap = other.distance - A_W.radius - B_W.radius;
  const Vec3<Scalar> apart = end - other.point;
  if (!(gap < farthest) || is_zero(apart)) return;
  const Vec3<Scalar> outwards = unit<Scalar>(apart);
  const Vec3<Scalar> normal = of_A ? outwards : Vec3<Scalar>(-outwards);
  auto point = point_between<Scalar>(A_W, B_W, of_A ? end : other.point, of_A ? other.point : end,
                                     normal, gap);
  point.place = along.dot(point.point_W - A_W.axis.a);
  line.offer(point);
}

/// Old impulses, in the directions of a new point.
template <class Traits>
void carry(ContactPoint<Traits>& point, const ContactPoint<Traits>& old,
           typename Traits::Scalar share) {
  point.normal += share * old.normal;
  point.spent_normal += share * old.spent_normal;
  if constexpr (Traits::kFriction) {
    const auto from = tangents_of(old.normal_W);
    const auto to = tangents_of(point.normal_W);
    const auto solved = (old.along * from.along_W + old.across * from.across_W).eval();
    const auto spent = (old.spent_along * from.along_W + old.spent_across * from.across_W).eval();
    point.along += share * to.along_W.dot(solved);
    point.across += share * to.across_W.dot(solved);
    point.spent_along += share * to.along_W.dot(spent);
    point.spent_across += share * to.across_W.dot(spent);
  }
  if constexpr (Traits::kRolling) point.rolling_W += share * old.rolling_W;
}

/// Two points have become one, or one two.
template <class Traits>
void share_out(LastingContact<Traits>& contact,
               const std::array<ContactPoint<Traits>, LastingContact<Traits>::kPoints>& old) {
  using Scalar = typename Traits::Scalar;
  if constexpr (Traits::kLine) {
    auto& points = contact.points;
    if (contact.count == 1) {
      carry(points[0], old[0], Scalar(1));
      carry(points[0], old[1], Scalar(1));
      return;
    }
    const Scalar to_first = std::abs(old[0].place - points[0].place);
    const Scalar to_second = std::abs(old[0].place - points[1].place);
    const Scalar sum = to_first + to_second;
    carry(points[0], old[0], sum > Scalar(0) ? to_second / sum : Scalar(0.5));
    carry(points[1], old[0], sum > Scalar(0) ? to_first / sum : Scalar(0.5));
  }
}

/// The points of a contact become those that were found.
template <class Traits, class Scalar>
void put_points(LastingContact<Traits>& contact, const std::array<FoundPoint<Scalar>, 2>& found,
                int count, const Vec3<Scalar>& p_A_W, Scalar towards_A) {
  const auto old = contact.points;
  const int old_count = contact.is_new ? 0 : contact.count;
  contact.count = static_cast<std::uint8_t>(count);
  for (int i = 0; i < count; ++i) {  // Bound: 2
    const auto k = static_cast<std::size_t>(i);
    auto& point = contact.points[k];
    point = {};
    point.normal_W = found[k].normal_W;
    point.arm_A_W = found[k].point_W + towards_A * found[k].gap * point.normal_W - p_A_W;
    point.gap = found[k].gap;
    if constexpr (Traits::kLine) point.place = found[k].place;
    if (old_count == count) carry(point, old[k], Scalar(1));
  }
  if (old_count != 0 && old_count != count) share_out(contact, old);
}

}  // namespace

template <class Traits, class Scalar>
void find_points(LastingContact<Traits>& contact, const Capsule<Scalar>& A_W,
                 const Capsule<Scalar>& B_W, const ClosestPoints<Scalar>& axes,
                 const Vec3<Scalar>& p_A_W, Scalar towards_A) {
  const Scalar gap = axes.distance - A_W.radius - B_W.radius;
  auto nearest = point_between<Scalar>(A_W, B_W, axes.p_A, axes.p_B, -axes.normal_AB, gap);
  if constexpr (Traits::kLine) {
    const Vec3<Scalar> d_A = A_W.axis.direction();
    const Vec3<Scalar> d_B = B_W.axis.direction();
    const Vec3<Scalar> shorter = d_A.squaredNorm() < d_B.squaredNorm() ? d_A : d_B;
    const Scalar size = length(shorter);
    const Vec3<Scalar> along =
        size > Scalar(0) ? Vec3<Scalar>(shorter / size) : Vec3<Scalar>(Vec3<Scalar>::Zero());
    nearest.place = along.dot(nearest.point_W - A_W.axis.a);
    LineEnds<Scalar> ends;
    if (may_be_line(A_W, B_W, contact.rest_gap)) {
      for (int which = 0; which < 4; ++which) {  // Bound: four ends
        offer_end(ends, A_W, B_W, which, max_of(gap, Scalar(0)) + contact.rest_gap, along);
      }
    }
    if (ends.found) ends.offer(nearest);
    if (ends.found && ends.span() > min_of(A_W.radius, B_W.radius) / 16) {
      ends.dip_to(nearest, along);
      return put_points(contact, ends.ends, 2, p_A_W, towards_A);
    }
  }
  put_points<Traits, Scalar>(contact, {nearest, nearest}, 1, p_A_W, towards_A);
}

#define BATUTA_INSTANTIATE_CONTACT(S, F, R, L)                                             \
  template void find_points(LastingContact<ContactTraits<S, F, R, L>>&, const Capsule<S>&, \
                            const Capsule<S>&, const ClosestPoints<S>&, const Vec3<S>&, S);
#define BATUTA_INSTANTIATE(S) BATUTA_FOR_EACH_CONTACT(BATUTA_INSTANTIATE_CONTACT, S)
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE
#undef BATUTA_INSTANTIATE_CONTACT

}  // namespace batuta::detail
