// The mouse-like shell: steep walls all round, a hump at the back and a slot for the wheel.
#pragma once

#include "plane_mesher.hpp"

namespace volute::examples {

/// About 100 x 60 x 35 mm. Seen from outside, the walls end 84 degrees steep, 4 mm above z = 0.
geometry::TriangleMesh mouse_shell(double edge_mm);

/// Height of the shell over a point of its plan, z = H(x) (1 - rho^p)^(1/p).
double mouse_height_mm(double x_mm, double y_mm);

}  // namespace volute::examples
