// SPDX-License-Identifier: MIT
#include "batuta/record/archive.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "batuta/core/fixed_list.hpp"
#include "batuta/core/pool.hpp"

namespace batuta {
namespace {

enum class Colour : std::uint8_t { kRed, kGreen, kBlue };
constexpr Colour last_of(Colour) {
  return Colour::kBlue;
}

/// One member of every kind that an archive knows.
struct Everything {
  bool flag = false;
  Colour colour = Colour::kRed;
  std::int8_t small = 0;
  std::uint16_t medium = 0;
  std::int32_t number = 0;
  std::uint64_t large = 0;
  float real = 0;
  double precise = 0;
  Vec3<float> place = Vec3<float>::Zero();
  Quat<float> turn = Quat<float>::Identity();
  FixedList<std::uint16_t, 3> list;
  std::array<std::uint8_t, 2> pair{};

  void archive(Archive& ar) {
    auto& [a, b, c, d, e, f, g, h, i, j, k, l] = *this;
    ar(a, b, c, d, e, f, g, h, i, j, k, l);
  }
};

Everything example() {
  Everything x;
  x.flag = true;
  x.colour = Colour::kBlue;
  x.small = -2;
  x.medium = 0x1234;
  x.number = -1000000;
  x.large = 0x0102030405060708U;
  x.real = 1.5F;
  x.precise = -2.0;
  x.place = {1, 2, 3};
  x.turn = Quat<float>(0.5F, 0.25F, -0.5F, 1);  // w, x, y, z
  x.list.push(7);
  x.list.push(0xABCD);
  x.pair = {9, 8};
  return x;
}

/// Written by hand, after the document.
const std::vector<std::uint8_t> kExampleBytes = {
    1,                                         // flag
    2,                                         // colour
    0xFE,                                      // small
    0x34, 0x12,                                // medium
    0xC0, 0xBD, 0xF0, 0xFF,                    // number: 0xFFF0BDC0
    8,    7,    6,    5,    4,    3, 2, 1,     // large
    0,    0,    0xC0, 0x3F,                    // 1.5
    0,    0,    0,    0,    0,    0, 0, 0xC0,  // -2
    0,    0,    0x80, 0x3F,                    // 1
    0,    0,    0,    0x40,                    // 2
    0,    0,    0x40, 0x40,                    // 3
    0,    0,    0x80, 0x3E,                    // x: 0.25
    0,    0,    0,    0xBF,                    // y: -0.5
    0,    0,    0x80, 0x3F,                    // z: 1
    0,    0,    0,    0x3F,                    // w: 0.5
    2,    7,    0,    0xCD, 0xAB,              // list: how many, then they
    9,    8,                                   // pair
};

std::vector<std::uint8_t> bytes_of(const Everything& x) {
  std::vector<std::uint8_t> bytes(sizeof x);
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer.look_at(x);
  EXPECT_EQ(writer.status(), Status::kOk);
  bytes.resize(static_cast<std::size_t>(writer.position()));
  return bytes;
}

TEST(ArchiveWriter, EveryKind_BytesOfTheDocument) {
  EXPECT_EQ(bytes_of(example()), kExampleBytes);
}

/// Both have all their numbers, a column after the other.
TEST(ArchiveWriter, Matrix_HasEveryNumber) {
  Eigen::Matrix<double, 6, 2> wide;
  Mat3<double> square;
  for (int i = 0; i < 12; ++i) wide.data()[i] = i + 1;
  for (int i = 0; i < 9; ++i) square.data()[i] = 100 + i;
  std::vector<std::uint8_t> bytes(21 * sizeof(double));
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer(wide, square);
  ASSERT_EQ(writer.status(), Status::kOk);
  ASSERT_EQ(writer.position(), static_cast<int>(bytes.size()));
  Eigen::Matrix<double, 6, 2> wide_again = Eigen::Matrix<double, 6, 2>::Zero();
  Mat3<double> square_again = Mat3<double>::Zero();
  ArchiveReader reader(bytes.data(), writer.position());
  reader(wide_again, square_again);
  EXPECT_TRUE(reader.is_done(writer.position()));
  EXPECT_EQ(wide_again, wide);
  EXPECT_EQ(square_again, square);
  double second = 0;  // below the first
  std::memcpy(&second, bytes.data() + sizeof second, sizeof second);
  EXPECT_EQ(second, wide(1, 0));
}

template <int kRoom>
std::vector<std::uint8_t> bytes_of_two_places() {
  FixedList<std::uint8_t, kRoom> list;
  list.push(5);
  list.push(6);
  std::vector<std::uint8_t> bytes(8);
  ArchiveWriter writer(bytes.data(), 8);
  writer.look_at(list);
  EXPECT_EQ(writer.status(), Status::kOk);
  bytes.resize(static_cast<std::size_t>(writer.position()));
  return bytes;
}

TEST(ArchiveWriter, CountOfPlaces_IsAByteUpTo255) {
  EXPECT_EQ(bytes_of_two_places<255>(), (std::vector<std::uint8_t>{2, 5, 6}));
  EXPECT_EQ(bytes_of_two_places<256>(), (std::vector<std::uint8_t>{2, 0, 0, 0, 5, 6}));
}

TEST(ArchiveReader, BytesOfTheDocument_GiveEveryMember) {
  Everything x;
  const int size = static_cast<int>(kExampleBytes.size());
  ArchiveReader reader(kExampleBytes.data(), size);
  reader(x);
  EXPECT_TRUE(reader.is_done(size));
  EXPECT_EQ(x.number, -1000000);
  EXPECT_EQ(x.large, 0x0102030405060708U);
  EXPECT_EQ(x.turn.y(), -0.5F);
  EXPECT_EQ(bytes_of(x), kExampleBytes);
}

TEST(ArchiveReader, OneByteShort_IsRefusedAndNeverReadBeyond) {
  for (std::size_t size = 0; size < kExampleBytes.size(); ++size) {
    const std::vector<std::uint8_t> part(kExampleBytes.begin(),
                                         kExampleBytes.begin() + static_cast<std::ptrdiff_t>(size));
    Everything x;
    ArchiveReader reader(part.data(), static_cast<int>(size));
    reader(x);
    EXPECT_EQ(reader.status(), Status::kInvalidArgument) << size;
  }
}

TEST(ArchiveReader, OutOfRange_IsRefusedAndTheMemberStays) {
  struct Case {
    std::size_t at;
    std::uint8_t value;
  };
  for (const Case& wrong : {Case{0, 2}, Case{1, 3}, Case{57, 4}}) {  // flag, colour, list
    std::vector<std::uint8_t> bytes = kExampleBytes;
    bytes[wrong.at] = wrong.value;
    Everything x;
    ArchiveReader reader(bytes.data(), static_cast<int>(bytes.size()));
    reader(x);
    EXPECT_EQ(reader.status(), Status::kInvalidArgument) << wrong.at;
    EXPECT_LE(x.list.size(), 3);
    EXPECT_LE(x.colour, Colour::kBlue);
  }
}

TEST(ArchiveWriter, TooLittleRoom_SaysSoAndWritesNothingBeyond) {
  constexpr std::uint8_t kUntouched = 0x5A;
  for (std::size_t room = 0; room < kExampleBytes.size(); ++room) {
    std::vector<std::uint8_t> bytes(room + 8, kUntouched);
    ArchiveWriter writer(bytes.data(), static_cast<int>(room));
    writer.look_at(example());
    EXPECT_EQ(writer.status(), Status::kPoolFull);
    for (std::size_t i = room; i < bytes.size(); ++i) EXPECT_EQ(bytes[i], kUntouched);
  }
}

TEST(ArchiveWriter, OutOfRange_IsRefused) {
  Everything x = example();
  x.colour = static_cast<Colour>(3);
  std::array<std::uint8_t, 128> bytes{};
  ArchiveWriter writer(bytes.data(), 128);
  writer.look_at(x);
  EXPECT_EQ(writer.status(), Status::kInvalidArgument);
}

/// The published values of FNV-1a with 64 bits.
TEST(ArchiveHash, KnownTexts_KnownValues) {
  const auto hash = [](const std::string& text) {
    ArchiveHash sum;
    for (const char c : text) {
      auto byte = static_cast<std::uint8_t>(c);
      sum(byte);
    }
    return sum.value();
  };
  EXPECT_EQ(hash(""), 0xcbf29ce484222325U);
  EXPECT_EQ(hash("a"), 0xaf63dc4c8601ec8cU);
  EXPECT_EQ(hash("foobar"), 0x85944171f73967e8U);
}

TEST(ArchiveHash, Object_IsThatOfItsBytes) {
  ArchiveHash of_bytes;
  for (std::uint8_t byte : kExampleBytes) of_bytes(byte);
  EXPECT_EQ(hash_of(example()), of_bytes.value());
}

TEST(ArchiveHash, NaN_IsOneOfAllNaNs) {
  const auto nan_of = [](std::uint32_t bits) {
    float x = 0;
    std::memcpy(&x, &bits, sizeof x);
    return hash_of(Vec3<float>(x, 0, 0));
  };
  EXPECT_EQ(nan_of(0x7fc00000U), nan_of(0xffc12345U));
  EXPECT_NE(nan_of(0x00000000U), nan_of(0x80000000U)) << "zeros keep their sign";
}

template <class T>
std::uint64_t fingerprint() {
  ArchiveShape shape;
  const T x{};
  shape.look_at(x);
  return shape.fingerprint();
}

TEST(ArchiveShape, Types_DifferInWhatTheyHaveRoomFor) {
  const std::vector<std::uint64_t> prints = {
      fingerprint<FixedList<float, 3>>(),   fingerprint<FixedList<float, 4>>(),
      fingerprint<FixedList<double, 3>>(),  fingerprint<FixedList<Vec3<float>, 3>>(),
      fingerprint<Pool<float, 3>>(),        fingerprint<Pool<float, 4>>(),
      fingerprint<std::array<float, 3>>(),  fingerprint<std::array<float, 4>>(),
      fingerprint<std::array<Colour, 3>>(), fingerprint<std::array<bool, 3>>()};
  for (std::size_t i = 0; i < prints.size(); ++i) {
    for (std::size_t k = 0; k < i; ++k) EXPECT_NE(prints[i], prints[k]) << i << " " << k;
  }
}

TEST(ArchiveShape, Objects_OfOneTypeAreAlike) {
  ArchiveShape empty;
  ArchiveShape full;
  empty.look_at(Everything{});
  full.look_at(example());
  EXPECT_EQ(empty.fingerprint(), full.fingerprint());
  EXPECT_EQ(hash_of(example()), hash_of(example())) << "looking changes nothing";
}

using Names = Pool<std::uint32_t, 40>;

std::vector<std::uint8_t> bytes_of(const Names& pool) {
  std::vector<std::uint8_t> bytes(sizeof pool);
  ArchiveWriter writer(bytes.data(), static_cast<int>(bytes.size()));
  writer.look_at(pool);
  EXPECT_EQ(writer.status(), Status::kOk);
  bytes.resize(static_cast<std::size_t>(writer.position()));
  return bytes;
}

/// Twenty made, every third one gone, two made again.
void fill(Names& pool, std::vector<Handle<std::uint32_t>>& handles) {
  for (std::uint32_t i = 0; i < 20; ++i) handles.push_back(pool.make(i * i).value);
  for (std::size_t i = 0; i < 20; i += 3) EXPECT_EQ(pool.remove(handles[i]), Status::kOk);
  for (std::uint32_t i = 0; i < 2; ++i) handles.push_back(pool.make(1000 + i).value);
}

TEST(PoolArchive, Restored_KnowsTheSameHandlesAndGoesOnAlike) {
  Names pool(7);
  std::vector<Handle<std::uint32_t>> handles;
  fill(pool, handles);
  const std::vector<std::uint8_t> bytes = bytes_of(pool);
  Names restored;
  ArchiveReader reader(bytes.data(), static_cast<int>(bytes.size()));
  reader(restored);
  ASSERT_TRUE(reader.is_done(static_cast<int>(bytes.size())));
  for (const auto& handle : handles) {
    const std::uint32_t* const was = pool.get(handle);
    const std::uint32_t* const is = restored.get(handle);
    ASSERT_EQ(was == nullptr, is == nullptr);
    EXPECT_TRUE(was == nullptr || *was == *is);
  }
  EXPECT_EQ(pool.size(), restored.size());
  EXPECT_EQ(pool.make(5U).value, restored.make(5U).value);
}

/// Whatever book-keeping is read, the pool's promises hold.
TEST(PoolArchive, DamagedBookkeeping_IsRefusedOrHarmless) {
  Names pool;
  std::vector<Handle<std::uint32_t>> handles;
  fill(pool, handles);
  const std::vector<std::uint8_t> good = bytes_of(pool);
  int refused = 0;
  for (std::size_t i = 0; i < 8 * good.size(); ++i) {
    std::vector<std::uint8_t> bytes = good;
    bytes[i / 8] = static_cast<std::uint8_t>(bytes[i / 8] ^ (1U << (i % 8)));
    Names restored;
    ArchiveReader reader(bytes.data(), static_cast<int>(bytes.size()));
    reader(restored);
    refused += reader.is_done(static_cast<int>(bytes.size())) ? 0 : 1;
    int seen = 0;
    for (const std::uint32_t& name : restored) {
      seen += name < 0xFFFFFFFFU ? 1 : 1;
    }
    EXPECT_EQ(seen, restored.size());
    EXPECT_LE(restored.size(), restored.usable_capacity());
    while (restored.size() < restored.usable_capacity()) ASSERT_TRUE(restored.make(1U).ok());
  }
  EXPECT_GE(refused, 64) << "a bit of the bitmap changes how many objects follow";
}

}  // namespace
}  // namespace batuta
