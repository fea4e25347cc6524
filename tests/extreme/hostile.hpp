// SPDX-License-Identifier: MIT
#pragma once
// The numbers of hostile_numbers.hpp, put into every place of an argument in turn. An argument is a
// struct of nothing but scalars, so that every one of its numbers is reached without a list that
// could be forgotten.

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "batuta/core/status.hpp"
#include "batuta/core/types.hpp"
#include "draws.hpp"
#include "hostile_numbers.hpp"

namespace batuta::test {

template <class S, class T>
constexpr std::size_t count_of() {
  static_assert(std::is_trivially_destructible_v<T> && sizeof(T) % sizeof(S) == 0,
                "a struct of scalars");
  return sizeof(T) / sizeof(S);
}

template <class S, class T>
void put(T& argument, std::size_t place, S number) {
  // By way of bytes: the struct is plain data, whatever Eigen's constructors say.
  std::memcpy(reinterpret_cast<unsigned char*>(&argument) + place * sizeof(S), &number, sizeof(S));
}

/// Whether every scalar of an answer is finite.
template <class S, class T>
bool all_finite(const T& answer) {
  for (std::size_t i = 0; i < count_of<S, T>(); ++i) {
    S number;
    std::memcpy(&number, reinterpret_cast<const unsigned char*>(&answer) + i * sizeof(S),
                sizeof(S));
    if (!is_finite(number)) return false;
  }
  return true;
}

/// Whether two objects without padding are the same, byte for byte.
template <class T>
bool same_bytes(const T& a, const T& b) {
  return std::memcmp(static_cast<const void*>(&a), static_cast<const void*>(&b), sizeof(T)) == 0;
}

/// Calls judge(spoiled, is_number) with each number of kHostile in each place, and `draws` times
/// with two places spoiled.
/// @param draws  how many pairs of places are tried
template <class S, class T, class Judge>
void for_each_spoiled(const T& good, int draws, const Judge& judge) {
  for (std::size_t place = 0; place < count_of<S, T>(); ++place) {
    for (const S number : kHostile<S>) {
      T spoiled = good;
      put(spoiled, place, number);
      SCOPED_TRACE(testing::Message() << "place " << place << " number " << number);
      judge(spoiled, is_finite(number));
    }
  }
  for (int i = 0; i < draws; ++i) {
    Draws draw(20061107, 6, static_cast<std::uint64_t>(i));
    T spoiled = good;
    for (int k = 0; k < 2; ++k) {
      const auto place = static_cast<std::size_t>(draw.unit() * count_of<S, T>());
      put(spoiled, place, kHostile<S>[static_cast<std::size_t>(draw.unit() * kHostile<S>.size())]);
    }
    SCOPED_TRACE(testing::Message() << "draw " << i);
    judge(spoiled, all_finite<S>(spoiled));
  }
}

/// Each number of `good` may be anything above zero, those of `zero_too` also zero, and no other.
template <class S, class T, class Take>
void expect_taken(const T& good, const std::vector<bool>& zero_too, const Take& take) {
  ASSERT_EQ(zero_too.size(), (count_of<S, T>()));
  ASSERT_EQ(take(good), Status::kOk);
  for (std::size_t place = 0; place < zero_too.size(); ++place) {
    for (const S number : kHostile<S>) {
      T spoiled = good;
      put(spoiled, place, number);
      const bool fits = is_finite(number) && (zero_too[place] ? number >= 0 : number > 0);
      EXPECT_EQ(take(spoiled), fits ? Status::kOk : Status::kInvalidArgument)
          << "place " << place << " number " << number;
    }
  }
}

/// `count` numbers that belong to `index`: one in three hostile, the others within 3.
template <class S>
std::vector<S> some_of(std::size_t count, int index) {
  Draws draw(20061107, 61, static_cast<std::uint64_t>(index));
  std::vector<S> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const bool hostile = draw.chance(0.3);
    const auto which = static_cast<std::size_t>(draw.unit() * kHostile<S>.size());
    numbers.push_back(hostile ? kHostile<S>[which] : static_cast<S>(draw.between(-3, 3)));
  }
  return numbers;
}

using Scalars = testing::Types<float, double>;

}  // namespace batuta::test
