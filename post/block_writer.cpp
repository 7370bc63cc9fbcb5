#include "post/block_writer.hpp"

#include <algorithm>
#include <cctype>

namespace volute::post {

using kinematics::Control;
using kinematics::DialectFamily;

namespace {

std::array<std::string, 3> vector_addresses(DialectFamily family) {
  switch (family) {
    case DialectFamily::siemens:
      return {"A3=", "B3=", "C3="};
    case DialectFamily::heidenhain:
      return {"TX", "TY", "TZ"};
    default:
      return {"I", "J", "K"};
  }
}

// Tape marks, program numbers and whole-line comments carry no block number.
bool takes_number(std::string_view line) {
  if (line.front() == '%' || line.front() == '(' || line.front() == ';') return false;
  return !(line.front() == 'O' && line.size() > 1 && std::isdigit(static_cast<unsigned char>(line[1])) != 0);
}

}  // namespace

BlockWriter::BlockWriter(const kinematics::Machine& machine, const Control& control)
    : control_(control), heidenhain_(control.family == DialectFamily::heidenhain) {
  linear_ = {control.linear_decimals, heidenhain_, control.force_decimal_point};
  rotary_ = {control.rotary_decimals, heidenhain_, control.force_decimal_point};
  vector_ = {control.vector_decimals, heidenhain_, control.force_decimal_point};
  feed_ = {control.feed_decimals, false, control.force_decimal_point};
  for (std::size_t k = 0; k < 5; ++k) address_[k] = std::string(1, machine.axes[k].letter);
  const auto vector = vector_addresses(control.family);
  std::copy(vector.begin(), vector.end(), address_.begin() + 5);
}

void BlockWriter::line(std::string_view text) {
  if (text.empty()) return;
  const std::size_t begin = text_.size();
  if (takes_number(text)) begin_block();
  text_ += text;
  end_block(begin);
  known_ = {};
  motion_.reset();
  known_feed_.reset();
}

void BlockWriter::code(std::string_view text) {
  const std::size_t begin = text_.size();
  begin_block();
  text_ += text;
  end_block(begin);
  known_feed_.reset();
}

void BlockWriter::begin_block() {
  if (!control_.block_numbers) return;
  if (!heidenhain_) {
    number_ += control_.block_number_step;
    text_ += 'N';
  }
  append_scaled(text_, number_, NumberFormat{.decimals = 0});
  text_ += ' ';
  if (heidenhain_) number_ += control_.block_number_step;  // its first block is 0
}

void BlockWriter::end_block(std::size_t begin) {
  longest_ = std::max(longest_, text_.size() - begin);
  text_ += '\n';
  ++blocks_;
}

BlockWriter::Units BlockWriter::units_of(const BlockWords& words) const {
  Units units{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (words.xyz_mm[k]) units[k] = scaled(*words.xyz_mm[k], linear_.decimals);
    if (words.axis_vector) units[5 + k] = scaled((*words.axis_vector)[static_cast<Eigen::Index>(k)], vector_.decimals);
  }
  for (std::size_t k = 0; k < 2; ++k)
    if (words.rotary_deg) units[3 + k] = scaled((*words.rotary_deg)[k], rotary_.decimals);
  return units;
}

// The three components of the vector go together, as one left out would count as 0, and they stand in every block: what
// a control holds when all are left out depends on its options. An LN block takes no coordinate over from the block
// before either.
bool BlockWriter::append_changed(const Units& units) {
  unsigned changed = 0;
  for (std::size_t k = 0; k < slots; ++k)
    changed |= static_cast<unsigned>(units[k].has_value() && units[k] != known_[k]) << k;
  if (changed == 0) return false;
  const bool whole = heidenhain_ && units[5].has_value();
  for (std::size_t k = 0; k < slots; ++k) {
    if (!units[k] || (k < 5 && !whole && ((changed >> k) & 1U) == 0)) continue;
    text_ += ' ';
    text_ += address_[k];
    append_scaled(text_, *units[k], format_of(k));
    known_[k] = units[k];
  }
  return true;
}

void BlockWriter::append_feed(const BlockWords& words, Motion motion) {
  if (motion == Motion::rapid) {
    if (heidenhain_) text_ += " R0 FMAX";
    return;
  }
  if (!words.feed) return;
  const std::int64_t units = scaled(*words.feed, feed_.decimals);
  if (!words.feed_always && known_feed_ == units) return;
  text_ += " F";
  append_scaled(text_, units, feed_);
  known_feed_ = units;
}

void BlockWriter::move(Motion motion, const BlockWords& words) {
  const std::size_t begin = text_.size();
  const std::int64_t number_before = number_;
  begin_block();
  if (heidenhain_) {
    text_ += words.axis_vector ? "LN" : "L";
  } else if (motion_ != motion) {
    text_ += motion == Motion::rapid ? "G0" : "G1";
  } else if (text_.size() > begin) {
    text_.pop_back();  // the blank behind the block number comes with the first word
  }
  if (!append_changed(units_of(words))) {
    text_.resize(begin);
    number_ = number_before;
    return;
  }
  if (text_[begin] == ' ') text_.erase(begin, 1);
  append_feed(words, motion);
  motion_ = motion;
  end_block(begin);
}

std::string BlockWriter::coordinates(const BlockWords& words) {
  const std::size_t begin = text_.size();
  known_ = {};
  append_changed(units_of(words));
  std::string taken = text_.size() > begin ? text_.substr(begin + 1) : std::string();
  text_.resize(begin);
  return taken;
}

void BlockWriter::now_at(const BlockWords& words) {
  const Units units = units_of(words);
  for (std::size_t k = 0; k < slots; ++k)
    if (units[k]) known_[k] = units[k];
}

}  // namespace volute::post
