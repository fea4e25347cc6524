// SPDX-License-Identifier: MIT
#include "worst_file.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "contact_row.hpp"
#include "reference.hpp"
#include "section.hpp"

namespace batuta::report {

namespace {

using Real = long double;

// The proof of the reference takes steps as short as the gap where edges slide: where that is too
// many, samples have to do.
constexpr std::uint32_t kProofs = 300'000;
constexpr int kSamples = 2000;
constexpr int kFineSamples = 20'000;
constexpr int kHalvings = 64;

struct TrueAnswer {
  int kind = test::kNever;
  Real t = -1;
  test::LeastGap<Real> least;
};

/// An instant before the first sample that overlaps by less than can be told. @pre least.gap < 0
Real first_overlap(const test::Reference<Real>& reference, const test::LeastGap<Real>& least) {
  const Real step = reference.duration() / kFineSamples;
  Real high = step;
  while (high < least.t && reference.gap(high) > 0) high += step;  // Bound: kFineSamples
  high = std::min(high, least.t);
  Real low = std::max(Real(0), high - step);
  for (int i = 0; i < kHalvings; ++i) {  // Bound: kHalvings
    const Real middle = (low + high) / 2;
    (reference.gap(middle) > 0 ? low : high) = middle;
  }
  return low;
}

TrueAnswer true_answer(const test::Query& query) {
  const test::Reference<Real> reference(query.A, query.B);
  const Real end = reference.duration();
  TrueAnswer answer;
  answer.least = reference.least_gap(0, end, kSamples);
  if (reference.gap(0) <= 0) {
    answer.kind = test::kAtStart;
    answer.t = 0;
    return answer;
  }
  const auto march = reference.march(2 * reference.rounding(), kProofs);
  if (march.verdict == test::Verdict::kFree) return answer;
  const auto after = reference.least_gap_after(march.t_free, kSamples);
  if (after.gap < answer.least.gap) answer.least = after;
  if (!(answer.least.gap < 0)) return answer;
  const bool proven = march.verdict == test::Verdict::kReached;
  answer.kind = test::kOnTheWay;
  answer.t = proven ? march.t_free : first_overlap(reference, answer.least);
  return answer;
}

struct KnownQuery {
  CostlyQuery costly;
  TrueAnswer answer;
};

/// As float_of_bits() reads it: hexadecimal, without trailing zeros.
std::string bits_of(float value) {
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof bits);
  std::array<char, 9> digits{};
  std::snprintf(digits.data(), digits.size(), "%08x", static_cast<unsigned>(bits));
  std::string text(digits.data());
  while (text.size() > 1 && text.back() == '0') text.pop_back();
  return text;
}

/// Cells of one line; the header has the same.
class Line {
 public:
  Line& add(const std::string& name, const std::string& cell) {
    names_ += separator() + name;
    cells_ += separator() + cell;
    is_empty_ = false;
    return *this;
  }
  Line& add(const std::string& name, float value) { return add(name, bits_of(value)); }
  Line& add(const std::string& name, const Vec3<float>& v) {
    return add(name + 'x', v.x()).add(name + 'y', v.y()).add(name + 'z', v.z());
  }
  Line& add_decimal(const std::string& name, double value) { return add(name, text_of(value)); }
  Line& add(const Line& more) { return add(more.names_, more.cells_); }
  const std::string& names() const { return names_; }
  const std::string& cells() const { return cells_; }

 private:
  const char* separator() const { return is_empty_ ? "" : ","; }

  std::string names_;
  std::string cells_;
  bool is_empty_ = true;
};

void add_body(Line& line, const std::string& body, const MovingCapsule<float>& moving) {
  const Quat<float>& q = moving.motion.X_WB.q_WB;
  line.add(body + 'c', moving.motion.X_WB.p_W);
  line.add(body + "qw", q.w()).add(body + 'q', Vec3<float>(q.x(), q.y(), q.z()));
  line.add(body + 'v', moving.motion.twist.v_W).add(body + 'w', moving.motion.twist.w_W);
  line.add(body + "e0", moving.capsule_B.axis.a).add(body + "e1", moving.capsule_B.axis.b);
  line.add(body + 'r', moving.capsule_B.radius);
}

Line line_of(const test::Query& query) {
  Line line;
  line.add("T", query.A.motion.duration);
  add_body(line, "A", query.A);
  add_body(line, "B", query.B);
  return line;
}

Line line_of(const KnownQuery& known) {
  const CostlyQuery& costly = known.costly;
  const TrueAnswer& answer = known.answer;
  Line line;
  line.add("family", costly.family).add(line_of(costly.summit.query));
  line.add_decimal("degrees", costly.degrees).add_decimal("contact_tolerance", kTau);
  line.add_decimal("evaluations", costly.summit.evaluations).add_decimal("kind", answer.kind);
  line.add_decimal("t", static_cast<double>(answer.t));
  line.add_decimal("gmin", static_cast<double>(answer.least.gap));
  line.add_decimal("tgmin", static_cast<double>(answer.least.t));
  return line;
}

/// A row of the file, its cost counted anew.
KnownQuery read_known(host::QueryRow& row) {
  KnownQuery known;
  known.costly.family = row.text("family");
  known.costly.degrees = row.decimal("degrees");
  Summit& summit = known.costly.summit;
  summit.query = {test::read_bits(row, "A"), test::read_bits(row, "B")};
  summit.evaluations = evaluations_of(summit.query);
  known.answer.kind = static_cast<int>(row.decimal("kind"));
  known.answer.t = row.decimal("t");
  known.answer.least = {row.decimal("gmin"), row.decimal("tgmin")};
  return known;
}

/// @returns why the file cannot be read, or an empty text
std::string read_file(const std::string& path, std::vector<KnownQuery>& kept) {
  std::ifstream in(path);
  if (!in) return {};
  host::QueryFile file(in);
  host::QueryRow row;
  while (file.next(row)) {  // Bound: the length of the file
    kept.push_back(read_known(row));
    if (!row.ok()) return row.error();
  }
  return file.error();
}

bool has(const std::vector<KnownQuery>& kept, const test::Query& query) {
  const std::string cells = line_of(query).cells();
  return std::any_of(kept.begin(), kept.end(), [&](const KnownQuery& known) {
    return line_of(known.costly.summit.query).cells() == cells;
  });
}

bool write_file(const std::string& path, const std::vector<KnownQuery>& kept) {
  std::ofstream file(path);
  if (!kept.empty()) file << line_of(kept.front()).names() << '\n';
  for (const KnownQuery& known : kept) file << line_of(known).cells() << '\n';
  file.close();
  return !file.fail();
}

}  // namespace

bool keep_queries(const std::string& path, const std::vector<CostlyQuery>& found) {
  std::vector<KnownQuery> kept;
  const std::string error = read_file(path, kept);
  if (!error.empty()) {
    std::fprintf(stderr, "climb: cannot read %s: %s\n", path.c_str(), error.c_str());
    return false;
  }
  Progress progress("truth of what is kept", found.size());
  for (const CostlyQuery& costly : found) {
    const test::Query& query = costly.summit.query;
    if (!has(kept, query)) kept.push_back({costly, true_answer(query)});
    progress.advance();
  }
  const bool written = write_file(path, kept);
  if (!written) std::fprintf(stderr, "climb: cannot write %s\n", path.c_str());
  return written;
}

}  // namespace batuta::report
