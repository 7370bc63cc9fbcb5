#include "geometry/mesh_io.hpp"

#include <cmath>

#include "geometry/check.hpp"
#include "geometry/file.hpp"
#include "geometry/mesh_damage.hpp"
#include "geometry/mesh_formats.hpp"
#include "geometry/number_text.hpp"
#include "geometry/text_cursor.hpp"

namespace volute::geometry {

namespace {

std::string lowered_ending(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

/// A binary STL may begin with "solid" too; a text one has no byte 0 where the binary header ends.
bool looks_like_text(std::string_view bytes) { return bytes.substr(0, 512).find('\0') == std::string_view::npos; }

Result<TriangleMesh> parse_by_content(std::string_view bytes, const std::filesystem::path& file) {
  const std::string name = file.string();
  const std::string_view first = TextCursor(bytes.substr(0, 4096)).word();
  const std::string ending = lowered_ending(file);
  if (is_exact_stl_binary(bytes)) return parse_stl_binary(bytes, name);
  if (first == "ply") return parse_ply(bytes, name);
  if (first.size() <= 5 && first.ends_with("OFF")) return parse_off(bytes, name);
  if (same_word(first.substr(0, 5), "solid") && looks_like_text(bytes)) return parse_stl_ascii(bytes, name);
  if (ending == ".obj") return parse_obj(bytes, name);
  if (ending == ".stl") return parse_stl_binary(bytes, name);
  if (ending == ".ply" || ending == ".off")
    return bad_input("mesh-syntax", name + ":1: a " + ending.substr(1) + " file begins with \"" +
                                        (ending == ".ply" ? "ply" : "OFF") +
                                        "\"; export it again or give it its right ending");
  return bad_input("mesh-format-unknown", name + ": neither STL, PLY, OFF nor OBJ; export the part as one of these");
}

Result<void> scale(TriangleMesh& mesh, double unit_mm, const std::string& name) {
  for (std::size_t v = 0; v < mesh.vertices_mm.size(); ++v) {
    mesh.vertices_mm[v] *= unit_mm;
    if (mesh.vertices_mm[v].norm() > 1e9)
      return bad_input("mesh-not-finite",
                       name + ": vertex " + std::to_string(v) + " stands " + short_text(mesh.vertices_mm[v].norm()) +
                           " mm from the origin; at most 1e9 mm can be worked on, check the unit or the file");
  }
  return {};
}

void orient(LoadedMesh& loaded) {
  const Result<Index> turned = make_orientation_consistent(loaded.mesh);
  if (!turned) {
    loaded.repairs.warnings.push_back(turned.error().message);
    return;
  }
  loaded.repairs.triangles_turned = *turned;
  if (*turned > 0)
    loaded.repairs.warnings.push_back(std::to_string(*turned) +
                                      " triangles turned so that neighbours agree on the outside");
}

}  // namespace

Result<LoadedMesh> load_mesh(const std::filesystem::path& file, double unit_mm) {
  VOLUTE_CHECK(std::isfinite(unit_mm) && unit_mm > 0.0, unit_mm);
  const Result<std::string> bytes = read_file(file);
  if (!bytes) return tl::unexpected(bytes.error());
  if (bytes->empty()) return bad_input("file-empty", file.string() + ": the file is empty; copy or export it again");
  Result<TriangleMesh> soup = parse_by_content(*bytes, file);
  if (!soup) return tl::unexpected(soup.error());
  const bool is_soup = soup->vertices_mm.size() == 3 * soup->triangles.size();
  if (is_exact_stl_binary(*bytes))
    if (auto normals = check_stored_normals(*bytes, *soup, file.string()); !normals)
      return tl::unexpected(normals.error());
  if (auto scaled = scale(*soup, unit_mm, file.string()); !scaled) return tl::unexpected(scaled.error());
  LoadedMesh loaded = weld(std::move(*soup));
  if (loaded.mesh.triangles.empty())
    return bad_input("mesh-empty",
                     file.string() + ": no triangle with an area is left of the file; check its unit and its contents");
  orient(loaded);
  if (is_soup)
    if (auto whole = check_torn(loaded.mesh, file.string()); !whole) return tl::unexpected(whole.error());
  return loaded;
}

}  // namespace volute::geometry
