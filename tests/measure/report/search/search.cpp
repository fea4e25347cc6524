// SPDX-License-Identifier: MIT
// Report on the searches: error of the time of contact against evaluations and host time, for every
// family of queries, scalar, method and setting.

#include <vector>

#include "measure.hpp"
#include "methods.hpp"

namespace batuta::report {
namespace {

constexpr std::uint64_t kSeed = 20061107;
constexpr double kBatchNs = 3000;  ///< least length of a timed batch, far above the clock's own
constexpr std::uint64_t kSlowTimed = 4;  ///< slow methods are timed every so many of their queries

/// The queries of one family that this run answers.
struct Batch {
  test::Family family;
  std::uint64_t first;       ///< index of the first
  std::uint64_t slow_every;  ///< slow methods are asked those whose index is a multiple of this
  std::uint64_t time_every;  ///< the others are timed on those whose index is a multiple of this
  std::vector<Case> cases;
};

template <class Scalar>
void take_time(Score& score, const Method<Scalar>& method, const Case& query, double plain) {
  const auto make = [&] {
    return make_moving_pair(query.first<Scalar>(), query.second<Scalar>()).value;
  };
  const auto pair = make();
  const auto once = [&] { keep(method.search(make(), method.setting)); };
  const double first = median_ns(1, once);
  if (first > kBatchNs) {  // long enough as it is
    const double setting_up = median_ns(100, [&] { keep(make()); });
    score.add_time(first, first - setting_up, plain);
    return;
  }
  const int calls = 1 + static_cast<int>(kBatchNs / first);
  const auto search = [&] { keep(method.search(pair, method.setting)); };
  score.add_time(median_ns(calls, once), median_ns(calls, search), plain);
}

template <class Scalar>
void judge(Score& score, const Method<Scalar>& method, const Case& query) {
  const auto pair = make_moving_pair(query.first<Scalar>(), query.second<Scalar>()).value;
  const Judged judged{query, method.contact_gap(pair, method.setting),
                      static_cast<double>(pair.scale)};
  score.add(method.search(pair, method.setting), judged);
}

template <class Scalar>
void run(Table& table, const Batch& batch, const Method<Scalar>& method) {
  const double plain = plain_ns();
  const std::uint64_t ask_every = method.is_slow ? batch.slow_every : 1;
  const std::uint64_t time_every = method.is_slow ? ask_every * kSlowTimed : batch.time_every;
  Score score;
  std::uint64_t index = batch.first;
  for (const Case& query : batch.cases) {
    if (index % ask_every == 0) judge(score, method, query);
    if (index % time_every == 0) take_time(score, method, query, plain);
    ++index;
  }
  table.key("family", test::name(batch.family))
      .key("scalar", std::is_same_v<Scalar, float> ? "float" : "double")
      .key("method", method.name)
      .key("swept", method.swept)
      .key("setting", method.setting);
  score.write(table);
}

template <class Scalar>
void run_all(Table& table, const Batch& batch, Progress& progress) {
  for (const Method<Scalar>& method : methods<Scalar>(test::turns(batch.family))) {
    run(table, batch, method);
  }
  progress.advance();
}

std::vector<Case> make_cases(test::Family family, Range range) {
  std::vector<Case> cases;
  cases.reserve(range.last - range.first);
  for (std::uint64_t i = range.first; i < range.last; ++i) {
    cases.push_back(make_case(family, kSeed, i));
  }
  return cases;
}

int report_search(const Options& options) {
  const Range range = share_of(options, pick(options, 6, 1000, 20000));
  const std::uint64_t slow_every = pick(options, 3, 25, 5);
  const std::uint64_t time_every = pick(options, 3, 10, 20);
  Table table(options, "search");
  Progress progress("search: families x scalars", 2 * test::kFamilyCount);
  for (const test::Family family : test::kFamilies) {
    const Batch batch{family, range.first, slow_every, time_every, make_cases(family, range)};
    run_all<float>(table, batch, progress);
    run_all<double>(table, batch, progress);
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  return report_search(parse(argc, argv,
                             {"search",
                              "Error of the time of contact against cost, for every search and "
                              "setting (search.csv)",
                              "15 minutes"}));
}
