// Where the even spiral ends: the user's boundary loop, or the centre that promises the shortest path.
#pragma once

#include <span>
#include <vector>

#include "planner/options.hpp"
#include "planner/path/even_domain.hpp"
#include "planner/path/even_field.hpp"

namespace volute::planner {

struct CentreSearchOptions {
  int triangles = 1500;        ///< of the coarse mesh that candidates are tried on
  int deep_points = 8;         ///< ends of the first slits tried: every pair of them
  int starts = 2;              ///< of the best slits, whose ends are then moved, and to which arms are added
  int loop_starts = 1;         ///< of the best holes, to which arms are added
  int arms_max = 3;            ///< added to each
  int arm_targets = 8;         ///< points that an added arm may lead to
  double arm_gain_min = 0.01;  ///< share of the length that an arm must save
  double grown_within = 1.12;  ///< times the best score so far: a start that is worse is kept as it is
  int moves_max = 30;          ///< tried for each
  bool ridges = false;        ///< arms along ridges and to other holes too, and starts far behind grown: twice the time
  int outer = 3, inner = 15;  ///< of each trial field
  EvenFieldOptions field{.step = 20.0, .relaxation = 1.0};  ///< stiff: near enough after these few steps
};

/// `options.centre_loop` where the user names one. Else, the best first: each hole as the centre, and slits between
/// deep points, the ends of the best moved until no move shortens the path, then arms added as long as they shorten it:
/// slits that bend and branch, and slits that grow out of a hole. Each candidate is tried with the whole field
/// optimisation on a coarse mesh; its score is the path length that the field promises (the integral of |grad W|,
/// coarea), with a surcharge where the field falls short of the allowed interval or into pieces. Candidates run in
/// parallel; the choice does not depend on threads. Errors (bad_input): path-centre-loop (no such loop),
/// surface-too-coarse (no inner vertex to lay a slit through).
Result<std::vector<Centre>> choose_centres(const EvenSurface& surface, const IntervalRule& rule,
                                           const PathOptions& options, const CentreSearchOptions& search = {});

/// The path length that a field promises: the integral of |grad W| (coarea) and half a turn at either end, longer by as
/// much as the field falls short of the allowed interval.
double promised_length_mm(const EvenDomain& domain, const IntervalRule& rule, std::span<const Vec2> slopes);

/// The same surface with about so many triangles, its vertices among the old ones. Errors: those of
/// MeshTopology::build.
Result<EvenSurface> coarse_surface(const EvenSurface& surface, int triangles);

/// The vertex among `pool` nearest to a place. no_index where the pool is empty.
Index nearest_vertex(const TriangleMesh& mesh, std::span<const Index> pool, const Vec3& place);

/// A centre of one mesh of a surface on another mesh of it: nearest vertices, and the loop that runs there.
Centre moved_centre(const EvenSurface& from, const Centre& centre, const EvenSurface& to);

}  // namespace volute::planner
