// SPDX-License-Identifier: MIT
#include "event_loop.hpp"

#include <algorithm>
#include <cmath>

#include "batuta/response/impulse.hpp"

namespace batuta::test {

std::vector<Happening> EventLoop::step(double dt, int grid, int most_events) {
  const int count = static_cast<int>(bodies_.size());
  courses_.resize(bodies_.size());
  for (int i = 0; i < count; ++i) plan(i, 0, dt);
  std::vector<Happening> happened;
  double now = 0;
  while (static_cast<int>(happened.size()) < most_events) {
    Happening first{dt, -1, -1};
    for (int a = 0; a < count; ++a) {
      for (int b = a + 1; b < count; ++b) {
        const double time = first_contact(a, b, now, first.time, dt / grid);
        if (time < first.time) first = {time, a, b};
      }
    }
    if (first.first < 0) break;
    answer(first, dt);
    now = first.time;
    happened.push_back(first);
  }
  for (int i = 0; i < count; ++i) bodies_[static_cast<std::size_t>(i)].body.X_WB = pose(i, dt);
  return happened;
}

Pose<double> EventLoop::pose(int body, double t) const {
  const Course& course = courses_[static_cast<std::size_t>(body)];
  return pose_at(course.motion, t - course.start);
}

CapsuleGap<double> EventLoop::nearest(int a, int b, double t) const {
  const Pose<double> X_WA = pose(a, t);
  const Pose<double> X_WB = pose(b, t);
  CapsuleGap<double> least;
  least.gap = std::numeric_limits<double>::max();
  for (const auto& part_A : bodies_[static_cast<std::size_t>(a)].parts_B) {
    for (const auto& part_B : bodies_[static_cast<std::size_t>(b)].parts_B) {
      const auto gap = capsule_gap(to_world(X_WA, part_A), to_world(X_WB, part_B));
      if (gap.gap < least.gap) least = gap;
    }
  }
  return least;
}

/// Where the gap goes from above zero to below; `end` if it does not.
double EventLoop::first_contact(int a, int b, double from, double end, double pace) const {
  constexpr int kHalvings = 60;
  bool was_open = nearest(a, b, from).gap > 0;
  const int last = static_cast<int>(std::ceil((end - from) / pace));
  for (int i = 1; i <= last; ++i) {
    double closed = std::min(from + i * pace, end);
    const bool is_open = nearest(a, b, closed).gap > 0;
    if (was_open && !is_open) {
      double open = from + (i - 1) * pace;
      for (int k = 0; k < kHalvings; ++k) {
        const double middle = (open + closed) / 2;
        (nearest(a, b, middle).gap > 0 ? open : closed) = middle;
      }
      return open;
    }
    was_open = is_open;
  }
  return end;
}

void EventLoop::plan(int body, double now, double end) {
  const auto i = static_cast<std::size_t>(body);
  courses_[i] = {free_flight(bodies_[i].body, end - now), now};
}

void EventLoop::answer(const Happening& happening, double end) {
  Rigid& A = bodies_[static_cast<std::size_t>(happening.first)];
  Rigid& B = bodies_[static_cast<std::size_t>(happening.second)];
  const auto gap = nearest(happening.first, happening.second, happening.time);
  A.body.X_WB = pose(happening.first, happening.time);
  B.body.X_WB = pose(happening.second, happening.time);
  const Contact<double> contact = contact_from(gap, Vec3<double>::Zero().eval());
  const auto hit = collision_impulse(collider_of(A.body), collider_of(B.body), contact,
                                     std::max(A.restitution, B.restitution));
  A.body.momentum.linear_W += hit.value.on_A.linear_W;
  A.body.momentum.angular_W += hit.value.on_A.angular_W;
  B.body.momentum.linear_W += hit.value.on_B.linear_W;
  B.body.momentum.angular_W += hit.value.on_B.angular_W;
  plan(happening.first, happening.time, end);
  plan(happening.second, happening.time, end);
}

}  // namespace batuta::test
