// Writes blocks with modal words: what has not changed in its last printed digit is left out. Private to post.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "kinematics/model/control.hpp"
#include "post/word.hpp"

namespace volute::post {

enum class Motion : std::uint8_t { rapid, feed };

/// The numbers of one block. Absent groups are not written.
struct BlockWords {
  std::array<std::optional<double>, 3> xyz_mm{};
  std::optional<std::array<double, 2>> rotary_deg{};
  std::optional<geometry::Vec3> axis_vector{};
  std::optional<double> feed{};  ///< value of F
  bool feed_always = false;      ///< inverse time: F in every block
};

class BlockWriter {
 public:
  BlockWriter(const kinematics::Machine& machine, const kinematics::Control& control);

  /// Makes room for so many blocks of the usual length.
  void expect_blocks(std::size_t count) { text_.reserve(text_.size() + 50 * count); }
  /// A line of the control file, filled in; nothing when empty. What the control remembers afterwards is unknown: all
  /// words are due again.
  void line(std::string_view text);
  /// A block of one modal code that changes no coordinate; F is due again.
  void code(std::string_view text);
  /// A motion block; nothing when no coordinate has changed in its last printed digit.
  void move(Motion motion, const BlockWords& words);
  /// Coordinates for a line that carries them itself (tool length and first position in one block), which are then
  /// known.
  std::string coordinates(const BlockWords& words);
  void now_at(const BlockWords& words);

  [[nodiscard]] const NumberFormat& linear_format() const { return linear_; }
  [[nodiscard]] const NumberFormat& rotary_format() const { return rotary_; }
  [[nodiscard]] std::int64_t blocks() const { return blocks_; }
  [[nodiscard]] std::size_t longest_block() const { return longest_; }
  [[nodiscard]] std::string take_text() { return std::move(text_); }

 private:
  static constexpr std::size_t slots = 8;  // X Y Z, two rotaries, three of the vector
  using Units = std::array<std::optional<std::int64_t>, slots>;

  [[nodiscard]] Units units_of(const BlockWords& words) const;
  bool append_changed(const Units& units);
  void append_feed(const BlockWords& words, Motion motion);
  void begin_block();
  void end_block(std::size_t begin);
  [[nodiscard]] const NumberFormat& format_of(std::size_t slot) const {
    return slot < 3 ? linear_ : slot < 5 ? rotary_ : vector_;
  }

  const kinematics::Control& control_;
  bool heidenhain_;
  NumberFormat linear_, rotary_, vector_, feed_;
  std::array<std::string, slots> address_;
  std::string text_;
  Units known_{};
  std::optional<Motion> motion_;
  std::optional<std::int64_t> known_feed_;
  std::int64_t number_ = 0, blocks_ = 0;
  std::size_t longest_ = 0;
};

}  // namespace volute::post
