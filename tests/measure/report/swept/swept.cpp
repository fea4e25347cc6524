// SPDX-License-Identifier: MIT
// How tight boxes of a turning capsule are, whether they leak, and what they cost, against the
// angle of turn. Capsules 1 m long and 4 cm thick; what they need is sampled densely.

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "draws.hpp"
#include "ensemble.hpp"
#include "section.hpp"
#include "volumes.hpp"

namespace batuta::report {
namespace {

constexpr double kPi = 3.14159265358979324;
constexpr std::array<double, 6> kTurns = {0.1, 0.25, 0.5, 0.785, 1.57, kPi};

constexpr double kLength = 1;
constexpr double kRadius = 0.02;

/// Of a motion; what is sampled is too small by 3e-7 of the length at most.
constexpr int kSamples = 2000;

/// Ratios of volumes are added up in millionths, which merge exactly.
constexpr double kMillion = 1e6;

constexpr std::uint64_t kSeed = 20061107;

/// One kind of motion.
struct Kind {
  double turn;       ///< rad
  bool is_centered;  ///< the centre of mass is in the middle; else anywhere along the axis
  bool travels;      ///< it moves by 0 ... 1 length
};

/// The index-th motion of a kind, a function of both alone.
MovingCapsule<float> draw_motion(const Kind& kind, std::uint64_t index) {
  test::Draws draws(kSeed, 0, index);
  const double place = draws.unit();
  const Vec3<double> along = kLength * draws.direction();
  const Quat<double> q_WB = draws.rotation();
  const Vec3<double> axis = draws.direction();
  const Vec3<double> way = draws.in_ball(kLength);
  const double share = kind.is_centered ? 0.5 : place;
  MovingCapsule<float> moving;
  moving.capsule_B.axis.a = (-share * along).cast<float>();
  moving.capsule_B.axis.b = ((1 - share) * along).cast<float>();
  moving.capsule_B.radius = static_cast<float>(kRadius);
  moving.motion.X_WB.q_WB = q_WB.cast<float>();
  moving.motion.twist.w_W = (kind.turn * axis).cast<float>();
  if (kind.travels) moving.motion.twist.v_W = way.cast<float>();
  moving.motion.duration = 1;
  return moving;
}

/// What is known of one form in one kind of motion.
struct Account {
  std::uint64_t motions = 0;
  std::uint64_t ratio_millionths = 0;
  double worst_ratio = std::numeric_limits<double>::quiet_NaN();
  std::uint64_t leaks = 0;
  double worst_leak = std::numeric_limits<double>::quiet_NaN();  ///< over the length
};

void judge(Form form, const MovingCapsule<float>& moving, const Aabb<double>& needed,
           Account& account) {
  const Aabb<double> box = box_of(form, moving);
  const double ratio = volume(box) / volume(needed);
  const double out = leak(box, needed) / kLength;
  ++account.motions;
  account.ratio_millionths += static_cast<std::uint64_t>(std::llround(ratio * kMillion));
  account.worst_ratio = std::fmax(account.worst_ratio, ratio);
  if (out <= 0) return;
  ++account.leaks;
  account.worst_leak = std::fmax(account.worst_leak, out);
}

/// What is timed, and how often a batch.
struct Timed {
  std::vector<MovingCapsule<float>> motions;
  int calls;
};

Timed draw_timed(const Kind& kind, const Options& options) {
  constexpr std::uint64_t kMotions = 2048;  // more than a branch predictor learns by heart
  Timed timed{{}, static_cast<int>(pick(options, 100, 2000, 20000))};
  for (std::uint64_t i = 0; i < kMotions; ++i) timed.motions.push_back(draw_motion(kind, i));
  return timed;
}

/// Median time of one volume over a fixed set of motions, ns; NaN for forms that are not the
/// library's.
template <class Exact, class Coarse>
double time_of(Form form, const Timed& timed, const Exact& exact, const Coarse& coarse) {
  std::size_t next = 0;
  const auto pick_next = [&]() -> const MovingCapsule<float>& {
    next = next + 1 < timed.motions.size() ? next + 1 : 0;
    return timed.motions[next];
  };
  if (form == Form::kExact) return median_ns(timed.calls, [&] { keep(exact(pick_next())); });
  if (form == Form::kCoarse) return median_ns(timed.calls, [&] { keep(coarse(pick_next())); });
  return std::numeric_limits<double>::quiet_NaN();
}

void write_times(Table& table, Form form, const Timed& timed) {
  const double box = time_of(form, timed, swept_aabb<float>, detail::coarse_swept_aabb<float>);
  const double dop =
      time_of(form, timed, detail::swept_kdop<float, 26>, detail::coarse_swept_kdop<float, 26>);
  const double plain = plain_ns();
  table.min("time_box_ns", box)
      .min("time_box_in_plain", box / plain)
      .min("time_dop26_ns", dop)
      .min("time_dop26_in_plain", dop / plain);
}

void write_rows(Table& table, const Kind& kind, const Options& options) {
  const Range range = share_of(options, pick(options, 20, 1000, 100000));
  std::array<Account, kForms.size()> accounts;
  for (std::uint64_t i = range.first; i < range.last; ++i) {
    const MovingCapsule<float> moving = draw_motion(kind, i);
    const Aabb<double> needed = sampled_box(moving, kSamples);
    for (std::size_t k = 0; k < kForms.size(); ++k) judge(kForms[k], moving, needed, accounts[k]);
  }
  const Timed timed = draw_timed(kind, options);
  for (std::size_t k = 0; k < kForms.size(); ++k) {
    const Account& account = accounts[k];
    table.key("turn", kind.turn)
        .key("center_of_mass", std::string(kind.is_centered ? "middle" : "anywhere"))
        .key("travel", std::string(kind.travels ? "up to a length" : "none"))
        .key("form", name(kForms[k]))
        .sum("motions", account.motions)
        .sum("ratio_millionths", account.ratio_millionths)
        .max("worst_ratio", account.worst_ratio)
        .sum("leaks", account.leaks)
        .max("worst_leak_in_lengths", account.worst_leak);
    write_times(table, kForms[k], timed);
    table.end_row();
  }
}

int run(const Options& options) {
  Table table(options, "swept");
  Progress progress("swept volumes", kTurns.size() * 4);
  for (const double turn : kTurns) {
    for (const bool is_centered : {true, false}) {
      for (const bool travels : {false, true}) {
        write_rows(table, {turn, is_centered, travels}, options);
        progress.advance();
      }
    }
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::report

int main(int argc, char** argv) {
  using namespace batuta::report;
  return run(parse(argc, argv,
                   {"swept",
                    "Boxes of turning capsules: volume over what the motion needs, leaks and time, "
                    "against the angle of turn.",
                    "8 minutes"}));
}
