// SPDX-License-Identifier: MIT
#include "batuta/haptics/detail/momentum_fit.hpp"

namespace batuta::detail {
namespace {

constexpr int kN = MomentumFit::kUnknowns;
constexpr int kAll = kN + 1;  ///< with the delay's fraction
constexpr int kEdge = MomentumFit::kWindow / 8;
constexpr float kHalf = 0.5F * MomentumFit::kWindow;  ///< periods
constexpr float kStride = 1 / kHalf;                  ///< of a period, in half windows
/// Windows overlap: of so many neighbours, one is independent of the next such.
constexpr float kOverlap = static_cast<float>(MomentumFit::kWindow) / MomentumFit::kHop;
/// No number is told better than to this share, nor a force than to this share of the one applied:
/// what rounding, and sums in place of integrals, may come to.
constexpr float kFinest = 1e-4F;
/// A diagonal of R less than this share of its column has been seen through rounding only.
constexpr float kLeastSeen = 1e-4F;
/// Gauss and Newton on a parabola that is bent by a few parts in a hundred: each takes as much
/// away.
constexpr int kShareSteps = 4;

enum Unknown { kMass, kDamping, kFriction, kStiffness, kOffset };

/// (1 - x^2)^5 with its first two derivatives: src/haptics/device_measurement.md.
struct Weight {
  float value;
  float slope;
  float bend;
};

Weight weight_at(float x) {
  const float y = 1 - x * x;
  const float y2 = y * y;
  const float y3 = y2 * y;
  return {y2 * y3, -10 * x * y2 * y2, 10 * y3 * (9 * x * x - 1)};
}

/// The integral of the weight from 0 to x.
float area_to(float x) {
  const float x2 = x * x;
  const float tail = 2 + x2 * (-10.0F / 7 + x2 * (5.0F / 9 - x2 / 11));
  return x * (1 + x2 * (-5.0F / 3 + x2 * tail));
}

float place_of(int i) {
  return kStride * static_cast<float>(i) - 1;
}

/// Squares of what an error of 1 in each position does to the columns of mass and damping.
struct NoiseGain {
  float mass = 0;
  float damping = 0;
};

NoiseGain noise_gain() {
  NoiseGain gain;
  for (int i = 0; i <= MomentumFit::kWindow; ++i) {  // Bound: kWindow
    const Weight weight = weight_at(place_of(i));
    gain.mass += kStride * weight.bend * kStride * weight.bend;
    gain.damping += kStride * weight.slope * kStride * weight.slope;
  }
  return gain;
}

using Triangle = std::array<std::array<float, kAll>, kAll>;
using Column = std::array<float, kAll>;

/// x with R x = y. @pre no zero on the diagonal
Column solved(const Triangle& R, const Column& y, std::size_t count) {
  Column x{};
  for (std::size_t i = count; i-- > 0;) {  // Bound: kAll
    float sum = y[i];
    for (std::size_t j = i + 1; j < count; ++j) sum -= R[i][j] * x[j];  // Bound: kAll
    x[i] = sum / R[i][i];
  }
  return x;
}

/// x with R' x = y.
Column solved_transposed(const Triangle& R, const Column& y) {
  Column x{};
  for (std::size_t i = 0; i < kAll; ++i) {  // Bound: kAll
    float sum = y[i];
    for (std::size_t j = 0; j < i; ++j) sum -= R[j][i] * x[j];  // Bound: kAll
    x[i] = sum / R[i][i];
  }
  return x;
}

/// Root of the diagonal of (R' R)^-1 at i: the length of a row of R^-1.
float spread(const Triangle& R, std::size_t i) {
  Column one{};
  one[i] = 1;
  const Column row = solved_transposed(R, one);
  float sum = 0;
  for (const float x : row) sum += x * x;  // Bound: kAll
  return std::sqrt(sum);
}

bool is_seen(const Triangle& R) {
  for (std::size_t j = 0; j < kAll; ++j) {  // Bound: kAll
    float sum = 0;
    for (std::size_t i = 0; i <= j; ++i) sum += R[i][j] * R[i][j];  // Bound: kAll
    if (!(std::abs(R[j][j]) > kLeastSeen * std::sqrt(sum))) return false;
  }
  return true;
}

}  // namespace

void MomentumFit::take(float position, float applied, bool fresh) {
  at_ = (at_ + 1) % kRing;
  const auto at = static_cast<std::size_t>(at_);
  positions_[at] = position;
  applied_[at] = applied;
  run_ = fresh ? min_of(run_ + 1, kWindow + 1) : 0;
  steps_ = min_of(steps_ + 1, kWindow + kDelays);
  hop_ = (hop_ + 1) % kHop;
  if (hop_ != 0 || run_ <= kWindow || steps_ < kWindow + kDelays) return;
  const int way = this->way();
  if (way != 0) add_window(way);
}

/// 1 or -1 where the stick went one way all the time, also near both ends; else 0.
int MomentumFit::way() const {
  const float moved = position(0) - position(kWindow);
  const float sign = moved < 0.0F ? -1.0F : 1.0F;
  if (!(sign * (position(0) - position(kEdge)) > 0.0F)) return 0;
  if (!(sign * (position(kWindow - kEdge) - position(kWindow)) > 0.0F)) return 0;
  for (int i = 0; i < kWindow; ++i) {  // Bound: kWindow
    if (sign * (position(i) - position(i + 1)) < 0.0F) return 0;
  }
  return moved < 0.0F ? -1 : 1;
}

void MomentumFit::add_window(int way) {
  Row row{};
  const float middle = position(kWindow / 2);
  float before = area_to(-1);
  const float area = -2 * before;
  for (int i = 0; i <= kWindow; ++i) {  // Bound: kWindow
    const Weight weight = weight_at(place_of(i));
    const float q = position(kWindow - i) - middle;
    row[kMass] += kStride * weight.bend * q;
    row[kDamping] -= kStride * weight.slope * q;
    row[kStiffness] += kStride * weight.value * q;
    if (i == kWindow) break;
    const float after = area_to(place_of(i + 1));
    for (int n = 0; n < kDelays; ++n) {  // Bound: kDelays
      row[kN + static_cast<std::size_t>(n)] += (after - before) * applied(kWindow - i - 1 + n);
    }
    before = after;
  }
  row[kStiffness] += area * middle;
  row[kFriction] = way < 0 ? -area : area;
  row[kOffset] = area;
  rotate_in(row);
  ++rows_;
}

/// Givens: R' R gets row' row added. @param row  spent
void MomentumFit::rotate_in(Row& row) {
  for (std::size_t c = 0; c < kColumns; ++c) {  // Bound: kColumns
    const float length = std::sqrt(R_[c][c] * R_[c][c] + row[c] * row[c]);
    if (!(length > 0.0F)) continue;
    const float cosine = R_[c][c] / length;
    const float sine = row[c] / length;
    for (std::size_t j = c; j < kColumns; ++j) {  // Bound: kColumns
      const float kept = cosine * R_[c][j] + sine * row[j];
      row[j] = cosine * row[j] - sine * R_[c][j];
      R_[c][j] = kept;
    }
  }
}

namespace {

using Columns = std::array<std::array<float, MomentumFit::kColumns>, MomentumFit::kColumns>;

/// The force's column at a delay of n and w periods, by row: value + w slope - w (1 - w) / 2 bend.
struct Shifted {
  float value;
  float slope;
  float bend;
};

/// Through four whole delays about it; before the first one, as if the bend were the same.
Shifted shifted(const Columns& columns, std::size_t row, int n) {
  const auto at = [&](int delay) { return columns[row][kN + static_cast<std::size_t>(delay)]; };
  const float value = at(n);
  const float slope = at(n + 1) - value;
  const float after = at(n + 2) - at(n + 1);
  const float before = n > 0 ? value - at(n - 1) : 2 * slope - after;
  return {value, slope, 0.5F * (after - before)};
}

/// The delay that leaves the least: whole periods, a share of the next, and the square of what is
/// left.
struct Least {
  int whole = 0;
  float share = 0;
  float square = std::numeric_limits<float>::max();
};

/// By how much another share would leave less, and the square that is left.
Least improved(const Columns& columns, int n, float share) {
  const float bent = -0.5F * share * (1 - share);
  float square = 0;
  float along = 0;
  float change = 0;
  for (std::size_t i = kN; i < MomentumFit::kColumns; ++i) {  // Bound: kColumns
    const Shifted column = shifted(columns, i, n);
    const float left = column.value + share * column.slope + bent * column.bend;
    const float growth = column.slope + (share - 0.5F) * column.bend;
    square += left * left;
    along += left * growth;
    change += growth * growth;
  }
  return {n, change > 0.0F ? -along / change : 0.0F, square};
}

Least least_over_delays(const Columns& columns) {
  Least least;
  for (int n = 0; n < MomentumFit::kMostDelay; ++n) {  // Bound: kMostDelay
    float share = 0;
    for (int i = 0; i < kShareSteps; ++i) {  // Bound: kShareSteps
      share = clamp(share + improved(columns, n, share).share, 0.0F, 1.0F);
    }
    const float square = improved(columns, n, share).square;
    if (square < least.square) least = {n, share, square};
  }
  return least;
}

/// The triangle of the unknowns and the delay's share, with the right side at that delay.
struct Reduced {
  Triangle R{};
  Column y{};
  float response = 0;  ///< square of the force's column
};

Reduced reduced_columns(const Columns& columns, const Least& least) {
  Reduced found;
  float left = 0;
  const float bent = -0.5F * least.share * (1 - least.share);
  for (std::size_t i = 0; i < MomentumFit::kColumns; ++i) {  // Bound: kColumns
    const Shifted column = shifted(columns, i, least.whole);
    const float growth = column.slope + (least.share - 0.5F) * column.bend;
    found.response += column.value * column.value;
    if (i >= kN) {
      left += growth * growth;
      continue;
    }
    for (std::size_t j = i; j < kN; ++j) found.R[i][j] = columns[i][j];  // Bound: kUnknowns
    found.R[i][kN] = -growth;
    found.y[i] = column.value + least.share * column.slope + bent * column.bend;
  }
  found.R[kN][kN] = std::sqrt(left);
  return found;
}

}  // namespace

MomentumResult MomentumFit::solve(float encoder_step) const {
  MomentumResult result;
  const Least least = least_over_delays(R_);
  const Reduced found = reduced_columns(R_, least);
  const Triangle& R = found.R;
  const auto rows = static_cast<float>(rows_);
  if (rows_ <= kAll || !is_seen(R)) return result;

  Column x = solved(R, found.y, kN);
  const NoiseGain gain = noise_gain();
  const float noise = encoder_step * encoder_step / 12;
  const float heard = x[kMass] * x[kMass] * gain.mass + x[kDamping] * x[kDamping] * gain.damping;
  const float expected = noise * heard;
  const float left = least.square / (rows - kAll);
  const float rounding = kFinest * kFinest * found.response / rows;
  const float scatter = std::sqrt(kOverlap * (max_of(left, expected) + rounding));
  // What noise in the columns takes from the answer.
  Column pull{};
  pull[kMass] = rows * noise * gain.mass * x[kMass];
  pull[kDamping] = rows * noise * gain.damping * x[kDamping];
  const Column taken = solved(R, solved_transposed(R, pull), kAll);
  const auto fitted = [&](std::size_t i, float value, float unit) {
    const float random = scatter * spread(R, i);
    const float finest = kFinest * value;
    const float sigma = std::sqrt(random * random + taken[i] * taken[i] + finest * finest);
    return Fitted{unit * value, unit * sigma};
  };
  result.mass = fitted(kMass, x[kMass], kHalf * kHalf);
  result.damping = fitted(kDamping, x[kDamping], kHalf);
  result.friction = fitted(kFriction, x[kFriction], 1);
  result.stiffness = fitted(kStiffness, x[kStiffness], 1);
  result.offset = fitted(kOffset, x[kOffset], 1);
  result.delay = fitted(kN, static_cast<float>(least.whole) + least.share, 1);
  const float area = 2 * area_to(1);
  result.residual = std::sqrt(left) / area;
  result.expected = std::sqrt(expected) / area;
  result.coarsest = std::sqrt(12 * left / heard);
  result.response = std::sqrt(found.response / rows) / area;
  // The last column that a delay may have is its own neighbour's: a share of 1 there is beyond.
  result.is_good = least.whole + 1 < kMostDelay || least.share < 1.0F;
  return result;
}

}  // namespace batuta::detail
