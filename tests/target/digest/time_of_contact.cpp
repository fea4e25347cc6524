// SPDX-License-Identifier: MIT
#include "batuta/detection/search.hpp"
#include "fields.hpp"
#include "sections.hpp"

namespace batuta::digest {
namespace {

MovingCapsule<float> read_moving(Record& record, float duration) {
  MovingCapsule<float> moving;
  moving.motion.duration = duration;
  moving.motion.X_WB.p_W = record.vector();
  moving.motion.X_WB.q_WB = renewed(record.quaternion());
  moving.motion.twist.v_W = record.vector();
  moving.motion.twist.w_W = record.vector();
  moving.capsule_B.axis.a = record.vector();
  moving.capsule_B.axis.b = record.vector();
  moving.capsule_B.radius = record.number();
  return moving;
}

bool turns(const MovingCapsule<float>& moving) {
  return moving.motion.twist.w_W != Vec3<float>::Zero();
}

/// The paper's search takes up to millions of steps: the first of them show its arithmetic as well.
SteppingOptions<float> few_steps() {
  SteppingOptions<float> options;
  options.max_steps = 16;
  return options;
}

/// As many as the longest of these queries takes (36), with room: every answer is one.
AdvancementOptions<float> enough_evaluations() {
  AdvancementOptions<float> options;
  options.budget = 64;
  return options;
}

template <class Search>
void record_search(Recorder& recorder, Section section, std::uint32_t line,
                   const Result<MovingPair<float>>& pair, const typename Search::Options& options) {
  Answer answer = recorder.begin(section, line);
  answer.add("status", pair.status);
  if (pair.ok()) {
    answer.add("scale", pair.value.scale);
    add(answer, Search::search(pair.value, options, Vec3<float>::Zero()));
  }
  recorder.end(section, line, answer);
}

void answer_query(Record& record, std::uint32_t line, Recorder& recorder) {
  const float duration = record.number();
  const MovingCapsule<float> A = read_moving(record, duration);
  const MovingCapsule<float> B = read_moving(record, duration);
  const auto pair = make_moving_pair(A, B);
  if (recorder.wants(Section::kToc, line)) {
    record_search<Advancement<float>>(recorder, Section::kToc, line, pair, enough_evaluations());
  }
  if (recorder.wants(Section::kTranslation, line) && !turns(A) && !turns(B)) {
    record_search<Translation<float>>(recorder, Section::kTranslation, line, pair,
                                      enough_evaluations());
  }
  if (recorder.wants(Section::kStepping, line)) {
    record_search<Stepping<float>>(recorder, Section::kStepping, line, pair, few_steps());
  }
}

}  // namespace

void answer_times_of_contact(Input& input, Recorder& recorder) {
  Record record;
  for (std::uint32_t line = 1; input.next(record); ++line) {  // Bound: lines of the file
    const bool wanted = recorder.wants(Section::kToc, line) ||
                        recorder.wants(Section::kTranslation, line) ||
                        recorder.wants(Section::kStepping, line);
    if (wanted) answer_query(record, line, recorder);
  }
}

}  // namespace batuta::digest
