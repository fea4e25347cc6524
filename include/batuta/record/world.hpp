// SPDX-License-Identifier: MIT
#pragma once
// Include it to save, restore, record or hash a World, with all that it holds.

#include "batuta/record/detail/world.hpp"
