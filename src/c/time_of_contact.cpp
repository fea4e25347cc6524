// SPDX-License-Identifier: MIT
#include "numbers.hpp"

namespace batuta::detail {
namespace {

static_assert(static_cast<int>(Outcome::kFree) == BATUTA_FREE &&
                  static_cast<int>(Outcome::kContact) == BATUTA_CONTACT &&
                  static_cast<int>(Outcome::kTouching) == BATUTA_TOUCHING &&
                  static_cast<int>(Outcome::kBudget) == BATUTA_BUDGET,
              "the outcomes of batuta/c.h are those of the searches");
static_assert(kMaxBudget == 4096 && kMaxAngle<double> == 2526, "batuta/c.h says so");

template <class Scalar, class Search, class Out>
std::int32_t time_of_contact_for(const Scalar* A, const Scalar* B, const Search* search, Out* out) {
  if (A == nullptr || B == nullptr || search == nullptr || out == nullptr) {
    return BATUTA_INVALID_ARGUMENT;
  }
  if (!rounds_each_operation<Scalar>()) return BATUTA_UNAVAILABLE;
  const auto moving_A = moving_of(A, search->duration);
  const auto moving_B = moving_of(B, search->duration);
  if (!moving_A.ok() || !moving_B.ok()) return BATUTA_INVALID_ARGUMENT;
  const auto pair = make_moving_pair(moving_A.value, moving_B.value);
  if (!pair.ok()) return BATUTA_INVALID_ARGUMENT;
  const AdvancementOptions<Scalar> options = {search->tolerance, search->budget};
  const SearchResult<Scalar> found = search_advancement(pair.value, options);
  if (found.outcome == Outcome::kInvalid) return BATUTA_INVALID_ARGUMENT;
  out->outcome = static_cast<std::int32_t>(found.outcome);
  out->evaluations = found.evaluations;
  out->t_free = found.t_free;
  out->t_hit = found.t_hit;
  return BATUTA_OK;
}

template <class Scalar, class Search, class Out>
std::size_t times_of_contact_for(const Scalar* A, const Scalar* B, std::size_t count,
                                 const Search* search, Out* out) {
  if (A == nullptr || B == nullptr || search == nullptr || out == nullptr) return 0;
  return answer_each(count, [=](std::size_t i) {
    const std::size_t at = i * BATUTA_MOVING_NUMBERS;
    return time_of_contact_for(A + at, B + at, search, out + i);
  });
}

template <class Scalar>
std::int32_t twist_between_for(const Scalar* from, const Scalar* to, Scalar duration,
                               Scalar* twist) {
  if (from == nullptr || to == nullptr || twist == nullptr) return BATUTA_INVALID_ARGUMENT;
  if (!rounds_each_operation<Scalar>()) return BATUTA_UNAVAILABLE;
  const auto X0_WB = pose_of(from);
  const auto X1_WB = pose_of(to);
  if (!X0_WB.ok() || !X1_WB.ok() || !is_positive(duration)) return BATUTA_INVALID_ARGUMENT;
  const Motion<Scalar> motion = motion_between(X0_WB.value, X1_WB.value, duration);
  if (!is_valid(motion)) return BATUTA_INVALID_ARGUMENT;
  put(motion.twist.v_W, twist);
  put(motion.twist.w_W, twist + 3);
  return BATUTA_OK;
}

template <class Scalar>
std::size_t twists_between_for(const Scalar* from, const Scalar* to, std::size_t count,
                               Scalar duration, Scalar* twist) {
  if (from == nullptr || to == nullptr || twist == nullptr) return 0;
  return answer_each(count, [=](std::size_t i) {
    const std::size_t at = i * BATUTA_POSE_NUMBERS;
    return twist_between_for(from + at, to + at, duration, twist + i * BATUTA_TWIST_NUMBERS);
  });
}

}  // namespace
}  // namespace batuta::detail

std::int32_t batuta_time_of_contact_f(const float* A, const float* B, const batuta_search_f* search,
                                      batuta_contact_f* out) {
  return batuta::detail::time_of_contact_for(A, B, search, out);
}

std::int32_t batuta_time_of_contact_d(const double* A, const double* B,
                                      const batuta_search_d* search, batuta_contact_d* out) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::time_of_contact_for(A, B, search, out);
  } else {
    return BATUTA_UNAVAILABLE;
  }
}

std::size_t batuta_time_of_contact_many_f(const float* A, const float* B, std::size_t count,
                                          const batuta_search_f* search, batuta_contact_f* out) {
  return batuta::detail::times_of_contact_for(A, B, count, search, out);
}

std::size_t batuta_time_of_contact_many_d(const double* A, const double* B, std::size_t count,
                                          const batuta_search_d* search, batuta_contact_d* out) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::times_of_contact_for(A, B, count, search, out);
  } else {
    return 0;
  }
}

std::int32_t batuta_twist_between_f(const float* from, const float* to, float duration,
                                    float* twist) {
  return batuta::detail::twist_between_for(from, to, duration, twist);
}

std::int32_t batuta_twist_between_d(const double* from, const double* to, double duration,
                                    double* twist) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::twist_between_for(from, to, duration, twist);
  } else {
    return BATUTA_UNAVAILABLE;
  }
}

std::size_t batuta_twist_between_many_f(const float* from, const float* to, std::size_t count,
                                        float duration, float* twist) {
  return batuta::detail::twists_between_for(from, to, count, duration, twist);
}

std::size_t batuta_twist_between_many_d(const double* from, const double* to, std::size_t count,
                                        double duration, double* twist) {
  if constexpr (BATUTA_WITH_DOUBLE == 1) {
    return batuta::detail::twists_between_for(from, to, count, duration, twist);
  } else {
    return 0;
  }
}
