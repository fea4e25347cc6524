// SPDX-License-Identifier: MIT
#pragma once
// What is asked of the library, section by section.

#include "input.hpp"
#include "recorder.hpp"

namespace batuta::digest {

/// Answers a chunk of queries: three sections from one of times of contact, else one.
/// Bound: records of the chunk.
void answer_times_of_contact(Input& input, Recorder& recorder);
void answer_distances(Input& input, Recorder& recorder);
void answer_impulses(Input& input, Recorder& recorder);

/// Fences through a recording: a new bout begins where one is over.
/// @param number  of the recording, for index_in()
/// Bound: `steps` steps.
void fence(Input& input, std::uint32_t number, std::uint32_t steps, Recorder& recorder);

/// 1,000,000 steps of bodies that are hard to integrate. Needs no queries.
void fly(Recorder& recorder);

/// Steps of all ready-made scenes. Bound: kSteps steps each.
void play_scenes(Recorder& recorder);

}  // namespace batuta::digest
