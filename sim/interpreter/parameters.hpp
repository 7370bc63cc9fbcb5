// Parameters of word-address programs: #1 .. #5999, #<name>, #<_name>, and the frames of subprogram calls.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace volute::sim {

/// Numbers 1 to 30 and names without a leading underscore belong to the subprogram that runs; all others to the
/// program.
class Parameters {
 public:
  static constexpr int local_count = 30;
  static constexpr int highest = 9999;

  Parameters() : frames_(1) {}

  [[nodiscard]] std::optional<double> number(int index) const;
  /// Requires: 1 <= index <= highest.
  void set_number(int index, double value);
  /// Names are compared without case and without blanks.
  [[nodiscard]] std::optional<double> named(std::string_view name) const;
  void set_named(std::string_view name, double value);

  /// A new frame whose #1 .. #n are `arguments` and whose other local numbers are 0.
  void enter(const std::vector<double>& arguments);
  void leave();
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }

 private:
  struct Frame {
    std::array<std::optional<double>, local_count> numbers;
    std::map<std::string, double, std::less<>> names;
  };
  std::vector<Frame> frames_;
  std::map<int, double> numbers_;
  std::map<std::string, double, std::less<>> names_;
};

/// `name` in lower case without blanks.
std::string plain_name(std::string_view name);

}  // namespace volute::sim
