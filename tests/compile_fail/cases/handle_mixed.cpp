// SPDX-License-Identifier: MIT
#include "batuta/core/pool.hpp"

int* find(batuta::Pool<int, 4>& pool, batuta::Handle<float> handle);
int* find(batuta::Pool<int, 4>& pool, batuta::Handle<float> handle) {
  return pool.get(handle);
}
