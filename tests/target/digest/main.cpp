// SPDX-License-Identifier: MIT
// batuta_digest: answers a file of queries and hashes every bit of the answers; the same program on
// every compiler and part. Words: --in FILE, --hashes FILE, --every K, --only SECTION,
// --show SECTION INDEX, --doctor SECTION INDEX (options.hpp).
// Exit status: 0 all answered; 1 a file cannot be read or written; 2 wrong words.
#include "batuta/core/arithmetic.hpp"
#include "sections.hpp"

namespace batuta::digest {
namespace {

constexpr int kExitFile = 1;
constexpr int kExitUsage = 2;

int complain(int status, const char* what) {
  say("batuta_digest: ");
  say(what);
  say("\n");
  return status;
}

void answer(const ChunkHead& head, std::uint32_t& bouts, Input& input, Recorder& recorder) {
  switch (static_cast<Chunk>(head.chunk)) {
    case Chunk::kToc:
      return answer_times_of_contact(input, recorder);
    case Chunk::kDistance:
      return answer_distances(input, recorder);
    case Chunk::kImpulse:
      return answer_impulses(input, recorder);
    case Chunk::kBout:
      fence(input, bouts, head.parameter, recorder);
      ++bouts;
      return;
  }
}

int run(const Words& words) {
  static Input input;
  Options options;
  if (!read_options(words, options)) return complain(kExitUsage, "wrong words");
  Recorder recorder(options);
  if (!recorder.open()) return complain(kExitFile, "the file of hashes cannot be written");
  if (!input.open(options.in)) return complain(kExitFile, "there is no file of queries");
  std::uint32_t bouts = 0;
  ChunkHead head;
  while (input.next(head)) answer(head, bouts, input, recorder);  // Bound: chunks of the file
  input.close();
  fly(recorder);
  play_scenes(recorder);
  if (!input.ok()) return complain(kExitFile, "the file of queries is cut off");
  if (!recorder.close()) return complain(kExitFile, "the file of hashes cannot be written");
  recorder.print();
  if (!rounds_each_operation<float>())
    say("warning: the arithmetic is not what the library needs\n");
  return 0;
}

}  // namespace
}  // namespace batuta::digest

int main(int count, char** words) {
  return batuta::digest::leave(batuta::digest::run(batuta::digest::command_line(count, words)));
}
