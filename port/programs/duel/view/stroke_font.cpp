// SPDX-License-Identifier: MIT

#include "programs/duel/view/stroke_font.hpp"

#include <algorithm>
#include <array>
#include <cctype>

#include "programs/duel/utf8.hpp"

namespace batuta::host {
namespace {

/// On a grid of 5 columns and 7 rows from below: each pair of digits is a column and a row, and a
/// blank lifts the pen.
struct Letter {
  char sign;
  std::string_view pen;
};
constexpr std::array<Letter, 58> kLetters = {{
    {' ', ""},
    {'A', "002640 1333"},
    {'B', "00063645443303 3342413000"},
    {'C', "4536160501103041"},
    {'D', "00062644422000"},
    {'E', "46060040 0333"},
    {'F', "460600 0333"},
    {'G', "45361605011030414323"},
    {'H', "0006 4046 0343"},
    {'I', "1030 1636 2026"},
    {'J', "0110304146"},
    {'K', "0006 4603 0340"},
    {'L', "060040"},
    {'M', "0006234640"},
    {'N', "00064046"},
    {'O', "1030414536160501 0110"},
    {'P', "00063645443303"},
    {'Q', "1030414536160501 0110 2240"},
    {'R', "00063645443303 2340"},
    {'S', "011030414233130405163645"},
    {'T', "0646 2026"},
    {'U', "060110304146"},
    {'V', "062046"},
    {'W', "0610243046"},
    {'X', "0046 0640"},
    {'Y', "0623 4623 2320"},
    {'Z', "06460040"},
    {'0', "1030414536160501 0110 1135"},
    {'1', "152620 1030"},
    {'2', "051636454400 0040"},
    {'3', "05163645443313 334241301001"},
    {'4', "30360242"},
    {'5', "460603334241301001"},
    {'6', "4536160501103041423303"},
    {'7', "064610"},
    {'8', "13040516364544331302011030414233"},
    {'9', "0110304145361605041343"},
    {'.', "2020"},
    {',', "2110"},
    {':', "2121 2424"},
    {';', "2110 2424"},
    {'-', "1333"},
    {'+', "0343 2521"},
    {'/', "0046"},
    {'(', "36252130"},
    {')', "16252110"},
    {'[', "36262030"},
    {']', "16262010"},
    {'%', "0046 0506161505 3031414030"},
    {'\'', "2624"},
    {'"', "1614 3634"},
    {'_', "0040"},
    {'=', "0242 0444"},
    {'?', "05163645442322 2020"},
    {'!', "2622 2020"},
    {'<', "450341"},
    {'>', "054301"},
    {'*', "0145 0541"},
}};
constexpr std::string_view kBox = "0006464000";
constexpr double kRows = 6;
constexpr double kCapital = 0.7;  // of the size
constexpr double kAdvance = 5.6;  // columns

double unit_of(double size) {
  return kCapital * size / kRows;
}

std::string_view pen_of(char sign) {
  const char capital = static_cast<char>(std::toupper(static_cast<unsigned char>(sign)));
  for (const Letter& letter : kLetters) {
    if (letter.sign == capital) return letter.pen;
  }
  return kBox;
}

/// Letters of UTF-8, bytes that are none counted one by one.
template <class Call>
void for_each_letter(std::string_view words, const Call& call) {
  while (!words.empty()) {  // Bound: the bytes of the text
    const std::size_t length = std::max<std::size_t>(1, utf8_length(words));
    call(length == 1 ? words.front() : '\0');
    words.remove_prefix(length);
  }
}

void write_letter(std::string_view pen, Pixel at, double unit, std::vector<PenStroke>& strokes) {
  const auto point = [&](std::size_t i) {
    return Pixel{at.x + unit * (pen[i] - '0'), at.y - unit * (pen[i + 1] - '0')};
  };
  for (std::size_t i = 0; i + 3 < pen.size(); i += 2) {  // Bound: the letter's points
    if (pen[i + 2] == ' ') {
      i += 1;  // with the step of the loop: to the first point of the next line
      continue;
    }
    strokes.push_back({point(i), point(i + 2)});
  }
}

}  // namespace

double text_width(std::string_view words, double size) {
  int letters = 0;
  for_each_letter(words, [&](char) { ++letters; });
  const double gap = kAdvance - 4;
  return letters == 0 ? 0 : unit_of(size) * (letters * kAdvance - gap);
}

void write_strokes(std::string_view words, Pixel at, double size, std::vector<PenStroke>& strokes) {
  strokes.clear();
  for_each_letter(words, [&](char sign) {
    write_letter(pen_of(sign), at, unit_of(size), strokes);
    at.x += kAdvance * unit_of(size);
  });
}

}  // namespace batuta::host
