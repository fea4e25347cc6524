// SPDX-License-Identifier: MIT
// The serial line, with the test in the place of the wire.

#include "platforms/stm32f405/drivers/usart_stream.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace batuta::stm32f405 {
namespace {

class UsartStreamTest : public ::testing::Test {
 protected:
  UsartStreamTest() { stream_.start(28); }

  /// A byte arrives with these flags in SR.
  void arrive(char byte, std::uint32_t flags = Usart::kSrRxne) {
    usart_.sr = flags;
    usart_.dr = static_cast<std::uint8_t>(byte);
    stream_.on_interrupt();
  }
  std::string read() {
    std::array<std::uint8_t, 64> bytes{};
    const int count = stream_.read(bytes.data(), 64);
    return std::string(bytes.begin(), bytes.begin() + count);
  }
  int write(const std::string& text) {
    return stream_.write(reinterpret_cast<const std::uint8_t*>(text.data()),
                         static_cast<int>(text.size()));
  }
  bool interrupt_wanted() const { return (usart_.cr1 & Usart::kCr1Txeie) != 0; }

  Usart usart_{};
  UsartStream stream_{usart_};
};

TEST_F(UsartStreamTest, Bytes_ComeInTheirOrder) {
  EXPECT_EQ(usart_.brr, 28U);
  EXPECT_EQ(read(), "");
  for (const char byte : std::string("beat")) arrive(byte);
  EXPECT_EQ(read(), "beat");
  EXPECT_EQ(read(), "");
}

TEST_F(UsartStreamTest, SpoiledBytes_AreCountedAndDropped) {
  arrive('a');
  arrive('b', Usart::kSrRxne | Usart::kSrFe);
  arrive('c', Usart::kSrRxne | Usart::kSrNf);
  arrive('d', Usart::kSrRxne | Usart::kSrOre);  // d is whole; the one after it is lost
  arrive('e', Usart::kSrOre);                   // nothing new in DR
  EXPECT_EQ(read(), "ad");
  const UsartFaults faults = stream_.faults();
  EXPECT_EQ(faults.framing, 1U);
  EXPECT_EQ(faults.noise, 1U);
  EXPECT_EQ(faults.overruns, 2U);
  EXPECT_EQ(faults.full, 0U);
}

TEST_F(UsartStreamTest, NobodyReads_TheNewestAreDroppedAndCounted) {
  for (std::uint32_t i = 0; i < UsartStream::kReceiveBytes + 5; ++i) {
    arrive(static_cast<char>('a' + i % 26));
  }
  EXPECT_EQ(stream_.faults().full, 5U);
  EXPECT_EQ(read().substr(0, 3), "abc");
}

TEST_F(UsartStreamTest, Writing_StartsTheLineAndTheInterruptKeepsItGoing) {
  usart_.sr = 0;  // the line is busy
  EXPECT_EQ(write("xyz"), 3);
  EXPECT_TRUE(interrupt_wanted());
  for (const char expected : std::string("xyz")) {
    usart_.sr = Usart::kSrTxe;
    stream_.on_interrupt();
    EXPECT_EQ(usart_.dr, static_cast<std::uint32_t>(expected));
  }
  EXPECT_TRUE(interrupt_wanted());
  stream_.on_interrupt();  // nothing left
  EXPECT_FALSE(interrupt_wanted());
}

TEST_F(UsartStreamTest, LineThatIsAlwaysFree_NeedsNoInterrupt) {
  usart_.sr = Usart::kSrTxe;  // as an emulator has it
  EXPECT_EQ(write("pq"), 2);
  EXPECT_EQ(usart_.dr, static_cast<std::uint32_t>('q'));
  EXPECT_FALSE(interrupt_wanted());
}

TEST_F(UsartStreamTest, BusyLine_TakesWhatFitsAndSaysSo) {
  usart_.sr = 0;
  const std::string much(UsartStream::kTransmitBytes + 10, 'z');
  EXPECT_EQ(write(much), static_cast<int>(UsartStream::kTransmitBytes));
  EXPECT_EQ(write("z"), 0);
}

}  // namespace
}  // namespace batuta::stm32f405
