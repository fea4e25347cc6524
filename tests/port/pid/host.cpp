// SPDX-License-Identifier: MIT

#include "host.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace batuta::pid::test {
namespace {

void put_bits(Bytes& bytes, int at, int bits, std::int64_t value) {
  for (int i = 0; i < bits; ++i) {
    const auto bit = static_cast<std::size_t>(at + i);
    if (((value >> i) & 1) != 0) {
      bytes[bit / 8] = static_cast<std::uint8_t>(bytes[bit / 8] | (1U << (bit % 8)));
    }
  }
}

std::int64_t get_bits(const Bytes& bytes, int at, const ParsedField& field) {
  std::int64_t value = 0;
  for (int i = 0; i < field.bits; ++i) {
    const auto bit = static_cast<std::size_t>(at + i);
    value |= std::int64_t{(bytes[bit / 8] >> (bit % 8)) & 1} << i;
  }
  const std::int64_t half = std::int64_t{1} << (field.bits - 1);
  return field.low < 0 && value >= half ? value - 2 * half : value;
}

std::int64_t value_of(const Values& values, UsageCode usage, const ParsedField& field) {
  const auto named = values.find(usage);
  if (named != values.end()) return named->second;
  return std::max<std::int64_t>(field.low, 0);
}

/// The usages under which a field's values are known: an array by its collection's.
std::vector<UsageCode> names_of(const Descriptor& descriptor, const ParsedField& field) {
  if (field.variable) return field.usages;
  return {descriptor.collections[static_cast<std::size_t>(field.collection)].usage};
}

}  // namespace

int Host::report(char way, UsageCode collection) const {
  for (const ParsedField& field : descriptor_.fields) {
    if (field.way != way) continue;
    for (int c = field.collection; c >= 0;) {
      const ParsedCollection& around = descriptor_.collections[static_cast<std::size_t>(c)];
      if (around.usage == collection && around.type == 2) return field.report;
      c = around.parent;
    }
  }
  throw std::runtime_error("there is no report of this usage");
}

Bytes Host::pack(char way, int report, const Values& values) const {
  Bytes bytes(static_cast<std::size_t>(descriptor_.bits_of(way, report) / 8), 0);
  std::size_t used = 0;
  for (const ParsedField& field : descriptor_.fields) {
    if (field.way != way || field.report != report || field.constant) continue;
    int at = field.at_bit;
    for (const UsageCode name : names_of(descriptor_, field)) {
      put_bits(bytes, at, field.bits, value_of(values, name, field));
      used += values.count(name);
      at += field.bits;
    }
  }
  if (used != values.size()) throw std::runtime_error("the report has no such field");
  return bytes;
}

Values Host::unpack(char way, int report, const Bytes& bytes) const {
  if (static_cast<int>(bytes.size()) * 8 != descriptor_.bits_of(way, report)) {
    throw std::runtime_error("not the length of this report");
  }
  Values values;
  for (const ParsedField& field : descriptor_.fields) {
    if (field.way != way || field.report != report || field.constant) continue;
    int at = field.at_bit;
    for (const UsageCode name : names_of(descriptor_, field)) {
      values[name] = get_bits(bytes, at, field);
      at += field.bits;
    }
  }
  return values;
}

Session::Session()
    : host(Device<kBlocks>::report_descriptor().data(),
           Device<kBlocks>::report_descriptor().size()) {
  force();  // the clock begins
}

Status Session::send(UsageCode collection, const Values& values) {
  const int report = host.report('o', collection);
  const Bytes bytes = host.pack('o', report, values);
  return device.receive(ReportType::kOutput, static_cast<std::uint8_t>(report), bytes.data(),
                        static_cast<int>(bytes.size()));
}

Status Session::create(EffectType type) {
  const int report = host.report('f', pid_usage(0xAB));
  const Bytes bytes = host.pack('f', report, {{pid_usage(0x25), static_cast<std::int64_t>(type)}});
  return device.receive(ReportType::kFeature, static_cast<std::uint8_t>(report), bytes.data(),
                        static_cast<int>(bytes.size()));
}

Values Session::get(UsageCode collection) const {
  const int report = host.report('f', collection);
  Bytes bytes(64);
  const int size = device.answer(static_cast<std::uint8_t>(report), bytes.data(), 64);
  bytes.resize(static_cast<std::size_t>(size));
  return host.unpack('f', report, bytes);
}

std::int64_t Session::made(EffectType type) {
  EXPECT_EQ(create(type), Status::kOk);
  const Values load = get(pid_usage(0x89));
  EXPECT_EQ(load.at(pid_usage(0x8B)), 1) << "success";
  const std::int64_t block = load.at(pid_usage(0x22));
  EXPECT_EQ(set_effect(block, {{pid_usage(0x25), static_cast<std::int64_t>(type)}}), Status::kOk);
  return block;
}

/// An effect without end, from the north, with full gain, but for what is changed.
Status Session::set_effect(std::int64_t block, const Values& changed) {
  Values values = {{pid_usage(0x22), block}, {pid_usage(0x52), 255}, {pid_usage(0x56), 1}};
  for (const auto& [usage, value] : changed) values[usage] = value;
  return send(pid_usage(0x21), values);
}

Status Session::start(std::int64_t block, int loops) {
  return send(pid_usage(0x77),
              {{pid_usage(0x22), block}, {pid_usage(0x78), 1}, {pid_usage(0x7C), loops}});
}

Status Session::stop(std::int64_t block) {
  return send(pid_usage(0x77), {{pid_usage(0x22), block}, {pid_usage(0x78), 3}});
}

Status Session::condition(std::int64_t block, int axis, const Values& values) {
  Values all = {{pid_usage(0x22), block},
                {pid_usage(0x23), axis},
                {pid_usage(0x63), 10000},
                {pid_usage(0x64), 10000}};
  for (const auto& [usage, value] : values) all[usage] = value;
  return send(pid_usage(0x5F), all);
}

Vec2<float> Session::force(const Stick& stick, std::uint32_t step_us) {
  now += step_us;
  return device.force(stick, now);
}

}  // namespace batuta::pid::test
