#include "sim/interpreter/parameters.hpp"

#include <cctype>

#include "geometry/check.hpp"

namespace volute::sim {

std::string plain_name(std::string_view name) {
  std::string out;
  for (const char c : name)
    if (c != ' ' && c != '\t') out += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::optional<double> Parameters::number(int index) const {
  if (index >= 1 && index <= local_count) return frames_.back().numbers[static_cast<std::size_t>(index - 1)];
  const auto found = numbers_.find(index);
  return found == numbers_.end() ? std::nullopt : std::optional<double>(found->second);
}

void Parameters::set_number(int index, double value) {
  VOLUTE_CHECK(index >= 1 && index <= highest, index);
  if (index <= local_count)
    frames_.back().numbers[static_cast<std::size_t>(index - 1)] = value;
  else
    numbers_[index] = value;
}

std::optional<double> Parameters::named(std::string_view name) const {
  const std::string key = plain_name(name);
  const auto& names = key.starts_with('_') ? names_ : frames_.back().names;
  const auto found = names.find(key);
  return found == names.end() ? std::nullopt : std::optional<double>(found->second);
}

void Parameters::set_named(std::string_view name, double value) {
  std::string key = plain_name(name);
  auto& names = key.starts_with('_') ? names_ : frames_.back().names;
  names[std::move(key)] = value;
}

void Parameters::enter(const std::vector<double>& arguments) {
  VOLUTE_CHECK(arguments.size() <= local_count, arguments.size());
  Frame frame;
  frame.numbers.fill(0.0);
  for (std::size_t i = 0; i < arguments.size(); ++i) frame.numbers[i] = arguments[i];
  frames_.push_back(std::move(frame));
}

void Parameters::leave() {
  VOLUTE_CHECK(frames_.size() > 1, frames_.size());
  frames_.pop_back();
}

}  // namespace volute::sim
