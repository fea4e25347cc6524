// SPDX-License-Identifier: MIT

#include "programs/duel/svg_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "programs/duel/bout_words.hpp"

namespace batuta::host {
using namespace fencing;
namespace {

constexpr double kWidth = 1060;
constexpr double kHeight = 1130;
constexpr double kMargin = 30;
constexpr double kScale = 250;     // pixels a metre
constexpr double kReach = 2.0;     // of the salle to either side of the middle, m
constexpr double kTallest = 2.0;   // m
constexpr double kBroadest = 0.7;  // of the piste to either side of the middle line, m

struct Palette {
  Colour early;
  Colour late;
  Colour body;
};
constexpr std::array<Palette, 2> kPalettes = {{
    {{176, 208, 240}, {10, 50, 120}, {70, 120, 180}},
    {{250, 210, 160}, {140, 40, 0}, {205, 120, 50}},
}};
constexpr Colour kGrey = {120, 120, 120};
constexpr Colour kFaint = {225, 225, 225};
constexpr Colour kBeat = {20, 130, 60};
constexpr Colour kTouch = {215, 0, 30};

const Palette& palette(Side side) {
  return kPalettes[index_of(side)];
}

/// A ring's area goes with the impulse.
double ring_radius(float impulse) {
  return std::clamp(2.5 + 9 * std::sqrt(static_cast<double>(impulse)), 2.5, 14.0);
}

std::string seconds(double time) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%.2f s", time);
  return text.data();
}

/// 1, 2 or 5 times a power of ten: at most a dozen marks over `span`.
double mark_spacing(double span) {
  double spacing = 0.1;
  for (int i = 0; span / spacing > 12 && i < 20; ++i) spacing *= i % 3 == 1 ? 2.5 : 2;
  return spacing;
}

std::string title_of(const DuelRunner& runner) {
  const std::string result = result_of(runner);
  if (result == "draw") return "No touch in " + seconds(runner.now());
  if (result == "open") return "Broken off after " + seconds(runner.now());
  const Touch<float>& touch = runner.duel().bout().touches[0];
  const std::string where = fencing::name_of(touch.part);
  if (result == "double") return "Double touch after " + seconds(time_of(runner, touch));
  return "Touch by " + result + ": " + where + ", after " + seconds(time_of(runner, touch));
}

}  // namespace

struct SvgPicture::View {
  bool from_above = false;
  Pixel corner;  ///< upper left

  Pixel size() const {
    return {2 * kReach * kScale, (from_above ? 2 * kBroadest : kTallest) * kScale};
  }
  Pixel at(const Vec3<float>& p_W) const {
    // From above, the left fencer's left hand (+y) is up, as it is on a map with the piste drawn
    // from left to right.
    const double down = from_above ? kBroadest - static_cast<double>(p_W.y())
                                   : kTallest - static_cast<double>(p_W.z());
    return {corner.x + (kReach + static_cast<double>(p_W.x())) * kScale, corner.y + down * kScale};
  }
};

void SvgPicture::on_start(const DuelRunner& runner) {
  on_step(runner);
}

void SvgPicture::on_step(const DuelRunner& runner) {
  const auto now = static_cast<float>(runner.now());
  for (const Side side : {Side::kLeft, Side::kRight}) {
    tips_[index_of(side)].add({now, runner.duel().blade_W(side).axis.b});
  }
  for (const auto& event : runner.duel().world().events()) {  // Bound: DuelScene::kMaxEvents
    if (is_beat(event)) add_beat({time_of(runner, event), event.impulse, event.contact.point_W});
  }
}

void SvgPicture::add_beat(const Beat& beat) {
  if (beats_.push(beat)) return;
  ++beats_left_out_;
  int weakest = 0;
  for (int i = 1; i < kMaxBeats; ++i) {  // Bound: kMaxBeats
    if (beats_[i].impulse < beats_[weakest].impulse) weakest = i;
  }
  if (beats_[weakest].impulse < beat.impulse) beats_[weakest] = beat;
}

void SvgPicture::on_end(const DuelRunner& runner) {
  SvgCanvas canvas(out_, kWidth, kHeight);
  draw_title(canvas, runner);
  const View side{false, {kMargin, 96}};
  const View above{true, {kMargin, side.corner.y + side.size().y + 34}};
  draw_view(canvas, runner, side);
  draw_view(canvas, runner, above);
  draw_timeline(canvas, runner);
  draw_legend(canvas);
}

void SvgPicture::draw_title(SvgCanvas& canvas, const DuelRunner& runner) const {
  canvas.text({kMargin, 36}, title_of(runner), 24, "start");
  for (const Side side : {Side::kLeft, Side::kRight}) {
    const double x = side == Side::kLeft ? kMargin : kWidth - kMargin;
    canvas.text({x, 62}, std::string(name_of(side)) + ": " + runner.source(side).description(), 13,
                side == Side::kLeft ? "start" : "end");
  }
}

void SvgPicture::draw_view(SvgCanvas& canvas, const DuelRunner& runner, const View& view) const {
  const Pixel low = {view.corner.x, view.corner.y + view.size().y};
  canvas.rectangle(view.corner, view.size(), {250, 250, 248});
  canvas.text({view.corner.x + 8, view.corner.y - 6},
              view.from_above ? "from above" : "from the side (lines: 1 m)", 13, "start");
  for (int metre = -1; metre <= 1; ++metre) {
    const double x = view.corner.x + (kReach + metre) * kScale;
    canvas.line({x, view.corner.y}, {x, low.y}, {kFaint, 1, 1});
  }
  if (!view.from_above) canvas.line(low, {low.x + view.size().x, low.y}, {kGrey, 2, 1});
  for (const Side side : {Side::kLeft, Side::kRight}) draw_fencer(canvas, runner, view, side);
  for (const Side side : {Side::kLeft, Side::kRight}) draw_trace(canvas, view, side, runner.now());
  draw_beats(canvas, view);
  draw_touches(canvas, runner, view);
}

