// SPDX-License-Identifier: MIT
#pragma once
// One answer of the library, field by field, as a hash of its bits. Every bit counts but those of a
// NaN, whose sign and payload IEEE 754 leaves open.

#include <cstring>

#include "batuta/core/types.hpp"

namespace batuta::digest {

/// FNV-1a, over words instead of bytes: two sequences that differ in one word never agree.
class Fingerprint {
 public:
  void add(std::uint32_t word) { hash_ = (hash_ ^ word) * kPrime; }
  void add(std::uint64_t words) {
    add(static_cast<std::uint32_t>(words));
    add(static_cast<std::uint32_t>(words >> 32U));
  }
  std::uint64_t value() const { return hash_; }

 private:
  static constexpr std::uint64_t kOffset = 14695981039346656037U;
  static constexpr std::uint64_t kPrime = 1099511628211U;
  std::uint64_t hash_ = kOffset;
};

inline std::uint32_t bits_of(float x) {
  constexpr std::uint32_t kCanonicalNan = 0x7fc00000U;
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof x);
  std::memcpy(&bits, &x, sizeof bits);
  return x == x ? bits : kCanonicalNan;
}

inline float float_of(std::uint32_t bits) {
  float x = 0;
  std::memcpy(&x, &bits, sizeof x);
  return x;
}

/// Hears of each word of an answer that is shown.
class AnswerListener {
 public:
  virtual void on_word(const char* field, std::uint32_t word) = 0;

 protected:
  AnswerListener() = default;
  ~AnswerListener() = default;
  AnswerListener(const AnswerListener&) = default;
  AnswerListener& operator=(const AnswerListener&) = default;
};

class Answer {
 public:
  /// @param listener  null: nobody listens
  /// @param doctored  the first float is given one ulp more: what a digest must not overlook
  explicit Answer(AnswerListener* listener = nullptr, bool doctored = false)
      : listener_(listener), doctored_(doctored) {}

  void add(const char* field, float x) {
    add_word(field, bits_of(x) + (doctored_ ? 1U : 0U));
    doctored_ = false;
  }
  void add(const char* field, std::uint32_t count) { add_word(field, count); }
  void add(const char* field, bool yes) { add_word(field, yes ? 1U : 0U); }
  template <class Enum, std::enable_if_t<std::is_enum_v<Enum>, int> = 0>
  void add(const char* field, Enum word) {
    add_word(field, static_cast<std::uint32_t>(word));
  }
  template <class Derived>
  void add(const char* field, const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) add(field, matrix.derived().coeff(i));
  }
  void add(const char* field, const Quat<float>& q) { add(field, q.coeffs()); }

  std::uint64_t hash() const { return fingerprint_.value(); }

 private:
  void add_word(const char* field, std::uint32_t word) {
    fingerprint_.add(word);
    if (listener_ != nullptr) listener_->on_word(field, word);
  }

  Fingerprint fingerprint_;
  AnswerListener* listener_;
  bool doctored_;
};

}  // namespace batuta::digest
