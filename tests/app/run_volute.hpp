// Runs the built program as a user would and keeps what it says.
#pragma once

#include <array>
#include <filesystem>
#include <string>

namespace volute::app_test {

struct Outcome {
  int status = -1;
  std::string out, err;
};

/// `words` are shell words after the program's name; the working folder is `folder`.
Outcome run_volute(const std::string& words, const std::filesystem::path& folder);

/// An empty folder of this test's own.
std::filesystem::path scratch_folder(const std::string& name);

std::string text_of(const std::filesystem::path& file);
void write_text(const std::filesystem::path& file, const std::string& text);

/// A flat square plate of `half_mm` with a square hole, `cells` by `cells`, as binary STL bytes.
std::string plate_stl(double half_mm, int cells);
/// A closed box as binary STL bytes.
std::string box_stl(const std::array<double, 3>& low_mm, const std::array<double, 3>& high_mm);
/// A job on "plate.stl" beside it; `extra` is appended.
std::string plate_job(const std::string& extra = "");

/// Number of lines that are not empty.
int lines_in(const std::string& text);

}  // namespace volute::app_test
