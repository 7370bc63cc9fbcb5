// The choice of [Sun2016] 2.1 that is left to the user.
#pragma once

namespace volute::planner {

/// Which hole is the child of the outer boundary in the boundary tree, by distance along the surface.
enum class RootChild { nearest, farthest };

}  // namespace volute::planner
