// SPDX-License-Identifier: MIT
// port/shared/link/link.md against the code: its tables, its examples and its times. What the
// document says is read from it, so that the two cannot part.

#include <gtest/gtest.h>

#include <cstdio>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <string>

#include "wire.hpp"

namespace batuta::link::test {
namespace {

using Cells = std::vector<std::string>;

std::vector<std::string> lines_of_document() {
  std::ifstream file(BATUTA_LINK_DOCUMENT);
  std::vector<std::string> lines;
  for (std::string line; std::getline(file, line);) lines.push_back(line);
  return lines;
}

std::string trimmed(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" `");
  if (begin == std::string::npos) return {};
  return text.substr(begin, text.find_last_not_of(" `") - begin + 1);
}

/// The cells of a table's row; none for a line that is no row.
Cells cells(const std::string& line) {
  Cells all;
  std::stringstream rest(line);
  std::string cell;
  if (!std::getline(rest, cell, '|') || !cell.empty()) return all;
  while (std::getline(rest, cell, '|')) all.push_back(trimmed(cell));
  return all;
}

bool is_number(const std::string& text) {
  return !text.empty() && text.find_first_not_of("0123456789") == std::string::npos;
}

/// The rows of all tables under a heading that begin with a number, an offset.
std::vector<Cells> rows_under(const std::string& heading) {
  std::vector<Cells> rows;
  bool inside = false;
  for (const std::string& line : lines_of_document()) {
    if (line.rfind('#', 0) == 0) inside = line.rfind(heading, 0) == 0;
    const Cells row = cells(line);
    if (inside && row.size() >= 4 && is_number(row[0])) rows.push_back(row);
  }
  return rows;
}

/// Widths of what a type stands for: "u32", "f32[3]", "sample".
std::vector<int> widths(const std::string& type) {
  if (type == "sample") return std::vector<int>(7, 4);
  const std::size_t bracket = type.find('[');
  const int count = bracket == std::string::npos ? 1 : std::stoi(type.substr(bracket + 1));
  return std::vector<int>(static_cast<std::size_t>(count), std::stoi(type.substr(1)) / 8);
}

struct Named {
  std::string heading;
  AnyMessage message;  ///< the longest of its type
};

std::vector<Named> messages() {
  Step step;
  step.has_left = true;
  step.has_right = true;
  return {{"Hello", Hello{}},           {"Step", step},        {"StickSample", StickSample{}},
          {"Welcome", Welcome{}},       {"Pose", Pose{}},      {"Event", Event{}},
          {"Force", Force{}},           {"Touch", Touch{}},    {"StickUsed", StickUsed{}},
          {"StepReport", StepReport{}}, {"Refused", Refused{}}};
}

std::string hex(MessageType type) {
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "0x%02X", static_cast<unsigned>(type));
  return text.data();
}

TEST(Document, TableOfEachMessage_IsItsLayout) {
  for (const Named& named : messages()) {
    const std::string heading = "### " + named.heading + " (" + hex(type_of(named.message)) + ")";
    std::vector<int> documented;
    int offset = 0;
    for (const Cells& row : rows_under(heading)) {
      EXPECT_EQ(std::stoi(row[0]), offset) << heading << ": " << row[3];
      const std::vector<int> some = widths(row[2]);
      int size = 0;
      for (const int width : some) size += width;
      EXPECT_EQ(std::stoi(row[1]), size) << heading << ": " << row[3];
      offset += size;
      documented.insert(documented.end(), some.begin(), some.end());
    }
    std::vector<int> actual;
    for (const Field& field : std::visit([](const auto& m) { return layout(m); }, named.message)) {
      actual.push_back(field.width);
    }
    EXPECT_EQ(documented, actual) << heading;
  }
}

std::string fixed(double value, int digits) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.*f", digits, value);
  return text.data();
}

