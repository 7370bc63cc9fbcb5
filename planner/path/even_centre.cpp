#include "planner/path/even_centre.hpp"

#include "planner/surface/centre_slit.hpp"

namespace volute::planner {

Result<Centre> choose_centre(const EvenSurface& surface, const IntervalRule& rule, const PathOptions& options) {
  const auto loops = static_cast<int>(surface.topology.boundary_loops().size());
  if (options.centre_loop >= loops || options.centre_loop == 0) {
    return geometry::bad_input("path-centre-loop", "path.centre_loop = " + std::to_string(options.centre_loop) +
                                                       ": the surface has inner loops 1 to " +
                                                       std::to_string(loops - 1) +
                                                       "; leave the key out to have a centre chosen");
  }
  if (options.centre_loop > 0) return Centre(Index{options.centre_loop});
  (void)rule;
  const auto slit = centre_slit(surface.mesh, surface.topology);
  if (!slit) return tl::unexpected(slit.error());
  return Centre(Slit{slit->front().a, slit->back().a});
}

}  // namespace volute::planner
