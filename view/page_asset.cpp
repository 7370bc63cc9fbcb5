// The bytes of view/page/dist go into the object file as they are: no generator, no copy at run time.
#include "view/page_asset.hpp"

#define VOLUTE_EMBED(name, file)                                                                                     \
  __asm__(".pushsection .rodata\n.global " #name "\n" #name ":\n.incbin \"" file "\"\n.global " #name "_end\n" #name \
          "_end:\n.byte 0\n.popsection\n")

VOLUTE_EMBED(volute_page_script, VOLUTE_PAGE_FOLDER "/report.js");
VOLUTE_EMBED(volute_page_style, VOLUTE_PAGE_FOLDER "/report.css");

extern "C" {
extern const char volute_page_script[], volute_page_script_end[], volute_page_style[], volute_page_style_end[];
}

namespace volute::view {

std::string_view page_script() {
  return {volute_page_script, static_cast<std::size_t>(volute_page_script_end - volute_page_script)};
}
std::string_view page_style() {
  return {volute_page_style, static_cast<std::size_t>(volute_page_style_end - volute_page_style)};
}

}  // namespace volute::view
