// SPDX-License-Identifier: MIT
// What the Linux driver hid-pidff asks of a device, as read from its source, old (to 6.14) and new:
// which reports it must find, by which usage and nesting; which fields in them; and what its
// arithmetic makes of the ranges.

#include <gtest/gtest.h>

#include <limits>

#include "host.hpp"

namespace batuta::pid::test {
namespace {

class Driver {
 public:
  Driver() : d_(parse(kReportDescriptor<16>.data(), kReportDescriptor<16>.size())) {}

  /// Fields of the report whose first field lies in a collection of this usage, or directly in the
  /// first collection inside of one.
  std::vector<ParsedField> report(unsigned usage) const {
    for (const char way : {'o', 'f'}) {
      for (const int id : d_.reports(way)) {
        const std::vector<ParsedField> fields = fields_of(way, id);
        const int inner = fields.front().collection;
        const bool is = collection(inner).usage == pid_usage(usage);
        const bool around = inner > 0 && collection(inner - 1).type == 2 &&
                            collection(inner - 1).usage == pid_usage(usage);
        if (is || around) return fields;
      }
    }
    return {};
  }
  /// A value field: one usage for each value.
  bool has_value(unsigned report_usage, unsigned usage) const {
    for (const ParsedField& f : report(report_usage)) {
      if (f.usages.size() != static_cast<std::size_t>(f.count)) continue;
      for (const UsageCode name : f.usages) {
        if (name == pid_usage(usage)) return true;
      }
    }
    return false;
  }
  /// The field directly in a collection of this usage; with no bits if there is none.
  ParsedField special(unsigned report_usage, unsigned usage) const {
    for (const ParsedField& f : report(report_usage)) {
      if (collection(f.collection).usage == pid_usage(usage)) return f;
    }
    return {};
  }
  ParsedField value(unsigned report_usage, unsigned usage) const {
    for (const ParsedField& f : report(report_usage)) {
      for (const UsageCode name : f.usages) {
        if (name == pid_usage(usage) || name == usage) return f;
      }
    }
    return {};
  }

