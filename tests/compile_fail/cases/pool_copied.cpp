// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

void copy(const batuta::Pool<int, 4>& pool);
void copy(const batuta::Pool<int, 4>& pool) {
  batuta::Pool<int, 4> other = pool;
  (void)other;
}
