#include "app/progress.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdio>

namespace volute::app {

namespace {

constexpr auto silent_for = std::chrono::seconds(1);
constexpr auto redraw_after = std::chrono::milliseconds(100);
constexpr int bar_width = 30;

}  // namespace

Progress::Progress(bool quiet)
    : quiet_(quiet),
      terminal_(isatty(STDERR_FILENO) != 0),
      started_(std::chrono::steady_clock::now()),
      last_drawn_(started_) {}

Progress::~Progress() { clear(); }

void Progress::report(std::string_view stage, double done) {
  if (quiet_) return;
  const auto now = std::chrono::steady_clock::now();
  const bool new_stage = stage != stage_;
  if (new_stage) stage_ = stage;
  if (now - started_ < silent_for) return;
  if (!terminal_) {
    if (new_stage) std::fprintf(stderr, "volute: %s\n", stage_.c_str());
    return;
  }
  if (!new_stage && drawn_ && now - last_drawn_ < redraw_after) return;
  last_drawn_ = now;
  draw_bar(std::clamp(done, 0.0, 1.0));
}

void Progress::draw_bar(double done) {
  const int filled = static_cast<int>(done * bar_width);
  const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                          std::string(static_cast<std::size_t>(bar_width - filled), '.');
  std::fprintf(stderr, "\r\033[K[%s] %3d %%  %s", bar.c_str(), static_cast<int>(done * 100.0), stage_.c_str());
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (!drawn_) return;
  std::fputs("\r\033[K", stderr);
  std::fflush(stderr);
  drawn_ = false;
}

std::function<void(std::string_view, double)> Progress::callback() {
  return [this](std::string_view stage, double done) { report(stage, done); };
}

}  // namespace volute::app
