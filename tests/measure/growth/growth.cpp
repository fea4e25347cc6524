// SPDX-License-Identifier: MIT
// Instructions of a step against the number of bodies: growth OUT writes the crowds of the report's
// section (tests/support/crowd.hpp) as rows of a CSV that tests/measure/report/render.py draws.
// Counted by SysTick under QEMU's -icount; exit status 0, or 1 where a sparse crowd grows faster
// than it may.

#include "crowd.hpp"
#include "platforms/cortex_m/semihosting.hpp"
#include "price/bench/ticks.hpp"

namespace batuta::growth {
namespace {

using test::Crowd;
using test::CrowdRun;

/// From N bodies to 2 N, for each N, of a sparse crowd; in hundredths.
constexpr std::uint64_t kMostGrowth = 220;
constexpr int kStepsOfRun = 10;
/// In all runs of a crowd together: two bodies that happen to be near each other must not decide.
constexpr std::uint64_t kBodiesOfRuns = 512;

class Csv {
 public:
  bool open(const char* path) { return file_.open(path, semihosting::File::Mode::kWrite); }
  Csv& text(const char* words) {
    int length = 0;
    while (words[length] != '\0') ++length;  // Bound: the length of the text
    ok_ = file_.write(words, length) == length && ok_;
    return *this;
  }
  Csv& number(std::uint64_t value) {
    char digits[24];
    int i = 23;
    digits[i] = '\0';
    do {  // Bound: 20 digits
      digits[--i] = static_cast<char>('0' + static_cast<int>(value % 10));
      value /= 10;
    } while (value > 0);
    return text(&digits[i]);
  }
  Csv& cell(std::uint64_t value) { return text(",").number(value); }
  bool close() { return file_.close() && ok_; }

 private:
  semihosting::File file_;
  bool ok_ = true;
};

Csv csv;
std::uint32_t ticks_of_calibration = 0;

struct Sums {
  std::uint64_t ticks = 0;
  std::uint64_t pairs = 0;
  std::uint64_t evaluations = 0;
  std::uint64_t contacts = 0;
  std::uint64_t dropped = 0;
  std::uint64_t incomplete = 0;
  float deepest = 0;

  void add(const StepReport<float>& report, std::uint32_t more) {
    ticks += more;
    pairs += report.pairs;
    evaluations += report.evaluations;
    contacts += report.collisions + report.separations;
    dropped += report.pairs_dropped;
    incomplete += report.complete() ? 0 : 1;
    deepest = max_of(deepest, report.deepest_overlap);
  }
  std::uint64_t instructions() const {
    return ticks * price::kCalibrationInstructions / ticks_of_calibration;
  }
};

template <int N>
CrowdRun<float, N>& crowd_of() {
  static CrowdRun<float, N> run;
  return run;
}

template <int N>
std::uint64_t measure(Crowd crowd) {
  const std::uint64_t runs = crowd == Crowd::kWorst ? 1 : kBodiesOfRuns / N;
  CrowdRun<float, N>& run = crowd_of<N>();
  Sums sums;
  for (std::uint64_t number = 0; number < runs; ++number) {  // Bound: runs
    run.begin(crowd, number);
    (void)run.step();                        // everything is new in the first
    for (int i = 0; i < kStepsOfRun; ++i) {  // Bound: kStepsOfRun
      run.turn_back();
      const std::uint32_t ticks = price::ticks_of([&run] { (void)run.step(); });
      sums.add(run.world().report(), ticks);
    }
  }
  csv.text(test::name(crowd)).cell(N).cell(CrowdRun<float, N>::SceneT::kMaxPairs);
  csv.cell(sizeof(run.world())).cell(kStepsOfRun * runs).cell(sums.pairs).cell(sums.evaluations);
  csv.cell(sums.contacts).cell(sums.dropped).cell(sums.incomplete).cell(sums.instructions());
  csv.cell(static_cast<std::uint64_t>(1e9F * sums.deepest)).text("e-9\n");
  return sums.instructions();
}

/// @returns whether none costs more than a sparse one may, over one of half as many
template <int... kNumbers>
bool measure_all(Crowd crowd) {
  std::uint64_t before = 0;
  bool good = true;
  const auto judge = [&](std::uint64_t now) {
    good = good && (before == 0 || 100 * now <= kMostGrowth * before);
    before = now;
  };
  (judge(measure<kNumbers>(crowd)), ...);
  return good;
}

int run(const char* out) {
  if (!csv.open(out)) return 2;
  price::start_ticks();
  ticks_of_calibration = price::calibration_ticks();
  csv.text("crowd,bodies,room_pairs,bytes,steps:sum,pairs:sum,evaluations:sum,contacts:sum,");
  csv.text("pairs_dropped:sum,incomplete:sum,instructions:sum,deepest_overlap_m:max\n");
  const bool good = measure_all<2, 4, 8, 16, 32, 64, 128, 256, 512>(Crowd::kSparse);
  (void)measure_all<2, 4, 8, 16, 32, 64, 128, 256, 512>(Crowd::kDense);
  (void)measure_all<2, 4, 8, 16, 32, 64>(Crowd::kWorst);  // beyond, a step outlasts the counter
  return csv.close() && good ? 0 : 1;
}

}  // namespace
}  // namespace batuta::growth

int main() {
  char line[512];
  char out[256];
  namespace semihosting = batuta::semihosting;
  if (semihosting::read_command_line(line, sizeof line) < 0 ||
      semihosting::word_of(line, 1, out, sizeof out) < 0) {
    semihosting::exit(2);
  }
  semihosting::exit(batuta::growth::run(out));
}
