// Lines of a control file with their {fields} filled in. Private to post.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "geometry/result.hpp"

namespace volute::post {

using Fields = std::map<std::string, std::string, std::less<>>;

/// Replaces every {field}. Error (bad_input): post-field, naming the line and the fields that there are.
geometry::Result<std::string> fill(std::string_view line, const Fields& fields, std::string_view control_name);
/// `name` as every control takes it in names and comments: capitals, digits, '-', '_'; everything else becomes '_'.
std::string program_name(std::string_view name);

}  // namespace volute::post
