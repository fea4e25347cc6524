// SPDX-License-Identifier: MIT
#pragma once
// The same arithmetic on W numbers at once: a lane each. Every operation is the scalar's own,
// rounded alike, so that a lane has the bits that the same formula gives one at a time. Branches
// become choices by a mask. With W = 1 they are plain numbers: what a machine without vectors runs.

#include <cstddef>
#include <cstring>
#include <utility>

#include "batuta/core/types.hpp"

// Whether the compiler has vectors of numbers, as g++ and clang have. Without them a lane is a
// number.
#ifndef BATUTA_VECTORS
#if defined(__GNUC__) || defined(__clang__)
#define BATUTA_VECTORS 1
#else
#define BATUTA_VECTORS 0
#endif
#endif

// A lane's operation is one instruction: as a call it would cost ten, and pass wide vectors.
// Coverage counts calls: it would count the branches of each copy anew.
#ifndef BATUTA_LANE
#define BATUTA_LANE [[gnu::always_inline]] inline
#endif

namespace batuta::lanes {

/// Bytes that this build's machine works on at once; 0: it has no vectors that are known here.
#if !BATUTA_VECTORS
inline constexpr std::size_t kMachineBytes = 0;
#elif defined(__AVX512F__)
inline constexpr std::size_t kMachineBytes = 64;
#elif defined(__AVX__)
inline constexpr std::size_t kMachineBytes = 32;
#elif defined(__SSE2__) || defined(__aarch64__)
inline constexpr std::size_t kMachineBytes = 16;
#else
inline constexpr std::size_t kMachineBytes = 0;
#endif

/// Lanes of this build: the width that its machine works on at once.
template <class Scalar>
inline constexpr int kWidth = kMachineBytes == 0 ? 1 : int(kMachineBytes / sizeof(Scalar));

template <class Scalar>
struct BitsOf;
template <>
struct BitsOf<float> {
  using Type = std::int32_t;
};
template <>
struct BitsOf<double> {
  using Type = std::int64_t;
};

/// A condition for each lane: all bits, or none.
template <class Scalar, int W>
struct Mask;
#if BATUTA_VECTORS
template <class Scalar, int W>
struct Mask {
  using Bits = typename BitsOf<Scalar>::Type;
  typedef Bits Vector __attribute__((vector_size(W * sizeof(Bits))));
  Vector v;

  BATUTA_LANE bool operator[](int lane) const { return v[lane] != 0; }
  BATUTA_LANE friend Mask operator&(const Mask& x, const Mask& y) { return {x.v & y.v}; }
  BATUTA_LANE friend Mask operator|(const Mask& x, const Mask& y) { return {x.v | y.v}; }
  BATUTA_LANE friend Mask operator~(const Mask& x) { return {~x.v}; }
};
#endif
template <class Scalar>
struct Mask<Scalar, 1> {
  bool v;

  BATUTA_LANE bool operator[](int /*lane*/) const { return v; }
  // Both sides are known: no branch.
  BATUTA_LANE friend Mask operator&(const Mask& x, const Mask& y) { return {(x.v & y.v) != 0}; }
  BATUTA_LANE friend Mask operator|(const Mask& x, const Mask& y) { return {(x.v | y.v) != 0}; }
  BATUTA_LANE friend Mask operator~(const Mask& x) { return {!x.v}; }
};

/// Whether a condition holds in any lane. Bound: W lanes, two or more at a time.
template <class Scalar, int W>
BATUTA_LANE bool any(const Mask<Scalar, W>& mask) {
  if constexpr (W == 1) {
    return mask.v;
  } else {
    constexpr std::size_t kWords = sizeof(mask.v) / sizeof(std::uint64_t);
    std::uint64_t words[kWords];
    std::memcpy(words, &mask.v, sizeof(words));
    std::uint64_t set = 0;
    for (const std::uint64_t word : words) set |= word;  // Bound: W lanes
    return set != 0;
  }
}

/// W numbers.
template <class ScalarT, int W>
struct Lanes;
#if BATUTA_VECTORS
template <class ScalarT, int W>
struct Lanes {
  using Scalar = ScalarT;
  using Truth = Mask<Scalar, W>;
  static constexpr int kLanes = W;
  typedef Scalar Vector __attribute__((vector_size(W * sizeof(Scalar))));
  Vector v;

  Lanes() = default;
  // cppcheck-suppress noExplicitConstructor ; deviation: lanes
  BATUTA_LANE Lanes(const Vector& vector) : v(vector) {}
  // cppcheck-suppress noExplicitConstructor ; deviation: lanes
  BATUTA_LANE Lanes(Scalar x) : v(x - Vector{}) {}  // x - 0 has the bits of x, -0 too
  BATUTA_LANE Scalar operator[](int lane) const { return v[lane]; }
  BATUTA_LANE void set(int lane, Scalar x) { v[lane] = x; }

