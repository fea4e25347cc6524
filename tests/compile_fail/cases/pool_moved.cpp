// SPDX-License-Identifier: MIT
#include <utility>

#include "batuta/core/pool.hpp"

void move(batuta::Pool<int, 4>& pool);
void move(batuta::Pool<int, 4>& pool) {
  batuta::Pool<int, 4> other = std::move(pool);
  (void)other;
}