// | message | payload | on the wire | ms at 115200 | ms at 1 M | us at 4 M |
TEST(Document, TimesOnTheLine_AreTenBitsAByte) {
  std::map<std::string, Cells> rows;
  for (const std::string& line : lines_of_document()) {
    const Cells row = cells(line);
    if (row.size() == 6 && is_number(row[1]) && is_number(row[2])) rows[row[0]] = row;
  }
  EXPECT_EQ(rows.size(), messages().size());
  for (const Named& named : messages()) {
    const Bytes payload =
        std::visit([](const auto& m) { return expected_payload(m); }, named.message);
    const std::size_t wire = wire_of(named.message, 1).size();
    const double kilobits = static_cast<double>(wire) * 10 / 1000;
    const Cells expected = {named.heading,        std::to_string(payload.size()),
                            std::to_string(wire), fixed(kilobits / 0.1152, 2),
                            fixed(kilobits, 2),   fixed(kilobits * 250, 1)};
    EXPECT_EQ(rows[named.heading], expected);
  }
}

/// Whether the frame that comes after so many missed ones is accepted.
bool is_accepted_after(int missed) {
  DeviceDecoder decoder;
  receive(decoder, wire_of(Step{}, 0));
  return !receive(decoder, wire_of(Step{}, static_cast<std::uint16_t>(missed + 1))).empty();
}

// | missed in a row | what comes then | `lost` grows by |
TEST(Document, RangesOfASilence_AreTheDecoders) {
  int next = 0;
  for (const std::string& line : lines_of_document()) {
    const Cells row = cells(line);
    int first = 0;
    int last = 0;
    if (row.size() != 3 || std::sscanf(row[0].c_str(), "%d ... %d", &first, &last) != 2) continue;
    EXPECT_EQ(first, next) << line;
    const bool accepted = row[1].rfind("is accepted", 0) == 0;
    EXPECT_NE(accepted, row[1].rfind("is rejected", 0) == 0) << line;
    EXPECT_EQ(is_accepted_after(first), accepted) << line;
    EXPECT_EQ(is_accepted_after(last), accepted) << line;
    next = last + 1;
  }
  EXPECT_EQ(next, 65536) << "the distance is that modulo 65536";
}

/// The bytes of the block below the line that holds `marker`.
Bytes example(const std::string& marker) {
  const std::vector<std::string> lines = lines_of_document();
  for (std::size_t i = 0; i + 2 < lines.size(); ++i) {
    if (lines[i] != marker) continue;
    std::stringstream text(lines[i + 2]);
    Bytes bytes;
    for (unsigned byte = 0; text >> std::hex >> byte;) {
      bytes.push_back(static_cast<std::uint8_t>(byte));
    }
    return bytes;
  }
  return {};
}

Step step_of_the_document() {
  Step step;
  step.step = 3;
  step.has_left = true;
  step.left.time = 2000;
  step.left.x = 0.5F;
  step.left.y = -0.25F;
  step.left.buttons = 1;
  step.left.sequence = 2;
  return step;
}

TEST(Document, Example_IsWhatTheEncoderWrites) {
  Payload payload;
  ASSERT_TRUE(encode(step_of_the_document(), payload));
  std::array<std::uint8_t, kMaxWireFrame> wire{};
  const int count = encode_frame({MessageType::kStep, 7, payload.bytes.data(), payload.size},
                                 wire.data(), kMaxWireFrame);
  EXPECT_EQ(example("on the wire:"), Bytes(wire.begin(), wire.begin() + count));
  EXPECT_EQ(example("before stuffing:"),
            raw_frame(kProtocolVersion, static_cast<std::uint8_t>(MessageType::kStep), 7,
                      expected_payload(step_of_the_document())));
}

TEST(Document, Example_IsReadBack) {
  DeviceDecoder decoder;
  const Bytes wire = example("on the wire:");
  ASSERT_FALSE(wire.empty());
  EXPECT_EQ(receive(decoder, wire), std::vector<Received>{received(step_of_the_document(), 7)});
}

TEST(Document, Limits_AreTheConstants) {
  std::ifstream file(BATUTA_LINK_DOCUMENT);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  for (const std::string& sentence :
       {"version byte: " + std::to_string(kProtocolVersion),
        "longest payload: " + std::to_string(kMaxPayload) + " bytes",
        "longest frame: " + std::to_string(kMaxWireFrame) + " bytes"}) {
    EXPECT_NE(text.find(sentence), std::string::npos) << sentence;
  }
}

}  // namespace
}  // namespace batuta::link::test