void SvgPicture::draw_fencer(SvgCanvas& canvas, const DuelRunner& runner, const View& view,
                             Side side) const {
  const auto draw = [&](const Capsule<float>& capsule, const Colour& colour, double least) {
    const double width = std::max(2 * static_cast<double>(capsule.radius) * kScale, least);
    canvas.line(view.at(capsule.axis.a), view.at(capsule.axis.b), {colour, width, 1});
  };
  const Colour pale = mixed(palette(side).body, {255, 255, 255}, 0.72);
  for (const Capsule<float>& part : runner.duel().body_W(side)) draw(part, pale, 0);
  draw(runner.duel().blade_W(side), palette(side).body, 4);
}

/// The trace in pieces of one colour each, so that the picture stays small.
void SvgPicture::draw_trace(SvgCanvas& canvas, const View& view, Side side, double end) const {
  constexpr int kShades = 24;
  const Trace& trace = tips_[index_of(side)];
  const auto shade_at = [&](std::size_t i) {
    const double share = end > 0 ? static_cast<double>(trace[i].time) / end : 0;
    return std::clamp(static_cast<int>(share * kShades), 0, kShades - 1);
  };
  std::vector<Pixel> piece;
  for (std::size_t i = 0; i < trace.size(); ++i) {
    piece.push_back(view.at(trace[i].p_W));
    const bool last = i + 1 == trace.size();
    if (!last && shade_at(i + 1) == shade_at(i)) continue;
    const double share = static_cast<double>(shade_at(i)) / (kShades - 1);
    if (!last) piece.push_back(view.at(trace[i + 1].p_W));
    canvas.polyline(piece, {mixed(palette(side).early, palette(side).late, share), 1.2, 0.9});
    piece.clear();
  }
}

void SvgPicture::draw_beats(SvgCanvas& canvas, const View& view) const {
  for (const Beat& beat : beats_) {
    std::array<char, 64> note{};
    std::snprintf(note.data(), note.size(), "beat at %.3f s, %.3f N s", beat.time,
                  static_cast<double>(beat.impulse));
    canvas.circle(view.at(beat.point_W), ring_radius(beat.impulse), {kBeat, 1.6, 0.8}, note.data());
  }
}

void SvgPicture::draw_touches(SvgCanvas& canvas, const DuelRunner& runner, const View& view) const {
  for (const Touch<float>& touch : runner.duel().bout().touches) {
    const Pixel at = view.at(touch.contact.point_W);
    canvas.star(at, 15, kTouch);
    canvas.text({at.x, at.y - 18}, fencing::name_of(touch.part), 14, "middle");
  }
}

void SvgPicture::draw_timeline(SvgCanvas& canvas, const DuelRunner& runner) const {
  constexpr double kTop = 1010;
  constexpr double kBase = kTop + 50;
  const double span = std::max(runner.now(), 1e-3);
  const auto x_at = [&](double time) { return kMargin + 2 * kReach * kScale * time / span; };
  constexpr int kShades = 100;
  for (int i = 0; i < kShades; ++i) {
    const double x = x_at(span * i / kShades);
    const double width = x_at(span / kShades) - x_at(0) + 0.5;
    const double share = static_cast<double>(i) / (kShades - 1);
    for (const Side side : {Side::kLeft, Side::kRight}) {
      const double y = kBase + (side == Side::kLeft ? 2 : 9);
      canvas.rectangle({x, y}, {width, 6}, mixed(palette(side).early, palette(side).late, share));
    }
  }
  for (const Beat& beat : beats_) {
    const double height = std::min(10 + 60 * static_cast<double>(beat.impulse), 50.0);
    canvas.line({x_at(beat.time), kBase}, {x_at(beat.time), kBase - height}, {kBeat, 2, 0.8});
  }
  for (const Touch<float>& touch : runner.duel().bout().touches) {
    canvas.star({x_at(time_of(runner, touch)), kTop + 30}, 11, kTouch);
  }
  const double spacing = mark_spacing(span);
  for (int i = 0; i * spacing <= span; ++i) {
    std::array<char, 32> mark{};
    std::snprintf(mark.data(), mark.size(), "%g s", i * spacing);
    canvas.text({x_at(i * spacing), kBase + 30}, mark.data(), 12, "middle");
  }
}

void SvgPicture::draw_legend(SvgCanvas& canvas) const {
  constexpr double kLine = kHeight - 14;
  double x = kMargin;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    canvas.line({x, kLine - 5}, {x + 16, kLine - 5}, {palette(side).early, 4, 1});
    canvas.line({x + 22, kLine - 5}, {x + 38, kLine - 5}, {palette(side).late, 4, 1});
    canvas.text({x + 48, kLine}, std::string(name_of(side)) + " tip, early ... late", 13, "start");
    x += 230;
  }
  canvas.circle({x + 8, kLine - 5}, 7, {kBeat, 1.6, 1}, {});
  std::string beats = "beat, larger: harder";
  if (beats_left_out_ > 0) beats += " (the " + std::to_string(kMaxBeats) + " hardest)";
  canvas.text({x + 24, kLine}, beats, 13, "start");
  x += 290;
  canvas.star({x, kLine - 5}, 9, kTouch);
  canvas.text({x + 16, kLine}, "touch", 13, "start");
}

}  // namespace batuta::host
