// SPDX-License-Identifier: MIT
#pragma once
// The fields of what the library answers, all of them.

#include "answer.hpp"
#include "batuta/detection/moving_pair.hpp"
#include "batuta/response/contact.hpp"

namespace batuta::digest {

inline void add(Answer& answer, const ClosestPoints<float>& points) {
  answer.add("s", points.s);
  answer.add("u", points.u);
  answer.add("p_A", points.p_A);
  answer.add("p_B", points.p_B);
  answer.add("normal_AB", points.normal_AB);
  answer.add("distance", points.distance);
  answer.add("arbitrary", points.arbitrary);
}

inline void add(Answer& answer, const CapsuleGap<float>& gap) {
  answer.add("proximity", gap.proximity);
  answer.add("gap", gap.gap);
  add(answer, gap.axes);
  answer.add("surface_A", gap.surface_A);
  answer.add("surface_B", gap.surface_B);
}

inline void add(Answer& answer, const SearchResult<float>& result) {
  answer.add("outcome", result.outcome);
  answer.add("t_free", result.t_free);
  answer.add("t_hit", result.t_hit);
  answer.add("gap_rate", result.gap_rate);
  answer.add("evaluations", result.evaluations);
  add(answer, result.witness);
}

inline void add(Answer& answer, const Contact<float>& contact) {
  answer.add("point_W", contact.point_W);
  answer.add("normal_BA_W", contact.normal_BA_W);
  answer.add("contact_gap", contact.gap);
}

inline void add(Answer& answer, const Pose<float>& pose) {
  answer.add("p_W", pose.p_W);
  answer.add("q_WB", pose.q_WB);
}

inline void add(Answer& answer, const Twist<float>& twist) {
  answer.add("v_W", twist.v_W);
  answer.add("w_W", twist.w_W);
}

inline void add(Answer& answer, const Momentum<float>& momentum) {
  answer.add("momentum_linear_W", momentum.linear_W);
  answer.add("momentum_angular_W", momentum.angular_W);
}

inline void add(Answer& answer, const Capsule<float>& capsule) {
  answer.add("axis_a", capsule.axis.a);
  answer.add("axis_b", capsule.axis.b);
  answer.add("radius", capsule.radius);
}

}  // namespace batuta::digest
