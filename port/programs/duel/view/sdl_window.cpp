// SPDX-License-Identifier: MIT

#include "programs/duel/view/sdl_window.hpp"

#include <algorithm>
#include <string_view>

namespace batuta::host {
namespace {

/// As large as it is drawn, or as the screen has room for.
SDL_Point size_on_screen(int width, int height) {
  constexpr float kTitleBar = 40;  // pixels
  SDL_Rect room{};
  if (SDL_GetDisplayUsableBounds(0, &room) != 0) return {width, height};
  const auto share = [](float there, int wanted) { return there / static_cast<float>(wanted); };
  const float scale = std::min({1.0F, share(static_cast<float>(room.w), width),
                                share(static_cast<float>(room.h) - kTitleBar, height)});
  const auto scaled = [&](int length) {
    return std::max(1, static_cast<int>(scale * static_cast<float>(length)));
  };
  return {scaled(width), scaled(height)};
}

/// SDL falls back to a driver that draws for nobody; who wants that names it in SDL_VIDEODRIVER.
bool is_for_nobody() {
  const std::string_view driver = SDL_GetCurrentVideoDriver();
  return SDL_GetHint(SDL_HINT_VIDEODRIVER) == nullptr &&
         (driver == "offscreen" || driver == "dummy");
}

}  // namespace

SdlWindow::SdlWindow(const char* title, int width, int height) {
  SDL_SetHint(SDL_HINT_NO_SIGNAL_HANDLERS, "1");  // the user's interrupt ends the program
  SDL_SetHint(SDL_HINT_VIDEO_ALLOW_SCREENSAVER, "1");
  video_ = SDL_InitSubSystem(SDL_INIT_VIDEO) == 0;
  if (video_ && is_for_nobody()) {
    problem_ = "no display (is DISPLAY or WAYLAND_DISPLAY set?)";
    return;
  }
  if (video_) {
    const SDL_Point size = size_on_screen(width, height);
    window_ = SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.x,
                               size.y, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI);
  }
  if (window_ != nullptr) renderer_ = SDL_CreateRenderer(window_, -1, 0);
  const bool good = renderer_ != nullptr && SDL_RenderSetLogicalSize(renderer_, width, height) == 0;
  if (!good) problem_ = SDL_GetError();
}

SdlWindow::~SdlWindow() {
  if (renderer_ != nullptr) SDL_DestroyRenderer(renderer_);
  if (window_ != nullptr) SDL_DestroyWindow(window_);
  if (video_) SDL_QuitSubSystem(SDL_INIT_VIDEO);
}

}  // namespace batuta::host
