// SPDX-License-Identifier: MIT
#include "batuta/world/scene.hpp"

namespace batuta {

template <class Scalar>
Status validate(const WorldSettings<Scalar>& settings) {
  const bool good = validate(settings.search) == Status::kOk && is_positive(settings.rest_speed) &&
                    is_positive(settings.separation) && is_positive(settings.min_separation_time);
  return good ? Status::kOk : Status::kInvalidArgument;
}

template Status validate(const WorldSettings<float>&);
template Status validate(const WorldSettings<double>&);

}  // namespace batuta
