// SPDX-License-Identifier: MIT
#include "histogram.hpp"

#include <cmath>
#include <limits>

namespace batuta::report {

namespace {

// Below 2^-80 everything is zero, in metres as in seconds.
constexpr int kLeastExponent = -80;

}  // namespace

int Histogram::bin_of(double value) {
  if (!(value > 0)) return 0;
  if (value > std::numeric_limits<double>::max()) value = std::numeric_limits<double>::max();
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);  // in [0.5, 1)
  if (exponent < kLeastExponent) return 0;
  const int part = static_cast<int>((2 * mantissa - 1) * kPartsOfOctave);
  return 1 + (exponent - kLeastExponent) * kPartsOfOctave + part;
}

double Histogram::edge_of(int bin) {
  if (bin <= 0) return 0;
  const int octave = (bin - 1) / kPartsOfOctave;
  const double part = static_cast<double>((bin - 1) % kPartsOfOctave) / kPartsOfOctave;
  return std::ldexp(0.5 * (1 + part), octave + kLeastExponent);
}

void Histogram::add(double value, std::uint64_t times) {
  if (times == 0) return;
  bins_[bin_of(value)] += times;
  count_ += times;
}

void Histogram::add(const Histogram& other) {
  for (const auto& [bin, count] : other.bins_) bins_[bin] += count;
  count_ += other.count_;
}

double Histogram::quantile(double share) const {
  const double rank = std::ceil(share * static_cast<double>(count_));
  std::uint64_t seen = 0;
  for (const auto& [bin, count] : bins_) {
    seen += count;
    if (static_cast<double>(seen) >= rank) return edge_of(bin);
  }
  return 0;
}

std::string Histogram::text() const {
  std::string text;
  for (const auto& [bin, count] : bins_) {
    if (!text.empty()) text += ' ';
    text += std::to_string(bin) + ':' + std::to_string(count);
  }
  return text;
}

}  // namespace batuta::report
