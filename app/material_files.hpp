// What a run left of the material, as files: cut_surface.ply, stock.stl, removed.csv.
#pragma once

#include <optional>

#include "app/output_folder.hpp"
#include "sim/verify.hpp"

namespace volute::app {

/// Writes what the result holds. cut_surface.ply: corners coloured and with their deviation in mm ("quality"; NaN where
/// nothing came near). stock.stl: what is left. removed.csv: one line a block that cut; with the spindle's speed also
/// the chip: the volume that one tooth takes on the mean of its block.
geometry::Result<void> write_material(const sim::VerifyResult& result, const kinematics::Cutter& cutter,
                                      std::optional<double> spindle_rpm, const OutputFolder& out);

}  // namespace volute::app
