// Progress on standard error: a bar on a terminal for whatever takes longer than a second, plain lines elsewhere.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace volute::app {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `done` is the share of this stage, 0 to 1. Called often; draws at most ten times a second.
  void report(std::string_view stage, double done);
  /// Clears the bar, so that other text can be written.
  void clear();
  [[nodiscard]] std::function<void(std::string_view, double)> callback();

 private:
  void draw_bar(double done);

  bool quiet_;
  bool terminal_;
  bool drawn_ = false;
  std::string stage_;
  std::chrono::steady_clock::time_point started_, last_drawn_;
};

}  // namespace volute::app