  BATUTA_LANE friend Lanes operator+(const Lanes& x, const Lanes& y) { return x.v + y.v; }
  BATUTA_LANE friend Lanes operator-(const Lanes& x, const Lanes& y) { return x.v - y.v; }
  BATUTA_LANE friend Lanes operator*(const Lanes& x, const Lanes& y) { return x.v * y.v; }
  BATUTA_LANE friend Lanes operator/(const Lanes& x, const Lanes& y) { return x.v / y.v; }
  BATUTA_LANE friend Lanes operator-(const Lanes& x) { return -x.v; }
  BATUTA_LANE friend Truth operator<(const Lanes& x, const Lanes& y) { return {x.v < y.v}; }
  BATUTA_LANE friend Truth operator>(const Lanes& x, const Lanes& y) { return {x.v > y.v}; }
  BATUTA_LANE friend Truth operator<=(const Lanes& x, const Lanes& y) { return {x.v <= y.v}; }
  BATUTA_LANE friend Truth operator>=(const Lanes& x, const Lanes& y) { return {x.v >= y.v}; }
  BATUTA_LANE friend Truth operator==(const Lanes& x, const Lanes& y) { return {x.v == y.v}; }
};
#endif
template <class ScalarT>
struct Lanes<ScalarT, 1> {
  using Scalar = ScalarT;
  using Truth = Mask<Scalar, 1>;
  static constexpr int kLanes = 1;
  Scalar v;

  Lanes() = default;
  // cppcheck-suppress noExplicitConstructor ; deviation: lanes
  BATUTA_LANE Lanes(Scalar x) : v(x) {}
  BATUTA_LANE Scalar operator[](int /*lane*/) const { return v; }
  BATUTA_LANE void set(int /*lane*/, Scalar x) { v = x; }

  BATUTA_LANE friend Lanes operator+(const Lanes& x, const Lanes& y) { return x.v + y.v; }
  BATUTA_LANE friend Lanes operator-(const Lanes& x, const Lanes& y) { return x.v - y.v; }
  BATUTA_LANE friend Lanes operator*(const Lanes& x, const Lanes& y) { return x.v * y.v; }
  BATUTA_LANE friend Lanes operator/(const Lanes& x, const Lanes& y) { return x.v / y.v; }
  BATUTA_LANE friend Lanes operator-(const Lanes& x) { return -x.v; }
  BATUTA_LANE friend Truth operator<(const Lanes& x, const Lanes& y) { return {x.v < y.v}; }
  BATUTA_LANE friend Truth operator>(const Lanes& x, const Lanes& y) { return {x.v > y.v}; }
  BATUTA_LANE friend Truth operator<=(const Lanes& x, const Lanes& y) { return {x.v <= y.v}; }
  BATUTA_LANE friend Truth operator>=(const Lanes& x, const Lanes& y) { return {x.v >= y.v}; }
  BATUTA_LANE friend Truth operator==(const Lanes& x, const Lanes& y) { return {x.v == y.v}; }
};

/// x where the condition holds, else y.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> select(const Mask<Scalar, W>& mask, const Lanes<Scalar, W>& x,
                                    const Lanes<Scalar, W>& y) {
  return mask.v ? x.v : y.v;
}

/// Bound: W lanes.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> root(const Lanes<Scalar, W>& x) {
  if constexpr (W == 1) {
    return std::sqrt(x.v);
  } else {
    Lanes<Scalar, W> roots;
    for (int i = 0; i < W; ++i) roots.v[i] = std::sqrt(x.v[i]);  // Bound: W lanes
    return roots;
  }
}

/// The numbers as bits, and back.
template <class Scalar, int W>
BATUTA_LANE typename Mask<Scalar, W>::Vector bits_of(const Lanes<Scalar, W>& x) {
  typename Mask<Scalar, W>::Vector bits;
  std::memcpy(&bits, &x.v, sizeof(bits));
  return bits;
}
template <class Scalar, int W>
BATUTA_LANE void set_bits(Lanes<Scalar, W>& x, const typename Mask<Scalar, W>::Vector& bits) {
  std::memcpy(&x.v, &bits, sizeof(bits));
}

/// |x|: x without its sign.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> magnitude(const Lanes<Scalar, W>& x) {
  if constexpr (W == 1) {
    return std::abs(x.v);
  } else {
    Lanes<Scalar, W> result;
    set_bits(result, bits_of(x) & std::numeric_limits<typename BitsOf<Scalar>::Type>::max());
    return result;
  }
}

