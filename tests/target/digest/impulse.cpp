// SPDX-License-Identifier: MIT
#include "batuta/response/impulse.hpp"

#include "fields.hpp"
#include "sections.hpp"

namespace batuta::digest {
namespace {

/// A body as a query describes it.
struct Party {
  Result<Body<float>> body;
  Twist<float> twist;

  Collider<float> collider() const {
    return {body.value.X_WB, twist, body.value.inverse_mass, body.value.inverse_moments};
  }
};

Party read_party(Record& record) {
  const float mass = record.number();
  const Vec3<float> moments = record.vector();
  Pose<float> pose;
  pose.p_W = record.vector();
  pose.q_WB = renewed(record.quaternion());
  Party party{make_body(pose, mass, moments), {}};
  party.twist.v_W = record.vector();
  party.twist.w_W = record.vector();
  return party;
}

/// What the body has after the impulse.
void add_after(Answer& answer, Body<float> body, const Twist<float>& twist) {
  body.momentum = momentum_of(body, twist);
  add(answer, body.momentum);
  answer.add("energy", kinetic_energy(body));
}

void answer_impulse(Record& record, Answer& answer) {
  const Party A = read_party(record);
  const Party B = read_party(record);
  Contact<float> contact;
  contact.point_W = record.vector();
  contact.normal_BA_W = record.vector().normalized();
  answer.add("status_A", A.body.status);
  answer.add("status_B", B.body.status);
  if (!A.body.ok() || !B.body.ok()) return;
  const auto impulse = collision_impulse(A.collider(), B.collider(), contact, record.number());
  answer.add("status", impulse.status);
  if (!impulse.ok()) return;
  answer.add("magnitude", impulse.value.magnitude);
  answer.add("v_rel", impulse.value.v_rel);
  add(answer, impulse.value.on_A);
  add(answer, impulse.value.on_B);
  add(answer, impulse.value.twist_A);
  add(answer, impulse.value.twist_B);
  add_after(answer, A.body.value, impulse.value.twist_A);
  add_after(answer, B.body.value, impulse.value.twist_B);
}

}  // namespace

void answer_impulses(Input& input, Recorder& recorder) {
  Record record;
  for (std::uint32_t line = 1; input.next(record); ++line) {  // Bound: lines of the file
    if (!recorder.wants(Section::kImpulse, line)) continue;
    Answer answer = recorder.begin(Section::kImpulse, line);
    answer_impulse(record, answer);
    recorder.end(Section::kImpulse, line, answer);
  }
}

}  // namespace batuta::digest
