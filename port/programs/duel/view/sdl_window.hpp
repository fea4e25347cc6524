// SPDX-License-Identifier: MIT
#pragma once
// A window of SDL with a renderer, for as long as this lives. All of it belongs to one thread.

#include <SDL.h>

#include <string>

namespace batuta::host {

class SdlWindow {
 public:
  /// @param width, height  of what is drawn; the window may be smaller, and what is drawn then is
  explicit SdlWindow(const char* title, int width, int height);
  SdlWindow(const SdlWindow&) = delete;
  SdlWindow& operator=(const SdlWindow&) = delete;
  ~SdlWindow();

  /// Empty: it is there.
  const std::string& problem() const { return problem_; }
  /// @pre problem() is empty
  SDL_Renderer* renderer() const { return renderer_; }

 private:
  bool video_ = false;
  SDL_Window* window_ = nullptr;
  SDL_Renderer* renderer_ = nullptr;
  std::string problem_;
};

}  // namespace batuta::host