/// -x where the condition holds, else x.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> negated_where(const Mask<Scalar, W>& mask, const Lanes<Scalar, W>& x) {
  if constexpr (W == 1) {
    return mask.v ? -x.v : x.v;
  } else {
    Lanes<Scalar, W> result;
    set_bits(result,
             bits_of(x) ^ (mask.v & std::numeric_limits<typename BitsOf<Scalar>::Type>::min()));
    return result;
  }
}

/// Exchanges x and y where the condition holds.
template <class Scalar, int W>
BATUTA_LANE void swap_where(const Mask<Scalar, W>& mask, Lanes<Scalar, W>& x, Lanes<Scalar, W>& y) {
  if constexpr (W == 1) {
    if (mask.v) std::swap(x, y);
  } else {
    if constexpr (kMachineBytes > 16) {  // which choose in one instruction; the others take three
      const Lanes<Scalar, W> was_x = x;
      x = select(mask, y, x);
      y = select(mask, was_x, y);
      return;
    }
    const auto difference = (bits_of(x) ^ bits_of(y)) & mask.v;
    set_bits(x, bits_of(x) ^ difference);
    set_bits(y, bits_of(y) ^ difference);
  }
}

/// To [0, 1]; never -0, and 0 for what is no number. A compiler may not make the one instruction of
/// x86 for each half out of the comparison, because it is told to keep -0 and NaN; both are these.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> unit_clamp(const Lanes<Scalar, W>& x) {
  using L = Lanes<Scalar, W>;
#if BATUTA_VECTORS && defined(__SSE2__)
  if constexpr (std::is_same_v<Scalar, float> && W == 4) {
    return __builtin_ia32_minps(__builtin_ia32_maxps(x.v, L(0).v), L(1).v);
  }
  if constexpr (std::is_same_v<Scalar, double> && W == 2) {
    return __builtin_ia32_minpd(__builtin_ia32_maxpd(x.v, L(0).v), L(1).v);
  }
#endif
#if BATUTA_VECTORS && defined(__AVX__)
  if constexpr (std::is_same_v<Scalar, float> && W == 8) {
    return __builtin_ia32_minps256(__builtin_ia32_maxps256(x.v, L(0).v), L(1).v);
  }
  if constexpr (std::is_same_v<Scalar, double> && W == 4) {
    return __builtin_ia32_minpd256(__builtin_ia32_maxpd256(x.v, L(0).v), L(1).v);
  }
#endif
  const L low = select(x > L(0), x, L(0));
  return select(low < L(1), low, L(1));
}

/// max_of() in each lane: the first wins a tie.
template <class Scalar, int W>
BATUTA_LANE Lanes<Scalar, W> greater_of(const Lanes<Scalar, W>& x, const Lanes<Scalar, W>& y) {
  return select(x < y, y, x);
}

/// W vectors of three. Sums of products in the order of Eigen's, which the kernels have:
/// x + (y + z).
template <class L>
struct Vector {
  L x, y, z;

  BATUTA_LANE friend Vector operator+(const Vector& p, const Vector& q) {
    return {p.x + q.x, p.y + q.y, p.z + q.z};
  }
  BATUTA_LANE friend Vector operator-(const Vector& p, const Vector& q) {
    return {p.x - q.x, p.y - q.y, p.z - q.z};
  }
  BATUTA_LANE friend Vector operator*(const L& k, const Vector& p) {
    return {k * p.x, k * p.y, k * p.z};
  }
  BATUTA_LANE friend Vector operator/(const Vector& p, const L& k) {
    return {p.x / k, p.y / k, p.z / k};
  }
};

template <class L>
BATUTA_LANE L dot(const Vector<L>& p, const Vector<L>& q) {
  return p.x * q.x + (p.y * q.y + p.z * q.z);
}
template <class L>
BATUTA_LANE Vector<L> cross(const Vector<L>& p, const Vector<L>& q) {
  return {p.y * q.z - p.z * q.y, p.z * q.x - p.x * q.z, p.x * q.y - p.y * q.x};
}
template <class L>
BATUTA_LANE Vector<L> select(const typename L::Truth& mask, const Vector<L>& p,
                             const Vector<L>& q) {
  return {select(mask, p.x, q.x), select(mask, p.y, q.y), select(mask, p.z, q.z)};
}

template <class L>
BATUTA_LANE void swap_where(const typename L::Truth& mask, Vector<L>& p, Vector<L>& q) {
  swap_where(mask, p.x, q.x);
  swap_where(mask, p.y, q.y);
  swap_where(mask, p.z, q.z);
}

/// W numbers from `from` on. Bound: W lanes.
template <class L>
BATUTA_LANE L load(const typename L::Scalar* from) {
  L x;
  std::memcpy(&x.v, from, sizeof(x.v));
  return x;
}
template <class L>
BATUTA_LANE void store(const L& x, typename L::Scalar* to) {
  std::memcpy(to, &x.v, sizeof(x.v));
}

}  // namespace batuta::lanes
