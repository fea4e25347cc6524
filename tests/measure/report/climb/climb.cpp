// SPDX-License-Identifier: MIT
// The most that a search costs: hill climbing over queries (kind climb), and how the cost grows as
// a miss gets nearer (kind graze). Rows merge: the worst of all shards is the worst.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "closing_in.hpp"
#include "section.hpp"
#include "worst_file.hpp"

namespace batuta::report {
namespace {

constexpr double kPi = 3.14159265358979324;
constexpr std::array<double, 3> kDegrees = {45, 90, 180};
constexpr std::array<Start, 2> kStarts = {Start::kGeneric, Start::kSliding};

/// Of each ground, which makes a hundred.
constexpr std::size_t kKept = 17;

const char* name(Start start) {
  return start == Start::kGeneric ? "generic" : "sliding";
}

struct RowKey {
  const char* kind;
  const char* start;
  double setting;  ///< climb: degrees; graze: least gap over S
};

/// `evaluations`: of the worst query of each climb, or of each query.
void write_row(Table& table, const RowKey& key, const Figures& figures, std::uint64_t searches) {
  table.key("kind", key.kind)
      .key("start", key.start)
      .key("setting", key.setting)
      .sum("queries", figures.queries)
      .sum("searches", searches)
      .sum("evaluations_sum", figures.sum)
      .max("worst", figures.worst)
      .hist("evaluations", figures.evaluations)
      .end_row();
}

class Climbs {
 public:
  explicit Climbs(const Options& options)
      : range_(share_of(options, pick(options, 4, 60, 60))),
        mutations_(pick(options, 20, 400, 6000)),
        progress_("climbs", kDegrees.size() * kStarts.size() * (range_.last - range_.first)) {}

  void run(Table& table, Start start, double degrees) {
    std::vector<CostlyQuery> found;
    Figures figures;
    for (std::uint64_t i = range_.first; i < range_.last; ++i) {  // Bound: climbs
      const Summit summit = climb({start, degrees * kPi / 180}, i, mutations_);
      found.push_back({name(start), degrees, summit});
      figures.add(summit.evaluations);
      progress_.advance();
    }
    keep_worst(found);
    write_row(table, {"climb", name(start), degrees}, figures,
              figures.queries * (kFirst + mutations_));
  }

  const std::vector<CostlyQuery>& kept() const { return kept_; }

 private:
  void keep_worst(std::vector<CostlyQuery>& found) {
    std::stable_sort(found.begin(), found.end(), [](const CostlyQuery& a, const CostlyQuery& b) {
      return a.summit.evaluations > b.summit.evaluations;
    });
    found.resize(std::min(found.size(), kKept));
    kept_.insert(kept_.end(), found.begin(), found.end());
  }

  Range range_;
  std::uint64_t mutations_;
  Progress progress_;
  std::vector<CostlyQuery> kept_;
};

void report_grazes(Table& table, const Options& options) {
  const Range range = share_of(options, pick(options, 100, 3000, 60'000));
  Progress progress("near misses", range.last - range.first);
  const auto figures = close_in(range, progress);
  for (std::size_t k = 0; k < kDistances.size(); ++k) {  // Bound: the distances
    write_row(table, {"graze", "generic", kDistances[k]}, figures[k], figures[k].queries);
  }
}

/// @param keep  file that the worst queries are added to, or empty
int run(const Options& options, const std::string& keep) {
  Table table(options, "climb");
  Climbs climbs(options);
  for (const Start start : kStarts) {
    for (const double degrees : kDegrees) climbs.run(table, start, degrees);
  }
  report_grazes(table, options);
  const bool kept = keep.empty() || keep_queries(keep, climbs.kept());
  const int written = table.write();
  return kept ? written : 1;
}

/// Takes --keep FILE out of the command line. @returns FILE, or an empty text
std::string take_keep(std::vector<const char*>& words) {
  const auto option = std::find_if(words.begin(), words.end(), [](const char* word) {
    return std::string_view(word) == "--keep";
  });
  if (option == words.end()) return {};
  if (option + 1 == words.end()) {
    std::fprintf(stderr, "batuta_report_climb: --keep lacks its value\n");
    std::exit(2);
  }
  const std::string file = *(option + 1);
  words.erase(option, option + 2);
  return file;
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  std::vector<const char*> words(argv, argv + argc);
  const std::string keep = take_keep(words);
  const About about{"climb",
                    "Looks for the queries that cost the most, by hill climbing, and at near "
                    "misses. --keep FILE adds the worst, with the truth, to a query file.",
                    "2 minutes"};
  return run(parse(static_cast<int>(words.size()), words.data(), about), keep);
}
