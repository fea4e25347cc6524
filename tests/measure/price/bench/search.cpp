// SPDX-License-Identifier: MIT
#include "batuta/detection/search.hpp"
#include "measure.hpp"
#include "ticks.hpp"

namespace batuta::price {
namespace {

using Options = AdvancementOptions<float>;

MovingCapsule<float> read_moving(digest::Record& record, float duration) {
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

/// What one evaluation more costs: a search that is cut after two against one cut after one.
/// @pre the whole search takes more than two
std::uint32_t ticks_of_one_more(const MovingPair<float>& pair) {
  Options options;
  SearchResult<float> found;
  options.budget = 1;
  const std::uint32_t one = ticks_of([&] { found = search_advancement(pair, options); });
  options.budget = 2;
  const std::uint32_t two = ticks_of([&] { found = search_advancement(pair, options); });
  return two - one;
}

void measure(digest::Record& record, std::uint32_t index, SampleFile& out) {
  const float duration = record.number();
  const MovingCapsule<float> A = read_moving(record, duration);
  const MovingCapsule<float> B = read_moving(record, duration);
  Result<MovingPair<float>> pair;
  const std::uint32_t making = ticks_of([&] { pair = make_moving_pair(A, B); });
  out.add({Kind::kMakePair, index, making, {}});
  SearchResult<float> found;
  const Options options;
  const std::uint32_t searching =
      ticks_of([&] { found = search_advancement(pair.value, options); });
  const std::uint32_t more = found.evaluations > 2 ? ticks_of_one_more(pair.value) : 0;
  out.add({Kind::kSearch,
           index,
           searching,
           {static_cast<std::uint32_t>(found.outcome), found.evaluations, more}});
}

}  // namespace
}  // namespace batuta::price

void price_search(const batuta::price::Task& task) {
  batuta::digest::Record record;
  for (std::uint32_t i = 0; task.input.next(record); ++i) {  // Bound: the records of the chunk
    if (i % task.every == 0) batuta::price::measure(record, i, task.out);
  }
}
