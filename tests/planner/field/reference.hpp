// The worked numbers in data/field_reference.json.
#pragma once

#include <fstream>
#include <nlohmann/json.hpp>
#include <vector>

#include "geometry/vector.hpp"

namespace volute::planner {

using Json = nlohmann::json;

inline const Json& reference() {
  static const Json json =
      Json::parse(std::ifstream(VOLUTE_SOURCE_DIR "/tests/planner/field/data/field_reference.json"));
  return json;
}
inline geometry::Vec3 vec3(const Json& json) {
  return geometry::Vec3(json.at(0).get<double>(), json.at(1).get<double>(), json.at(2).get<double>());
}
inline geometry::Vec2 vec2(const Json& json) {
  return geometry::Vec2(json.at(0).get<double>(), json.at(1).get<double>());
}
inline std::vector<geometry::Vec3> vec3_list(const Json& json) {
  std::vector<geometry::Vec3> list;
  for (const Json& item : json) list.push_back(vec3(item));
  return list;
}

}  // namespace volute::planner
