// SPDX-License-Identifier: MIT
#include "batuta/geometry/capsule.hpp"
#include "fields.hpp"
#include "sections.hpp"

namespace batuta::digest {
namespace {

Segment<float> read_segment(Record& record) {
  const Vec3<float> a = record.vector();
  return {a, record.vector()};
}

void answer_distance(Record& record, Answer& answer) {
  const Segment<float> A = read_segment(record);
  const Segment<float> B = read_segment(record);
  const ClosestPoints<float> closest = closest_points(A, B);
  add(answer, closest);
  const PointOnSegment<float> on_B = closest_point(B, A.a);
  answer.add("s_on_B", on_B.s);
  answer.add("point_on_B", on_B.point);
  answer.add("distance_to_B", on_B.distance);
  // Radii of half and three quarters of the distance: the capsules overlap.
  add(answer, capsule_gap<float>({A, closest.distance * 0.5F}, {B, closest.distance * 0.75F}));
}

}  // namespace

void answer_distances(Input& input, Recorder& recorder) {
  Record record;
  for (std::uint32_t line = 1; input.next(record); ++line) {  // Bound: lines of the file
    if (!recorder.wants(Section::kDistance, line)) continue;
    Answer answer = recorder.begin(Section::kDistance, line);
    answer_distance(record, answer);
    recorder.end(Section::kDistance, line, answer);
  }
}

}  // namespace batuta::digest
