// Where the even spiral ends: the user's boundary loop, or the centre that promises the shortest path.
#pragma once

#include "planner/options.hpp"
#include "planner/path/even_domain.hpp"

namespace volute::planner {

struct CentreSearchOptions {
  int triangles = 1500;       ///< of the coarse mesh that candidates are tried on
  int deep_points = 8;        ///< ends of the first slits tried: every pair of them
  int starts = 2;             ///< of the best slits, whose ends are then moved
  int moves_max = 30;         ///< tried for each
  int outer = 3, inner = 15;  ///< of each trial field
};

/// `options.centre_loop` where the user names one. Else the best of: each hole as the centre, and slits between deep
/// points, the ends of the best moved until no move shortens the path. Each candidate is tried with the whole field
/// optimisation on a coarse mesh; its score is the path length that the field promises (the integral of |grad W|,
/// coarea), with a surcharge where the field falls short of the allowed interval or into pieces. Candidates run in
/// parallel; the choice does not depend on threads. Errors (bad_input): path-centre-loop (no such loop),
/// surface-too-coarse (no inner vertex to lay a slit through).
Result<Centre> choose_centre(const EvenSurface& surface, const IntervalRule& rule, const PathOptions& options,
                             const CentreSearchOptions& search = {});

/// The same surface with about so many triangles, its vertices among the old ones. Errors: those of
/// MeshTopology::build.
Result<EvenSurface> coarse_surface(const EvenSurface& surface, int triangles);

/// A centre of one mesh of a surface on another mesh of it: nearest vertices, and the loop that runs there.
Centre moved_centre(const EvenSurface& from, const Centre& centre, const EvenSurface& to);

}  // namespace volute::planner