 private:
  const ParsedCollection& collection(int i) const {
    return d_.collections[static_cast<std::size_t>(i)];
  }
  std::vector<ParsedField> fields_of(char way, int id) const {
    std::vector<ParsedField> fields;
    for (const ParsedField& f : d_.fields) {
      if (f.way == way && f.report == id && !f.constant) fields.push_back(f);
    }
    return fields;
  }
  Descriptor d_;
};

TEST(PidDriver, AllReports_AreFound) {
  const Driver driver;
  for (const unsigned usage :
       {0x21, 0x77, 0x7D, 0x7F, 0x89, 0x90, 0x96, 0xAB, 0x5A, 0x5F, 0x6E, 0x73, 0x74}) {
    EXPECT_FALSE(driver.report(usage).empty()) << std::hex << usage;
  }
}

TEST(PidDriver, AllValues_AreFound) {
  const Driver driver;
  const std::map<unsigned, std::vector<unsigned>> wanted = {
      {0x21, {0x22, 0x50, 0x52, 0x53, 0x54, 0x56, 0xA7}},
      {0x5A, {0x22, 0x5B, 0x5C, 0x5D, 0x5E}},
      {0x5F, {0x22, 0x23, 0x60, 0x61, 0x62, 0x63, 0x64, 0x65}},
      {0x6E, {0x22, 0x70, 0x6F, 0x71, 0x72}},
      {0x73, {0x22, 0x70}},
      {0x74, {0x22, 0x75, 0x76}},
      {0x89, {0x22, 0xAC}},
      {0x77, {0x22, 0x7C}},
      {0x90, {0x22}},
      {0x7D, {0x7E}},
      {0x7F, {0x80, 0x83, 0xA9}}};
  for (const auto& [report, usages] : wanted) {
    for (const unsigned usage : usages) {
      EXPECT_TRUE(driver.has_value(report, usage)) << std::hex << report << ' ' << usage;
    }
  }
}

TEST(PidDriver, Arrays_CountFromOneAndNameTheirChoices) {
  const Driver driver;
  const std::vector<UsageCode> types = {0x0F0026, 0x0F0027, 0x0F0030, 0x0F0031, 0x0F0032, 0x0F0033,
                                        0x0F0034, 0x0F0040, 0x0F0041, 0x0F0042, 0x0F0043};
  const std::vector<UsageCode> controls = {0x0F0097, 0x0F0098, 0x0F0099,
                                           0x0F009A, 0x0F009B, 0x0F009C};
  const struct {
    unsigned report;
    unsigned usage;
    std::vector<UsageCode> choices;
  } arrays[] = {{0xAB, 0x25, types},
                {0x21, 0x25, types},
                {0x96, 0x96, controls},
                {0x89, 0x8B, {0x0F008C, 0x0F008D, 0x0F008E}},
                {0x77, 0x78, {0x0F0079, 0x0F007A, 0x0F007B}}};
  for (const auto& [report, usage, choices] : arrays) {
    const ParsedField f = driver.special(report, usage);
    EXPECT_EQ(f.low, 1) << std::hex << usage;
    EXPECT_EQ(f.high, static_cast<std::int64_t>(choices.size())) << std::hex << usage;
    EXPECT_EQ(f.usages, choices) << std::hex << usage;
    EXPECT_FALSE(f.variable) << std::hex << usage;
    EXPECT_EQ(f.count, 1) << std::hex << usage;
  }
}

TEST(PidDriver, DirectionAndAxes_AreTwo) {
  const Driver driver;
  EXPECT_EQ(driver.special(0x21, 0x57).count, 2);
  EXPECT_EQ(driver.special(0x21, 0x55).usages, (std::vector<UsageCode>{0x010030, 0x010031}));
}

/// The driver's scaling of an unsigned number, in its 32 bits: @returns nothing where they
/// overflow.
std::optional<int> rescaled(std::int64_t value, const ParsedField& f) {
  const std::int64_t product = value * (f.high - f.low);
  if (product > std::numeric_limits<std::int32_t>::max()) return std::nullopt;
  return static_cast<int>(product / 0xFFFF + f.low);
}

TEST(PidDriver, Scaling_NeverOverflowsItsInteger) {
  const Driver driver;
  for (const auto& [report, usage] :
       {std::pair(0x21U, 0x0A0001U), std::pair(0x6EU, 0x71U), std::pair(0x5FU, 0x63U),
        std::pair(0x5FU, 0x65U), std::pair(0x7DU, 0x7EU)}) {
    const ParsedField f = driver.value(report, usage);
    ASSERT_GT(f.bits, 0) << std::hex << usage;
    const std::optional<int> most = rescaled(0xFFFF, f);
    ASSERT_TRUE(most.has_value()) << std::hex << usage;
    EXPECT_EQ(*most, f.high);
  }
}

TEST(PidDriver, FourWinds_AreHitExactly) {
  const ParsedField f = Driver().value(0x21, 0x0A0001);
  for (int quarter = 0; quarter < 4; ++quarter) {
    EXPECT_EQ(rescaled(quarter * 0x4000, f), quarter * f.high / 4);
  }
}

// The pool must hold two effects or more, be managed by the device, and the first block must not be
// the second number, from which the driver concludes that the first is a built-in spring.
TEST(PidDriver, Probe_IsAnsweredAsItWants) {
  Session session;
  const Values pool = session.get(pid_usage(0x7F));
  EXPECT_GE(pool.at(pid_usage(0x83)), 2);
  EXPECT_EQ(pool.at(pid_usage(0xA9)), 1);
  EXPECT_EQ(session.control(4), Status::kOk);
  EXPECT_EQ(session.control(4), Status::kOk);
  EXPECT_EQ(session.control(1), Status::kOk);
  EXPECT_EQ(session.send(pid_usage(0x7D), {{pid_usage(0x7E), 255}}), Status::kOk);
  ASSERT_EQ(session.create(EffectType::kConstant), Status::kOk);
  const Values load = session.get(pid_usage(0x89));
  EXPECT_EQ(load.at(pid_usage(0x8B)), 1);
  EXPECT_EQ(load.at(pid_usage(0x22)), 1);
  EXPECT_EQ(session.send(pid_usage(0x90), {{pid_usage(0x22), 1}}), Status::kOk);
  EXPECT_EQ(session.device.counters().refused(), 0U);
}

// Before Linux 6.15 the type sent with a change is that of the effect created last.
TEST(PidDriver, ChangeWithAnotherType_KeepsTheEffect) {
  Session session;
  const std::int64_t constant = session.made(EffectType::kConstant);
  session.made(EffectType::kSine);
  EXPECT_EQ(session.send(pid_usage(0x73), {{pid_usage(0x22), constant}, {pid_usage(0x70), 5000}}),
            Status::kOk);
  EXPECT_EQ(session.set_effect(constant, {{pid_usage(0x25), 4}, {0x0A0001, degrees(90)}}),
            Status::kOk);
  EXPECT_EQ(session.start(constant), Status::kOk);
  EXPECT_EQ(session.force(), Vec2<float>(-0.5F, 0.0F));
}

}  // namespace
}  // namespace batuta::pid::test
