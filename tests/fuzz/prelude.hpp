// SPDX-License-Identifier: MIT
#pragma once
// What nearly every fuzzed source includes, compiled once: most of the time of compiling them.

#include "batuta/detection/search.hpp"
#include "batuta/response/friction.hpp"
