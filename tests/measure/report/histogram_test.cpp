// SPDX-License-Identifier: MIT
#include "histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace batuta::report {
namespace {

TEST(Histogram, Bin_HoldsTheValuesFromItsEdgeToTheNext) {
  for (double value = 1e-20; value < 1e20; value *= 1.01) {
    const int bin = Histogram::bin_of(value);
    EXPECT_LE(Histogram::edge_of(bin), value);
    EXPECT_GT(Histogram::edge_of(bin + 1), value);
    EXPECT_EQ(Histogram::bin_of(Histogram::edge_of(bin)), bin);
  }
}

TEST(Histogram, Bin_OfASmallWholeNumberIsItsOwn) {
  for (int n = 0; n < 64; ++n) EXPECT_EQ(Histogram::edge_of(Histogram::bin_of(n)), n);
}

TEST(Histogram, Bin_IsDefinedForEveryNumber) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(Histogram::bin_of(-1), 0);
  EXPECT_EQ(Histogram::bin_of(std::nan("")), 0);
  EXPECT_EQ(Histogram::bin_of(std::numeric_limits<double>::denorm_min()), 0);
  EXPECT_EQ(Histogram::bin_of(kInfinity), Histogram::bin_of(std::numeric_limits<double>::max()));
}

TEST(Histogram, Quantile_IsTheEdgeOfTheValueOfThatRank) {
  Histogram histogram;
  std::vector<double> values;
  for (int i = 0; i < 997; ++i) {
    values.push_back(std::fmod(i * 0.618033988749895, 1) * (1 + i % 7));
    histogram.add(values.back());
  }
  std::sort(values.begin(), values.end());
  for (const double share : {0.001, 0.25, 0.5, 0.9, 0.99, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(share * 997));
    const double truth = values[rank - 1];
    EXPECT_EQ(histogram.quantile(share), Histogram::edge_of(Histogram::bin_of(truth)));
  }
}

TEST(Histogram, Sum_IsTheHistogramOfAllValues) {
  Histogram all;
  Histogram first;
  Histogram second;
  for (int i = 0; i < 100; ++i) {
    all.add(i * i);
    (i % 3 == 0 ? first : second).add(i * i);
  }
  first.add(second);
  EXPECT_EQ(first.text(), all.text());
  EXPECT_EQ(first.count(), 100U);
}

TEST(Histogram, Text_ListsBinsThatAreNotEmpty) {
  Histogram histogram;
  EXPECT_EQ(histogram.text(), "");
  histogram.add(0, 3);
  histogram.add(0.5);
  histogram.add(0.25, 0);
  const std::string bin = std::to_string(Histogram::bin_of(0.5));
  EXPECT_EQ(histogram.text(), "0:3 " + bin + ":1");
}

}  // namespace
}  // namespace batuta::report
