// The page's program and style, bundled from view/page and part of this library.
#pragma once

#include <string_view>

namespace volute::view {

std::string_view page_script();
std::string_view page_style();

}  // namespace volute::view
