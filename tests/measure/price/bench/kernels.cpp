// SPDX-License-Identifier: MIT
#include "batuta/geometry/segment.hpp"
#include "batuta/response/impulse.hpp"
#include "measure.hpp"
#include "ticks.hpp"

namespace batuta::price {
namespace {

void measure_segments(digest::Record& record, std::uint32_t index, SampleFile& out) {
  Segment<float> A;
  Segment<float> B;
  for (Segment<float>* segment : {&A, &B}) {  // Bound: 2
    segment->a = record.vector();
    segment->b = record.vector();
  }
  ClosestPoints<float> closest;
  const std::uint32_t ticks = ticks_of([&] { closest = closest_points(A, B); });
  asm volatile("" : : "r"(&closest) : "memory");
  out.add({Kind::kSegment, index, ticks, {}});
}

Collider<float> read_party(digest::Record& record) {
  Collider<float> party;
  party.inverse_mass = 1 / record.number();
  party.inverse_moments = record.vector().cwiseInverse();
  party.X_WB.p_W = record.vector();
  party.X_WB.q_WB = renewed(record.quaternion());
  party.twist.v_W = record.vector();
  party.twist.w_W = record.vector();
  return party;
}

void measure_impulse(digest::Record& record, std::uint32_t index, SampleFile& out) {
  const Collider<float> A = read_party(record);
  const Collider<float> B = read_party(record);
  Contact<float> contact;
  contact.point_W = record.vector();
  contact.normal_BA_W = record.vector();
  const float restitution = record.number();
  Result<Impulse<float>> answer;
  const std::uint32_t ticks =
      ticks_of([&] { answer = collision_impulse(A, B, contact, restitution); });
  out.add({Kind::kImpulse, index, ticks, {answer.value.magnitude > 0 ? 1U : 0U, 0, 0}});
}

}  // namespace
}  // namespace batuta::price

void price_segments(const batuta::price::Task& task) {
  batuta::digest::Record record;
  for (std::uint32_t i = 0; task.input.next(record); ++i) {  // Bound: the records of the chunk
    if (i % task.every == 0) batuta::price::measure_segments(record, i, task.out);
  }
}

void price_impulses(const batuta::price::Task& task) {
  batuta::digest::Record record;
  for (std::uint32_t i = 0; task.input.next(record); ++i) {  // Bound: the records of the chunk
    if (i % task.every == 0) batuta::price::measure_impulse(record, i, task.out);
  }
}
