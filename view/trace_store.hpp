// A run's samples as packed columns: what view.cbor keeps, and what every picture is drawn from.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "sim/verify.hpp"

namespace volute::view {

/// Columns of PackedData in binary steps: positions 2^-17 mm and 2^-20 rad, time 2^-17 s (wider where that would need
/// more than 31 bits), velocity, acceleration, jerk, lag and speed a 16,384th of their greatest magnitude or finer,
/// tool axes 2^-20. Properties: 1. unpacked_trace(packed_trace(t)) differs from t by half a step at most. 2. Packing
/// what was unpacked gives the same samples, bit for bit. 3. The same samples give the same bytes.
std::string packed_trace(const sim::TraceView& trace);
/// The inverse; nothing when the bytes are not a whole packed trace.
std::optional<sim::TraceView> unpacked_trace(std::string_view bytes);

/// The trace as a file would give it back.
sim::TraceView trace_as_stored(const sim::TraceView& trace);

}  // namespace volute::view
