// SPDX-License-Identifier: MIT
// Replays a recorded bout on a part. Argument: the file. Exit status: 0 every hash agreed; 1 it
// parted, or is no whole recording of this duel; 2 wrong use.
#include <new>

#include "batuta/record/duel.hpp"
#include "batuta/record/player.hpp"
#include "io.hpp"
#include "text.hpp"

namespace {

using namespace batuta;
using namespace batuta::fencing;
using DuelType = Duel<>;

class DebuggerFile final : public ByteSource {
 public:
  explicit DebuggerFile(const char* path) : file_(digest::open_to_read(path)) {}
  bool is_open() const { return file_ >= 0; }

 private:
  int do_read(std::uint8_t* bytes, int capacity) override {
    const auto count = digest::read_bytes(file_, bytes, static_cast<std::uint32_t>(capacity));
    return count > 0 ? static_cast<int>(count) : -1;
  }

  digest::File file_;
};

// Too large for a stack.
alignas(DuelType) std::array<std::uint8_t, sizeof(DuelType)> duel_place;
std::array<std::uint8_t, static_cast<std::size_t>(Player::kRoom<DuelType>)> buffer;

int replay(const char* path) {
  DebuggerFile file(path);
  if (!file.is_open()) return 2;
  DuelType& duel = *new (duel_place.data()) DuelType;
  Player player(file, buffer.data(), static_cast<int>(buffer.size()));
  Playback answer = player.begin<DuelInput>(duel);
  while (answer == Playback::kReady || answer == Playback::kStep) {  // Bound: the file
    DuelInput input;
    answer = player.next(input, duel);
    if (answer == Playback::kStep) (void)duel.step(input.at(Side::kLeft), input.at(Side::kRight));
  }
  digest::Text line;
  line << "answer " << static_cast<std::uint32_t>(answer) << " steps " << player.steps()
       << " hashes " << player.agreed() << "\n";
  digest::say(line.c_str());
  return answer == Playback::kEnd ? 0 : 1;
}

}  // namespace

int main(int count, char** words) {
  const digest::Words line = digest::command_line(count, words);
  return digest::leave(line.count == 1 ? replay(line.word[0]) : 2);
}
