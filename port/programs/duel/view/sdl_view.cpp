// SPDX-License-Identifier: MIT

#include "programs/duel/view/sdl_view.hpp"

#include <chrono>

#include "programs/duel/view/held_exit.hpp"
#include "programs/duel/view/sdl_canvas.hpp"

namespace batuta::host {
namespace {

constexpr std::chrono::milliseconds kLookForEnd(2);  // how often who waits for the thread looks up

}  // namespace

SdlView::SdlView(const ViewNames& names) : screen_(names), thread_([this] { run(); }) {}

SdlView::~SdlView() {
  ending_ = true;
  while (!left_) std::this_thread::sleep_for(kLookForEnd);  // Bound: a picture
  if (lost_) {
    thread_.detach();  // it sleeps in exit(), for as long as the program lives
  } else {
    thread_.join();
  }
}

void SdlView::run() {
  const HeldExit held([this] { lose_window(); });
  {
    const SdlWindow window("batuta-duel", ViewScreen::kWidth, ViewScreen::kHeight);
    is_open_ = true;
    opened_.set_value(window.problem());
    if (window.problem().empty()) draw_until_end(window.renderer());
  }
  SDL_TLSCleanup();
  left_ = true;
}

void SdlView::draw_until_end(SDL_Renderer* renderer) {
  SdlCanvas canvas(renderer);
  const auto state = std::make_unique<ViewState>();
  const std::uint64_t second = SDL_GetPerformanceFrequency();
  std::uint64_t due = SDL_GetPerformanceCounter();
  while (!ending_) {  // Bound: until the view is destroyed
    if (latest_.take(*state)) screen_.take(*state);
    screen_.draw(canvas, controls());
    SDL_RenderPresent(renderer);
    ++pictures_;
    due += second / kPicturesPerSecond;
    const std::uint64_t now = SDL_GetPerformanceCounter();
    if (due < now) due = now;  // too slow for so many: what was missed is not made up for
    wait_until(due);
  }
}

void SdlView::lose_window() {
  lost_ = true;
  if (!is_open_) opened_.set_value("the display is gone");
  controls().wish(ViewWish::kQuit);
  left_ = true;
}

void SdlView::wait_until(std::uint64_t due) {
  SDL_Event event;
  int left_ms = 1;
  while (left_ms > 0) {  // Bound: the time of a picture, and the keys that were pressed
    const std::uint64_t now = SDL_GetPerformanceCounter();
    const std::uint64_t left = due > now ? due - now : 0;
    left_ms = static_cast<int>(1000 * left / SDL_GetPerformanceFrequency());
    const bool news =
        left_ms > 0 ? SDL_WaitEventTimeout(&event, left_ms) != 0 : SDL_PollEvent(&event) != 0;
    if (!news) continue;
    take(event);
    left_ms = 1;
  }
}

void SdlView::take(const SDL_Event& event) {
  if (event.type == SDL_QUIT) controls().wish(ViewWish::kQuit);
  if (event.type == SDL_KEYDOWN) press(event.key);
}

void SdlView::press(const SDL_KeyboardEvent& key) {
  const SDL_Keycode code = key.keysym.sym;
  if (code == SDLK_PERIOD || code == SDLK_RIGHT) controls().single_step();
  if (key.repeat != 0) return;  // but steps may be held
  switch (code) {
    case SDLK_SPACE:
      return controls().toggle_pause();
    case SDLK_1:
      return controls().slow_down(1);
    case SDLK_2:
      return controls().slow_down(ViewControls::kQuarter);
    case SDLK_3:
      return controls().slow_down(ViewControls::kTwentieth);
    case SDLK_r:
      return controls().wish(ViewWish::kRestart);
    case SDLK_q:
    case SDLK_ESCAPE:
      return controls().wish(ViewWish::kQuit);
    default:
      return;
  }
}

OpenedView open_view(const ViewNames& names) {
  OpenedView opened;
  auto view = std::make_unique<SdlView>(names);
  const std::string problem = view->open();
  if (problem.empty()) {
    opened.view = std::move(view);
  } else {
    opened.error = "--view: there is no window: " + problem + "; --svg draws the bout into a file";
  }
  return opened;
}

}  // namespace batuta::host
