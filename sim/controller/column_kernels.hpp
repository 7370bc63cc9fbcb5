// The arithmetic on columns of samples, compiled for the widest registers that the processor has.
#pragma once

namespace volute::sim {

/// Every function does the same operations in the same order on every processor (no fused multiply-add), so the results
/// are the same to the last bit.

/// out[k] = start + step (first + k)
void even_steps(double start, double step, int first, int count, double* out);
/// out[k] = c0 + c1 x[k]
void linear(double c0, double c1, const double* x, int count, double* out);
/// out[k] = c0 + x[k] (c1 + x[k] c2)
void quadratic(double c0, double c1, double c2, const double* x, int count, double* out);
/// out[k] = (from[k] - minus[k]) scale
void scaled_difference(const double* from, const double* minus, double scale, int count, double* out);
/// The greatest |x[k]|; 0 for none.
double greatest_magnitude(const double* x, int count);
/// Lowers `least` and raises `most` to hold every x[k].
void extend_range(const double* x, int count, double& least, double& most);

}  // namespace volute::sim
