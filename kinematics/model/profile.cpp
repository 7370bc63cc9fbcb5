// Names of profiles: a machine with a control, told apart by the files that exist.
#include <algorithm>
#include <numeric>

#include "kinematics/model/control.hpp"

namespace volute::kinematics {

using geometry::bad_input;
using geometry::Result;

namespace {

namespace fs = std::filesystem;

std::vector<std::string> toml_stems(const fs::path& folder) {
  std::vector<std::string> stems;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error))
    if (entry.path().extension() == ".toml") stems.push_back(entry.path().stem().string());
  std::sort(stems.begin(), stems.end());
  return stems;
}

fs::path control_file(const fs::path& folder, const std::string& name) {
  return folder / "controls" / (name + ".toml");
}

bool allows(const Machine& machine, const std::string& control) {
  return machine.controls.empty() ||
         std::find(machine.controls.begin(), machine.controls.end(), control) != machine.controls.end();
}

Result<Profile> load_pair(const fs::path& machine_file, const fs::path& control) {
  auto machine = load_machine(machine_file);
  if (!machine) return tl::unexpected(machine.error());
  auto loaded = load_control(control);
  if (!loaded) return tl::unexpected(loaded.error());
  const std::string name = machine->name + "-" + loaded->name;
  return Profile{name, std::move(*machine), std::move(*loaded)};
}

// Levenshtein distance, row by row.
std::size_t edits_between(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replace = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replace, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

std::string nearest_names(const fs::path& folder, std::string_view wanted) {
  auto profiles = list_profiles(folder);
  if (!profiles) return "";
  const auto nearer = [&](const ProfileName& a, const ProfileName& b) {
    return edits_between(a.name, wanted) < edits_between(b.name, wanted);
  };
  std::stable_sort(profiles->begin(), profiles->end(), nearer);
  std::string text;
  for (std::size_t k = 0; k < std::min<std::size_t>(3, profiles->size()); ++k)
    text += (k ? ", " : "; nearest: ") + (*profiles)[k].name;
  return text;
}

Result<Profile> load_named(const fs::path& folder, const std::string& name) {
  for (std::size_t dash = name.rfind('-'); dash != std::string::npos && dash > 0; dash = name.rfind('-', dash - 1)) {
    const fs::path machine = folder / (name.substr(0, dash) + ".toml");
    const fs::path control = control_file(folder, name.substr(dash + 1));
    if (!fs::exists(machine) || !fs::exists(control)) continue;
    auto profile = load_pair(machine, control);
    if (profile && !allows(profile->machine, profile->control.name))
      return bad_input("profile-unknown", "profile \"" + name + "\": " + profile->machine.name +
                                              " is not built with the control " + profile->control.name +
                                              " (controls = [...] in its file)" + nearest_names(folder, name));
    return profile;
  }
  return bad_input("profile-unknown", "profile \"" + name + "\": no MACHINE-CONTROL of that name in " +
                                          folder.string() + nearest_names(folder, name));
}

}  // namespace

Result<Profile> load_profile(const fs::path& folder, std::string_view name_or_path) {
  const std::string name(name_or_path);
  const std::size_t colon = name.rfind(':');
  if (colon == std::string::npos) return load_named(folder, name);
  const std::string control = name.substr(colon + 1);
  const bool is_path = control.find('/') != std::string::npos || fs::path(control).extension() == ".toml";
  return load_pair(name.substr(0, colon), is_path ? fs::path(control) : control_file(folder, control));
}

Result<std::vector<ProfileName>> list_profiles(const fs::path& folder) {
  std::vector<ProfileName> names;
  const std::vector<std::string> controls = toml_stems(folder / "controls");
  for (const std::string& stem : toml_stems(folder)) {
    auto machine = load_machine(folder / (stem + ".toml"));
    if (!machine) return tl::unexpected(machine.error());
    for (const std::string& control : controls)
      if (allows(*machine, control)) names.push_back({stem + "-" + control, stem, control, machine->kind});
  }
  const auto by_name = [](const ProfileName& a, const ProfileName& b) { return a.name < b.name; };
  std::sort(names.begin(), names.end(), by_name);
  return names;
}

}  // namespace volute::kinematics
