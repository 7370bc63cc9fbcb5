// Whole files in and out. Results are written beside their place and renamed into it: a reader never sees half a file.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "geometry/result.hpp"

namespace volute::geometry {

/// Errors: file-missing (bad_input), file-not-read (system).
Result<std::string> read_file(const std::filesystem::path& file);
/// Errors (system): file-not-written. On an error the file that was there before is untouched.
Result<void> write_file(const std::filesystem::path& file, std::string_view bytes);

}  // namespace volute::geometry
