#include "post/template_line.hpp"

#include <cctype>

namespace volute::post {

namespace {

std::string known_fields(const Fields& fields) {
  std::string list;
  for (const auto& [name, value] : fields) list += " {" + name + "}";
  return list;
}

}  // namespace

geometry::Result<std::string> fill(std::string_view line, const Fields& fields, std::string_view control_name) {
  std::string text;
  const std::string_view whole = line;
  while (true) {
    const std::size_t open = line.find('{');
    text += line.substr(0, open);
    if (open == std::string_view::npos) return text;
    const std::size_t close = line.find('}', open);
    const std::string_view name =
        close == std::string_view::npos ? line.substr(open + 1) : line.substr(open + 1, close - open - 1);
    const auto field = fields.find(name);
    if (close == std::string_view::npos || field == fields.end())
      return geometry::bad_input("post-field", "control " + std::string(control_name) + ": line \"" +
                                                   std::string(whole) + "\" asks for {" + std::string(name) +
                                                   "}; there are" + known_fields(fields));
    text += field->second;
    line.remove_prefix(close + 1);
  }
}

std::string program_name(std::string_view name) {
  std::string result;
  for (const char c : name) {
    const auto letter = static_cast<unsigned char>(c);
    const bool plain = letter < 128 && (std::isalnum(letter) != 0 || c == '-' || c == '_');
    result += plain ? static_cast<char>(std::toupper(letter)) : '_';
  }
  return result.empty() ? "VOLUTE" : result;
}

}  // namespace volute::post
