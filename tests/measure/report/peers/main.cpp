// SPDX-License-Identifier: MIT
// Section "peers" of the report: batuta, Bullet, FCL and ODE side by side on the same queries. What
// each one sees, misses and costs, a row for each family and peer. `--check` puts simple questions
// with known answers to the adapters instead.
//
// Times: shapes are made before; the clock runs from the poses and velocities of a step to the
// answer. Every query is repeated in batches and the median batch counts, so the code is warm for
// everyone alike. time_ratio is over one plain segment-segment distance in double.

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "check.hpp"
#include "ensemble.hpp"
#include "heap_trap.hpp"
#include "judge.hpp"
#include "section.hpp"
#include "watchdog.hpp"

namespace batuta::peers {
namespace {

constexpr std::uint64_t kSeed = 2006;
constexpr std::uint64_t kBlock = 64;  ///< queries between two looks at the host's pace
constexpr double kBatch_ns = 4000;    ///< least length of a timed batch
constexpr int kMostCalls = 64;        ///< in a batch

struct Row {
  Tally tally;
  report::Histogram time_ns;
  report::Histogram time_ratio;
  std::uint64_t allocations = 0;
  std::uint64_t most_allocations = 0;
};

Triple triple(const Vec3<float>& p) {
  return {double{p.x()}, double{p.y()}, double{p.z()}};
}

PeerBody peer_body(const MovingCapsule<float>& m) {
  const Quat<float>& q = m.motion.X_WB.q_WB;
  PeerBody body;
  body.center_W = triple(m.motion.X_WB.p_W);
  body.q_WB = {double{q.w()}, double{q.x()}, double{q.y()}, double{q.z()}};
  body.v_W = triple(m.motion.twist.v_W);
  body.w_W = triple(m.motion.twist.w_W);
  body.a_B = triple(m.capsule_B.axis.a);
  body.b_B = triple(m.capsule_B.axis.b);
  body.radius = double{m.capsule_B.radius};
  return body;
}

/// Median time of one ask(), ns.
double time_of(Peer& peer) {
  const auto ask = [&peer] {
    const PeerAnswer answer = peer.ask();
    report::keep(answer);
  };
  const double once = report::median_ns(1, ask);
  if (once >= kBatch_ns) return once;
  return report::median_ns(std::min(kMostCalls, 1 + static_cast<int>(kBatch_ns / once)), ask);
}

void count_allocations(Row& row, Peer& peer) {
  const test::HeapTrap trap;
  const PeerAnswer answer = peer.ask();
  report::keep(answer);
  const auto count = static_cast<std::uint64_t>(trap.allocations());
  row.allocations += count;
  row.most_allocations = std::max(row.most_allocations, count);
}

struct Key {
  std::string family;
  std::string peer;
  std::string status;
  std::string setting;
};

/// Queries that no peer was asked.
struct LeftOut {
  std::uint64_t truth_unknown = 0;
  std::uint64_t touching_at_start = 0;
};

void write_cells(report::Table& table, const Key& key, const Row& row, const LeftOut& left_out) {
  const Tally& t = row.tally;
  table.key("family", key.family).key("peer", key.peer);
  table.key("status", key.status).key("setting", key.setting);
  table.sum("queries", t.queries).sum("truth_unknown", left_out.truth_unknown);
  table.sum("touching_at_start", left_out.touching_at_start);
  table.sum("deep", t.deep).sum("missed_deep", t.missed_deep).sum("late_deep", t.late_deep);
  table.sum("touching", t.touching).sum("missed_touching", t.missed_touching);
  table.sum("late_touching", t.late_touching);
  table.sum("false_far", t.false_far).sum("false_near", t.false_near);
  table.sum("gave_up", t.gave_up).sum("gave_up_deep", t.gave_up_deep);
  table.hist("early", t.early).hist("late", t.late);
  table.sum("allocations", row.allocations);
  table.max("most_allocations", static_cast<double>(row.most_allocations));
  table.hist("time_ns", row.time_ns).hist("time_ratio", row.time_ratio);
  table.end_row();
}

class Comparison {
 public:
  Comparison(Roster& roster, test::Family family)
      : roster_(roster), family_(family), rows_(roster.present.size()) {}

  bool takes_part(std::size_t i) const {
    return !roster_.present[i]->only_translation() || !test::turns(family_);
  }

  void ask_all(std::uint64_t index) {
    if (asked_++ % kBlock == 0) plain_ns_ = report::plain_ns();
    const test::Query query = test::make_query(family_, kSeed, index);
    const Truth truth(query.A, query.B);
    left_out_.truth_unknown += !truth.known();
    left_out_.touching_at_start += truth.touching_at_start();
    if (!truth.known() || truth.touching_at_start()) return;
    const PeerQuery question = {peer_body(query.A), peer_body(query.B), truth.duration()};
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      if (takes_part(i)) ask(i, index, question, truth);
    }
  }

  void write(report::Table& table) const {
    for (std::size_t i = 0; i < rows_.size(); ++i) {
      const Peer& peer = *roster_.present[i];
      const Key key = {test::name(family_), peer.name(), "asked", peer.setting()};
      if (takes_part(i)) write_cells(table, key, rows_[i], left_out_);
    }
  }

 private:
  void ask(std::size_t i, std::uint64_t index, const PeerQuery& question, const Truth& truth) {
    Peer& peer = *roster_.present[i];
    Row& row = rows_[i];
    const Watchdog watchdog(peer.name(), test::name(family_), index);
    peer.load(question);
    judge(row.tally, truth, peer.ask());
    count_allocations(row, peer);
    const double ns = time_of(peer);
    row.time_ns.add(ns);
    row.time_ratio.add(ns / plain_ns_);
  }

  Roster& roster_;
  test::Family family_;
  std::vector<Row> rows_;
  std::uint64_t asked_ = 0;
  LeftOut left_out_;
  double plain_ns_ = 1;
};

int compare(const report::Options& options) {
  Roster roster = make_roster();
  report::Table table(options, "peers");
  const report::Range range = report::share_of(options, report::pick(options, 4, 200, 20'000));
  report::Progress progress("peers", (range.last - range.first) * test::kFamilyCount);
  for (const test::Family family : test::kFamilies) {
    Comparison comparison(roster, family);
    for (std::uint64_t i = range.first; i < range.last; ++i) {
      comparison.ask_all(i);
      progress.advance();
    }
    comparison.write(table);
  }
  for (const std::string& name : roster.absent) {
    std::fprintf(stderr, "peers: %s was skipped, its package is not installed\n", name.c_str());
    write_cells(table, {"none", name, "skipped", "its package is not installed"}, Row{}, LeftOut{});
  }
  return table.write();
}

}  // namespace
}  // namespace batuta::peers

int main(int argc, char** argv) {
  if (argc == 2 && std::strcmp(argv[1], "--check") == 0) {
    return batuta::peers::check(batuta::peers::make_roster()) == 0 ? 0 : 1;
  }
  const batuta::report::About about = {
      "peers", "batuta, Bullet, FCL and ODE on the same queries: misses, errors, time, allocations",
      "20 minutes"};
  return batuta::peers::compare(batuta::report::parse(argc, argv, about));
}
