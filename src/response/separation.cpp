// SPDX-License-Identifier: MIT
#include "batuta/response/separation.hpp"

namespace batuta {

namespace {

template <class Scalar>
bool is_valid(const SeparationOptions<Scalar>& options) {
  return is_positive(options.distance) && is_positive(options.rest_speed) &&
         is_positive(options.min_duration) && options.limit_A >= Scalar(0) &&
         options.limit_B >= Scalar(0);
}

/// share / (share + other), also where the sum would overflow; 0 where neither can move.
template <class Scalar>
Scalar part(Scalar share, Scalar other) {
  const Scalar larger = max_of(share, other);
  if (larger == Scalar(0)) return Scalar(0);
  const Scalar a = share / larger;
  const Scalar b = other / larger;
  return a / (a + b);
}

}  // namespace

template <class Scalar>
Result<Separation<Scalar>> separate(const Contact<Scalar>& contact, Scalar v_rel,
                                    Scalar inverse_mass_A, Scalar inverse_mass_B,
                                    const SeparationOptions<Scalar>& options) {
  const Scalar lost = Scalar(0) * inverse_mass_A + Scalar(0) * inverse_mass_B + Scalar(0) * v_rel +
                      Scalar(0) * contact.gap + detail::nan_unless_finite(contact.normal_BA_W);
  const bool has_numbers = lost == Scalar(0);  // no number where one of them is not finite
  Result<Separation<Scalar>> made;
  if (!has_numbers || inverse_mass_A < Scalar(0) || inverse_mass_B < Scalar(0) ||
      !is_valid(options)) {
    return made;
  }
  const Scalar speed = max_of(v_rel < Scalar(0) ? -v_rel : v_rel, options.rest_speed);
  const Scalar missing = max_of(Scalar(0), options.distance - contact.gap);
  const Scalar want_A = missing * part(inverse_mass_A, inverse_mass_B);
  const Scalar want_B = missing * part(inverse_mass_B, inverse_mass_A);
  // What a neighbour leaves one no room for, neither does: the common centre of mass stays.
  Scalar share = 1;
  if (options.limit_A < want_A) share = options.limit_A / want_A;
  if (options.limit_B < want_B) share = min_of(share, options.limit_B / want_B);
  const Scalar shift_A = min_of(options.limit_A, share * want_A);
  const Scalar shift_B = min_of(options.limit_B, share * want_B);
  Separation<Scalar>& separation = made.value;
  separation.shift_A_W = shift_A * contact.normal_BA_W;
  separation.shift_B_W = -shift_B * contact.normal_BA_W;
  separation.duration = max_of(options.min_duration, options.distance / speed / 2);
  Scalar sum = separation.duration;  // not finite where one of them is not
  for (int i = 0; i < 3; ++i) sum += separation.shift_A_W[i] - separation.shift_B_W[i];  // Bound: 3
  made.status = Status::kOk;
  if (!is_finite(sum)) made = {};
  return made;
}

#define BATUTA_INSTANTIATE(S) \
  template Result<Separation<S>> separate(const Contact<S>&, S, S, S, const SeparationOptions<S>&);
BATUTA_FOR_EACH_SCALAR(BATUTA_INSTANTIATE)
#undef BATUTA_INSTANTIATE

}  // namespace batuta
