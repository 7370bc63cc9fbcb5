// docs/reproduction.md: one section an item between marks, so that one item can be made again without the others.
#pragma once

#include <map>
#include <string>
#include <string_view>

#include "app/reproduce/item.hpp"

namespace volute::app {

/// An item's section as Markdown. `figures` is the folder of the pictures as seen from the document.
std::string section_text(const Item& item, const ItemPage& page, const std::string& figures);

/// Sections by item name, as they stand in a document that was written before. Text without marks gives none.
std::map<std::string, std::string> sections_of(std::string_view document);

/// The whole document: preface, the sections in the order of reproduction_items(), the items that have none yet,
/// what cannot be made. Property:
/// sections_of(document_text(s)) = s for sections of known items.
std::string document_text(const std::map<std::string, std::string>& sections);

}  // namespace volute::app
