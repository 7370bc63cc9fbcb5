// The table that `volute run` and `volute simulate` print: report.json for people, in one screen.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace volute::app {

/// Requires: `report` holds the keys of the contract; absent ones leave their rows out.
std::string run_table(const nlohmann::ordered_json& report, const std::filesystem::path& folder,
                      const std::vector<std::string>& pictures);

/// The rows that a plan knows: path and orientation.
std::string plan_table(const nlohmann::ordered_json& report, const std::filesystem::path& folder);

/// Rows "name   value" under a heading, aligned; shared by all tables.
std::string table_row(const std::string& name, const std::string& value);

}  // namespace volute::app
