// SPDX-License-Identifier: MIT
#include "batuta/core/types.hpp"

float sum(int n);
float sum(int n) {
  const Eigen::MatrixXf m = Eigen::MatrixXf::Ones(n, n);
  return m.sum();
}
