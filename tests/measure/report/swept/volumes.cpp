// SPDX-License-Identifier: MIT
#include "volumes.hpp"

#include "ensemble.hpp"

namespace batuta::report {

namespace {

Aabb<double> in_double(const Aabb<float>& box) {
  Aabb<double> same;
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    same.low[i] = static_cast<double>(box.low[i]);
    same.high[i] = static_cast<double>(box.high[i]);
  }
  return same;
}

Aabb<double> box_of_sphere(const detail::SweptSphere<float>& swept) {
  Aabb<double> box;
  const auto radius = static_cast<double>(swept.radius);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const auto start = static_cast<double>(swept.start_W[i]);
    const auto end = static_cast<double>(swept.end_W[i]);
    box.low[k] = min_of(start, end) - radius;
    box.high[k] = max_of(start, end) + radius;
  }
  return box;
}

}  // namespace

const char* name(Form form) {
  switch (form) {
    case Form::kExact:
      return "exact";
    case Form::kCoarse:
      return "chord and sagitta";
    case Form::kSphere:
      return "sphere";
    default:
      return "end boxes";
  }
}

Aabb<double> sampled_box(const MovingCapsule<float>& moving, int samples) {
  const MovingCapsule<double> exact = test::cast<double>(moving);
  Vec3<double> low = Vec3<double>::Constant(std::numeric_limits<double>::max());
  Vec3<double> high = -low;
  for (int i = 0; i <= samples; ++i) {
    const double t = exact.motion.duration * i / samples;
    const Capsule<double> at = to_world(pose_at(exact.motion, t), exact.capsule_B);
    low = low.cwiseMin(at.axis.a.cwiseMin(at.axis.b));
    high = high.cwiseMax(at.axis.a.cwiseMax(at.axis.b));
  }
  Aabb<double> box;
  for (int i = 0; i < 3; ++i) {
    box.low[static_cast<std::size_t>(i)] = low[i] - exact.capsule_B.radius;
    box.high[static_cast<std::size_t>(i)] = high[i] + exact.capsule_B.radius;
  }
  return box;
}

Aabb<double> box_of(Form form, const MovingCapsule<float>& moving) {
  switch (form) {
    case Form::kExact:
      return in_double(swept_aabb(moving));
    case Form::kCoarse:
      return in_double(detail::coarse_swept_aabb(moving));
    case Form::kSphere:
      return box_of_sphere(detail::swept_sphere(moving));
    default:
      return sampled_box(moving, 1);
  }
}

double leak(const Aabb<double>& box, const Aabb<double>& inner) {
  double out = std::numeric_limits<double>::lowest();
  for (std::size_t i = 0; i < box.low.size(); ++i) {
    out = max_of(out, max_of(box.low[i] - inner.low[i], inner.high[i] - box.high[i]));
  }
  return out;
}

double volume(const Aabb<double>& box) {
  double product = 1;
  for (std::size_t i = 0; i < box.low.size(); ++i) product *= box.high[i] - box.low[i];
  return product;
}

}  // namespace batuta::report
