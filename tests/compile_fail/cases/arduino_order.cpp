// SPDX-License-Identifier: MIT
// Headers of the library after those that make macros of other people's names (ARDUINO_FIRST, or
// one given by a flag), and before.
#ifdef ARDUINO_FIRST
#include <Arduino.h>
#endif

#include "batuta/core/types.hpp"

#ifndef ARDUINO_FIRST
#include <Arduino.h>
#endif

static_assert(batuta::Vec3<float>::SizeAtCompileTime == 3);
