// Text as it must stand in a page.
#pragma once

#include <string>
#include <string_view>

namespace volute::view {

/// Nothing in it opens a tag or ends an attribute.
std::string html_escaped(std::string_view text);

}  // namespace volute::view
