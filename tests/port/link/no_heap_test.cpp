// SPDX-License-Identifier: MIT
// From a message to bytes to a message, good ones and damaged ones: nothing is allocated.

#include <gtest/gtest.h>

#include "heap_trap.hpp"
#include "shared/link/sender.hpp"
#include "wire.hpp"

namespace batuta::link::test {
namespace {

/// Keeps the bytes of one pump() in a fixed buffer.
class Loop final : public ByteStream {
 public:
  std::array<std::uint8_t, 4096> bytes{};
  int size = 0;

 private:
  int do_read(std::uint8_t*, int) override { return 0; }
  int do_write(const std::uint8_t* in, int count) override {
    const int taken = std::min(count, static_cast<int>(bytes.size()) - size);
    std::copy_n(in, taken, bytes.begin() + size);
    size += taken;
    return taken;
  }
};

TEST(Link, ThereAndBack_AllocatesNothing) {
  const std::vector<AnyMessage> messages = one_of_each(41);
  Sender<4096> sender;
  Loop loop;
  HostDecoder host;
  DeviceDecoder device;
  const batuta::test::HeapTrap trap;
  for (const AnyMessage& any : messages) {
    const Status status = std::visit([&](const auto& m) { return sender.send(m); }, any);
    EXPECT_EQ(status, Status::kOk);
  }
  sender.pump(loop);
  for (int i = 0; i < loop.size; ++i) {
    host.push(loop.bytes[static_cast<std::size_t>(i)]);
    device.push(loop.bytes[static_cast<std::size_t>(i)]);
  }
  for (int i = 0; i < loop.size; ++i) host.push(static_cast<std::uint8_t>(i * i));
  EXPECT_EQ(trap.allocations(), 0);
  EXPECT_EQ(host.counters().accepted + device.counters().accepted,
            static_cast<std::uint32_t>(kMessages));
}

}  // namespace
}  // namespace batuta::link::test
