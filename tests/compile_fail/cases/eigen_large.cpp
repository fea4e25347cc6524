// SPDX-License-Identifier: MIT
#include "batuta/core/types.hpp"

float sum();
float sum() {
  const Eigen::Matrix<float, 17, 17> m = Eigen::Matrix<float, 17, 17>::Ones();
  return m.sum();
}
