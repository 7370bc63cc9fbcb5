#include "tests/app/run_volute.hpp"

#include <sys/wait.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <vector>

namespace volute::app_test {

namespace fs = std::filesystem;

std::string text_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_text(const fs::path& file, const std::string& text) { std::ofstream(file, std::ios::binary) << text; }

fs::path scratch_folder(const std::string& name) {
  const fs::path folder = fs::temp_directory_path() / ("volute-app-test-" + name);
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

Outcome run_volute(const std::string& words, const fs::path& folder) {
  const fs::path out = folder / ".stdout", err = folder / ".stderr";
  const std::string command = "cd '" + folder.string() + "' && '" VOLUTE_BINARY_DIR "/volute' " + words + " > '" +
                              out.string() + "' 2> '" + err.string() + "'";
  const int raw = std::system(command.c_str());
  return {WIFEXITED(raw) ? WEXITSTATUS(raw) : 128, text_of(out), text_of(err)};
}

namespace {

std::string stl_bytes(const std::vector<std::array<float, 9>>& faces) {
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(faces.size());
  bytes.append(reinterpret_cast<const char*>(&count), 4);
  for (const auto& face : faces) {
    const std::array<float, 3> normal{0.0F, 0.0F, 1.0F};
    bytes.append(reinterpret_cast<const char*>(normal.data()), 12);
    bytes.append(reinterpret_cast<const char*>(face.data()), 36);
    bytes.append(2, '\0');
  }
  return bytes;
}

}  // namespace

std::string plate_stl(double half_mm, int cells) {
  std::vector<std::array<float, 9>> faces;
  const double step = 2.0 * half_mm / cells;
  const auto corner = [&](int i, int j) {
    return std::array<float, 3>{static_cast<float>(-half_mm + i * step), static_cast<float>(-half_mm + j * step), 0.0F};
  };
  const auto add = [&](const std::array<float, 3>& a, const std::array<float, 3>& b, const std::array<float, 3>& c) {
    faces.push_back({a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]});
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j) {
      const bool hole = i >= cells * 2 / 5 && i < cells * 3 / 5 && j >= cells * 2 / 5 && j < cells * 3 / 5;
      if (hole) continue;
      add(corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
      add(corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
    }
  return stl_bytes(faces);
}

std::string box_stl(const std::array<double, 3>& low_mm, const std::array<double, 3>& high_mm) {
  // Corner k takes the high value of axis i where bit i of k is set; each face seen from outside, counterclockwise.
  constexpr std::array<std::array<int, 4>, 6> quads{
      {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
  std::vector<std::array<float, 9>> faces;
  for (const auto& quad : quads)
    for (const auto& triple : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      std::array<float, 9> face{};
      for (std::size_t v = 0; v < 3; ++v)
        for (std::size_t i = 0; i < 3; ++i) {
          const bool high = (quad[static_cast<std::size_t>(triple[v])] >> i & 1) != 0;
          face[3 * v + i] = static_cast<float>(high ? high_mm[i] : low_mm[i]);
        }
      faces.push_back(face);
    }
  return stl_bytes(faces);
}

std::string plate_job(const std::string& extra) {
  return "[part]\nsurface = \"plate.stl\"\n[tool]\nshape = \"ball\"\nradius_mm = 3\n[path]\nscallop_mm = 0.2\nmethod = "
         "\"even\"\n"
         "[process]\nfeed_mm_min = 600\n[machine]\nprofile = \"ac-head-fanuc\"\n" +
         extra;
}

int lines_in(const std::string& text) {
  std::istringstream in(text);
  int count = 0;
  for (std::string line; std::getline(in, line);) count += line.empty() ? 0 : 1;
  return count;
}

}  // namespace volute::app_test
