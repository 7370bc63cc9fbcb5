// A machine file read into a Machine, every mistake named with file, line and key.
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/mesh_io.hpp"
#include "geometry/number_text.hpp"
#include "geometry/turn.hpp"
#include "kinematics/model/link_shapes.hpp"
#include "kinematics/model/machine.hpp"
#include "kinematics/model/toml_reader.hpp"

namespace volute::kinematics {

using geometry::Mat3;
using geometry::Result;
using geometry::short_text;

namespace {

constexpr double seconds_per_minute = 60.0;

Vec3 unit_vector(TomlReader& reader, const toml::table& table, const std::string& where, std::string_view key,
                 std::optional<Vec3> fallback) {
  const Vec3 vector = reader.vector(table, where, key, fallback);
  if (vector.norm() > 1e-6) return vector.normalized();
  reader.refuse(table.get(key), where + "." + std::string(key), "is too short to be a direction");
  return Vec3::UnitZ();
}

// Travel, `zero` and limits carry their units in the key, so linear and rotary axes have different keys.
struct AxisKeys {
  const char *zero, *travel, *velocity, *acceleration, *jerk, *viscous, *coulomb, *force;
  double to_inner;  ///< from the file's mm or degrees
};
constexpr AxisKeys linear_keys = {"zero_mm",
                                  "travel_mm",
                                  "max_velocity_mm_min",
                                  "max_acceleration_mm_s2",
                                  "max_jerk_mm_s3",
                                  "viscous_friction_n_s_mm",
                                  "coulomb_friction_n",
                                  "max_force_n",
                                  1.0};
constexpr AxisKeys rotary_keys = {"zero_deg",
                                  "travel_deg",
                                  "max_velocity_deg_s",
                                  "max_acceleration_deg_s2",
                                  "max_jerk_deg_s3",
                                  "viscous_friction_nm_s_rad",
                                  "coulomb_friction_nm",
                                  "max_torque_nm",
                                  std::numbers::pi / 180.0};

void read_travel(TomlReader& reader, const toml::table& table, const std::string& where, const AxisKeys& keys,
                 Axis& axis) {
  if (axis.kind == AxisKind::rotary && reader.boolean(table, where, "endless", false)) {
    if (table.contains(keys.travel))
      reader.refuse(table.get(keys.travel), where, "endless = true and a travel contradict each other; keep one");
    return;
  }
  const auto travel = reader.numbers(table, where, keys.travel, 2);
  if (!(travel[0] < travel[1]))
    reader.refuse(table.get(keys.travel), where + "." + keys.travel, "the first value must be below the second");
  axis.travel_min = travel[0] * keys.to_inner;
  axis.travel_max = travel[1] * keys.to_inner;
}

void read_mass(TomlReader& reader, const toml::table& table, const std::string& where, const AxisKeys& keys,
               Axis& axis) {
  axis.moved_mass_kg = reader.number(table, where, "mass_kg", 0.0);
  const Vec3 diagonal = reader.vector(table, where, "inertia_kg_m2", Vec3(Vec3::Zero()));
  axis.inertia_kg_m2 = diagonal.asDiagonal();
  axis.centre_of_mass_M_mm = reader.vector(table, where, "centre_of_mass_mm", Vec3(Vec3::Zero()));
  axis.viscous_friction = reader.number(table, where, keys.viscous, 0.0);
  axis.coulomb_friction = reader.number(table, where, keys.coulomb, 0.0);
  if (table.contains(keys.force)) axis.force_max = reader.positive(table, where, keys.force);
  if (axis.moved_mass_kg < 0.0 || diagonal.minCoeff() < 0.0)
    reader.refuse(&table, where, "mass_kg and inertia_kg_m2 must not be negative");
}

void read_limits(TomlReader& reader, const toml::table& table, const std::string& where, const AxisKeys& keys,
                 Axis& axis) {
  const double velocity_unit = axis.kind == AxisKind::linear ? 1.0 / seconds_per_minute : keys.to_inner;
  axis.zero = reader.number(table, where, keys.zero, 0.0) * keys.to_inner;
  axis.velocity_max = reader.positive(table, where, keys.velocity) * velocity_unit;
  axis.acceleration_max = reader.positive(table, where, keys.acceleration) * keys.to_inner;
  axis.jerk_max = reader.positive(table, where, keys.jerk) * keys.to_inner;
  axis.position_gain_per_s = reader.positive(table, where, "position_gain_per_s", 33.0);
  axis.velocity_feed_forward = reader.number(table, where, "velocity_feed_forward", 1.0);
  if (axis.velocity_feed_forward < 0.0 || axis.velocity_feed_forward > 1.0)
    reader.refuse(table.get("velocity_feed_forward"), where + ".velocity_feed_forward", "must lie between 0 and 1");
}

Axis read_axis(TomlReader& reader, const toml::table& axes, char letter) {
  const std::string key(1, letter), where = "axis." + key;
  const toml::table& table = reader.table(axes, "axis", key);
  reader.only_keys(table, where,
                   {"kind",
                    "direction",
                    "point_mm",
                    "sign",
                    "endless",
                    "zero_mm",
                    "zero_deg",
                    "travel_mm",
                    "travel_deg",
                    "max_velocity_mm_min",
                    "max_velocity_deg_s",
                    "max_acceleration_mm_s2",
                    "max_acceleration_deg_s2",
                    "max_jerk_mm_s3",
                    "max_jerk_deg_s3",
                    "position_gain_per_s",
                    "velocity_feed_forward",
                    "mass_kg",
                    "inertia_kg_m2",
                    "centre_of_mass_mm",
                    "viscous_friction_n_s_mm",
                    "viscous_friction_nm_s_rad",
                    "coulomb_friction_n",
                    "coulomb_friction_nm",
                    "max_force_n",
                    "max_torque_nm",
                    "assumed"});
  Axis axis;
  axis.letter = letter;
  axis.kind = reader.choice(table, where, "kind", {"linear", "rotary"}) == 0 ? AxisKind::linear : AxisKind::rotary;
  const AxisKeys& keys = axis.kind == AxisKind::linear ? linear_keys : rotary_keys;
  const double sign = reader.number(table, where, "sign", 1.0);
  if (std::abs(sign) != 1.0) reader.refuse(table.get("sign"), where + ".sign", short_text(sign) + " must be 1 or -1");
  axis.direction_M = sign * unit_vector(reader, table, where, "direction", std::nullopt);
  if (axis.kind == AxisKind::rotary) axis.point_M_mm = reader.vector(table, where, "point_mm");
  read_limits(reader, table, where, keys, axis);
  read_travel(reader, table, where, keys, axis);
  read_mass(reader, table, where, keys, axis);
  axis.assumed = !reader.texts(table, where, "assumed").empty();
  return axis;
}

bool known_letter(const std::string& word) {
  return word.size() == 1 && std::string_view("XYZABC").find(word[0]) != std::string_view::npos;
}

// The letters of [chain], workpiece side first; X Y Z and two rotaries, each once.
std::string read_chain_letters(TomlReader& reader, Machine& machine) {
  const toml::table& chain = reader.table(reader.root(), "", "chain");
  reader.only_keys(chain, "chain", {"table", "head"});
  std::string letters;
  for (const char* side : {"table", "head"}) {
    for (const std::string& word : reader.texts(chain, "chain", side)) {
      if (!known_letter(word) || letters.find(word) != std::string::npos)
        reader.refuse(chain.get(side), std::string("chain.") + side,
                      "\"" + word + "\" must be one of X Y Z A B C and stand once");
      letters += word;
    }
    if (std::string_view(side) == "table") machine.table_axes = static_cast<int>(letters.size());
  }
  const bool complete = letters.size() == axis_count && letters.find('X') != std::string::npos &&
                        letters.find('Y') != std::string::npos && letters.find('Z') != std::string::npos;
  if (!complete)
    reader.refuse(&chain, "chain",
                  "table and head together must name X, Y, Z and two of A, B, C; found \"" + letters + "\"", "chain");
  return letters;
}

void read_axes(TomlReader& reader, const std::string& letters, Machine& machine) {
  std::string rotaries;
  for (const char letter : std::string_view("ABC"))
    if (letters.find(letter) != std::string::npos) rotaries += letter;
  const std::string order = "XYZ" + rotaries;
  const toml::table& axes = reader.table(reader.root(), "", "axis");
  for (const auto& [key, node] : axes)
    if (order.find(key.str()) == std::string::npos)
      reader.refuse(&node, "axis." + std::string(key.str()), "is not in [chain]", "chain");
  for (std::size_t i = 0; i < axis_count; ++i) {
    machine.axes[i] = read_axis(reader, axes, order[i]);
    const AxisKind wanted = i < 3 ? AxisKind::linear : AxisKind::rotary;
    if (machine.axes[i].kind != wanted)
      reader.refuse(axes.get(std::string(1, order[i])), std::string("axis.") + order[i] + ".kind",
                    "X Y Z are linear and A B C are rotary");
    machine.chain[letters.find(order[i])] = static_cast<int>(i);
  }
}

std::string kind_of(const Machine& machine) {
  int rotaries_on_table = 0;
  for (int k = 0; k < machine.table_axes; ++k)
    rotaries_on_table += machine.chain[static_cast<std::size_t>(k)] >= 3 ? 1 : 0;
  return rotaries_on_table == 0 ? "head-head" : rotaries_on_table == 1 ? "head-table" : "table-table";
}

// A chain that cannot point or place the tool freely is refused here, so that inverse kinematics may rely on it.
void check_geometry(TomlReader& reader, const Machine& machine) {
  Mat3 directions;
  for (int i = 0; i < 3; ++i) directions.col(i) = machine.axes[static_cast<std::size_t>(i)].direction_M;
  if (std::abs(directions.determinant()) < 0.05)
    reader.refuse(
        &reader.root(), "axis",
        "the directions of X, Y and Z lie nearly in one plane (volume " + short_text(directions.determinant()) + ")",
        "chain");
  const bool third_is_next = std::find(machine.chain.begin(), machine.chain.end(), 3) <
                             std::find(machine.chain.begin(), machine.chain.end(), 4);
  const Axis& by_workpiece = machine.axes[third_is_next ? 3 : 4];
  const Axis& by_tool = machine.axes[third_is_next ? 4 : 3];
  const Vec3 tool_axis = machine.gauge_at_zero_M.linear().col(2);
  if (by_workpiece.direction_M.cross(by_tool.direction_M).norm() < 0.05)
    reader.refuse(&reader.root(), "axis",
                  std::string(1, by_workpiece.letter) + " and " + by_tool.letter +
                      " are nearly parallel: the tool cannot be pointed",
                  "chain");
  if (by_tool.direction_M.cross(tool_axis).norm() < 0.05)
    reader.refuse(&reader.root(), "axis",
                  std::string(1, by_tool.letter) + " is nearly parallel to the tool axis: it cannot tilt the tool",
                  "chain");
}

void read_gauge(TomlReader& reader, Machine& machine) {
  const toml::table& gauge = reader.table(reader.root(), "", "gauge");
  reader.only_keys(gauge, "gauge", {"point_mm", "axis"});
  const Vec3 axis_M = unit_vector(reader, gauge, "gauge", "axis", Vec3(Vec3::UnitZ()));
  machine.gauge_at_zero_M.translation() = reader.vector(gauge, "gauge", "point_mm");
  machine.gauge_at_zero_M.linear() = geometry::turn_from_z(axis_M).toRotationMatrix();
}

std::optional<geometry::TriangleMesh> read_shape(TomlReader& reader, const toml::table& table, const std::string& where,
                                                 const std::filesystem::path& folder) {
  if (table.contains("box")) {
    const toml::table& box = reader.table(table, where, "box");
    const Vec3 min_mm = reader.vector(box, where + ".box", "min_mm"),
               max_mm = reader.vector(box, where + ".box", "max_mm");
    if ((min_mm.array() < max_mm.array()).all()) return box_mesh(min_mm, max_mm);
    reader.refuse(&box, where + ".box", "min_mm must lie below max_mm in every coordinate");
  } else if (table.contains("cylinder")) {
    const toml::table& cylinder = reader.table(table, where, "cylinder");
    const std::string inside = where + ".cylinder";
    const Vec3 from_mm = reader.vector(cylinder, inside, "from_mm"), to_mm = reader.vector(cylinder, inside, "to_mm");
    const double radius_mm = reader.positive(cylinder, inside, "radius_mm");
    const double to_radius_mm = reader.positive(cylinder, inside, "to_radius_mm", radius_mm);
    if ((to_mm - from_mm).norm() > 1e-9 && radius_mm > 0.0 && to_radius_mm > 0.0)
      return cone_mesh(from_mm, to_mm, radius_mm, to_radius_mm);
    reader.refuse(&cylinder, inside, "from_mm and to_mm must differ");
  } else {
    const std::string name = reader.text(table, where, "stl");
    if (reader.error()) return std::nullopt;
    auto loaded = geometry::load_mesh(folder / name);
    if (loaded) return std::move(loaded->mesh);
    reader.refuse(table.get("stl"), where + ".stl", loaded.error().message);
  }
  return std::nullopt;
}

void read_link(TomlReader& reader, const toml::node& node, std::size_t place, Machine& machine) {
  const std::string where = "link[" + std::to_string(place) + "]";
  const toml::table* table = node.as_table();
  if (!table) return reader.refuse(&node, where, "must be a table: start it with [[link]]");
  reader.only_keys(*table, where, {"moves_with", "name", "box", "cylinder", "stl"});
  const std::string letter = reader.text(*table, where, "moves_with");
  LinkShape shape{.link = -1, .name = reader.text(*table, where, "name"), .mesh_M = {}};
  if (letter != "base") {
    shape.link = letter.size() == 1 ? machine.axis_index(letter[0]) : -1;
    if (shape.link < 0)
      reader.refuse(table->get("moves_with"), where + ".moves_with",
                    "\"" + letter + "\" is neither base nor an axis of [chain]");
  }
  if (auto mesh = read_shape(reader, *table, where, machine.file.parent_path())) {
    shape.mesh_M = std::move(*mesh);
    machine.shapes.push_back(std::move(shape));
  }
}

void read_links(TomlReader& reader, Machine& machine) {
  const toml::node* links = reader.root().get("link");
  if (!links) return;
  const toml::array* array = links->as_array();
  if (!array) return reader.refuse(links, "link", "must be a list of tables: start each with [[link]]");
  for (std::size_t k = 0; k < array->size() && !reader.error(); ++k) read_link(reader, (*array)[k], k, machine);
}

void read_head_of_file(TomlReader& reader, Machine& machine) {
  reader.only_keys(reader.root(), "",
                   {"title", "controls", "rapid_mm_min", "chain", "gauge", "axis", "link", "assumed"});
  machine.title = reader.text(reader.root(), "", "title");
  machine.controls = reader.texts(reader.root(), "", "controls");
  machine.rapid_mm_s = reader.positive(reader.root(), "", "rapid_mm_min") / seconds_per_minute;
}

}  // namespace

Result<Machine> load_machine(const std::filesystem::path& file) {
  TomlReader reader(file, "machine");
  Machine machine;
  machine.name = file.stem().string();
  machine.file = file;
  if (!reader.error()) read_head_of_file(reader, machine);
  std::string letters;
  if (!reader.error()) letters = read_chain_letters(reader, machine);
  if (!reader.error()) read_axes(reader, letters, machine);
  if (!reader.error()) read_gauge(reader, machine);
  if (!reader.error()) check_geometry(reader, machine);
  if (!reader.error()) read_links(reader, machine);
  if (reader.error()) return tl::unexpected(*reader.error());
  machine.kind = kind_of(machine);
  return machine;
}

}  // namespace volute::kinematics
