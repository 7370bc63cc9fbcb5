#include "planner/surface/sparse_solver.hpp"

#include <dlfcn.h>

#include <cholmod.h>

#include <vector>

#include "geometry/check.hpp"
#include "planner/surface/sparse_columns.hpp"

namespace volute::planner {
namespace {

using Matrix = Eigen::SparseMatrix<double>;

// More than one BLAS thread could change the order of a sum, and would fight with the planner's own threads. So would
// OpenMP's, which CHOLMOD asks for: four of them for every small block, and waking them costs more than they save.
void hold_to_one_thread() {
  using Set = void (*)(int);
  static const auto set_blas_threads = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "openblas_set_num_threads"));
  static const auto set_parallel_levels = reinterpret_cast<Set>(dlsym(RTLD_DEFAULT, "omp_set_max_active_levels"));
  if (set_blas_threads != nullptr) set_blas_threads(1);
  if (set_parallel_levels != nullptr) set_parallel_levels(0);  // of the calling thread alone
}

/// CHOLMOD's view of an Eigen matrix: the upper half is read, nothing is copied or written.
cholmod_sparse view_of(const Matrix& matrix) {
  cholmod_sparse out{};
  out.nrow = static_cast<std::size_t>(matrix.rows());
  out.ncol = static_cast<std::size_t>(matrix.cols());
  out.nzmax = static_cast<std::size_t>(matrix.nonZeros());
  out.p = const_cast<int*>(matrix.outerIndexPtr());
  out.i = const_cast<int*>(matrix.innerIndexPtr());
  out.x = const_cast<double*>(matrix.valuePtr());
  out.stype = 1;
  out.itype = CHOLMOD_INT;
  out.xtype = CHOLMOD_REAL;
  out.dtype = CHOLMOD_DOUBLE;
  out.sorted = 1;
  out.packed = 1;
  return out;
}

cholmod_dense view_of(const double* values, std::size_t rows, std::size_t columns) {
  cholmod_dense out{};
  out.nrow = rows;
  out.ncol = columns;
  out.nzmax = rows * columns;
  out.d = rows;
  out.x = const_cast<double*>(values);
  out.xtype = CHOLMOD_REAL;
  out.dtype = CHOLMOD_DOUBLE;
  return out;
}

}  // namespace

struct SparseSolver::Factor {
  cholmod_common common{};
  cholmod_factor* symbolic_and_numbers = nullptr;
  // Workspace that CHOLMOD keeps between solves.
  cholmod_dense *solution = nullptr, *work_y = nullptr, *work_e = nullptr;
  std::size_t rows = 0;

  Factor() {
    cholmod_start(&common);
    common.supernodal = CHOLMOD_SUPERNODAL;
    common.nmethods = 1;
    common.method[0].ordering = CHOLMOD_AMD;
    common.postorder = 1;
    common.final_ll = 1;
    common.print = 0;
    common.quick_return_if_not_posdef = 1;
    common.error_handler = nullptr;
  }
  Factor(const Factor&) = delete;
  Factor& operator=(const Factor&) = delete;
  ~Factor() {
    cholmod_free_dense(&solution, &common);
    cholmod_free_dense(&work_y, &common);
    cholmod_free_dense(&work_e, &common);
    cholmod_free_factor(&symbolic_and_numbers, &common);
    cholmod_finish(&common);
  }

  Result<void> check(const char* step) const {
    const std::string size = std::to_string(rows) + " unknowns";
    if (common.status == CHOLMOD_OUT_OF_MEMORY || common.status == CHOLMOD_TOO_LARGE) {
      return geometry::system_error("matrix-too-large", std::string(step) + " a system of " + size +
                                                            " does not fit in memory; plan on a coarser mesh");
    }
    if (common.status != CHOLMOD_OK) {
      return geometry::bad_input("matrix-not-positive-definite",
                                 "a system of " + size + " has no unique solution (" + step +
                                     "); the mesh has triangles too thin for double precision: repair or remesh it");
    }
    return {};
  }

  const cholmod_dense& solve(const double* values, std::size_t columns) {
    cholmod_dense right = view_of(values, rows, columns);
    const int done =
        cholmod_solve2(CHOLMOD_A, symbolic_and_numbers, &right, nullptr, &solution, nullptr, &work_y, &work_e, &common);
    VOLUTE_CHECK(done != 0 && solution != nullptr, common.status, rows, columns);
    return *solution;
  }
};

SparseSolver::SparseSolver(std::unique_ptr<Factor> factor) : factor_(std::move(factor)) {}
SparseSolver::~SparseSolver() = default;
SparseSolver::SparseSolver(SparseSolver&&) noexcept = default;
SparseSolver& SparseSolver::operator=(SparseSolver&&) noexcept = default;

Result<SparseSolver> SparseSolver::factor(const Matrix& matrix) {
  VOLUTE_CHECK(matrix.rows() == matrix.cols() && matrix.isCompressed(), matrix.rows(), matrix.cols());
  auto factor = std::make_unique<Factor>();
  factor->rows = static_cast<std::size_t>(matrix.rows());
  cholmod_sparse view = view_of(matrix);
  factor->symbolic_and_numbers = cholmod_analyze(&view, &factor->common);
  if (auto checked = factor->check("analysing"); !checked) return tl::unexpected(checked.error());
  SparseSolver out(std::move(factor));
  if (auto done = out.refactor(matrix); !done) return tl::unexpected(done.error());
  return out;
}

Result<void> SparseSolver::refactor(const Matrix& matrix) {
  VOLUTE_CHECK(static_cast<std::size_t>(matrix.rows()) == factor_->rows && matrix.isCompressed(), matrix.rows());
  hold_to_one_thread();
  cholmod_sparse view = view_of(matrix);
  cholmod_factorize(&view, factor_->symbolic_and_numbers, &factor_->common);
  return factor_->check("factorising");
}

Eigen::VectorXd SparseSolver::solve(const Eigen::VectorXd& right_side) const {
  VOLUTE_CHECK(static_cast<std::size_t>(right_side.size()) == factor_->rows, right_side.size(), factor_->rows);
  const cholmod_dense& x = factor_->solve(right_side.data(), 1);
  return Eigen::Map<const Eigen::VectorXd>(static_cast<const double*>(x.x), right_side.size());
}

Eigen::MatrixXd SparseSolver::solve(const Eigen::MatrixXd& right_sides) const {
  VOLUTE_CHECK(static_cast<std::size_t>(right_sides.rows()) == factor_->rows, right_sides.rows(), factor_->rows);
  Eigen::MatrixXd out(right_sides.rows(), right_sides.cols());
  // Column by column: the work of one right-hand side stays in cache, and each column has the bytes of a single solve.
  for (Eigen::Index c = 0; c < right_sides.cols(); ++c) out.col(c) = solve(Eigen::VectorXd(right_sides.col(c)));
  return out;
}

Result<Eigen::MatrixXd> solve_with_fixed(const Matrix& matrix, std::span<const int> fixed,
                                         const Eigen::MatrixXd& values, const Eigen::MatrixXd& right_side) {
  const Eigen::Index n = matrix.rows();
  VOLUTE_CHECK(values.rows() == static_cast<Eigen::Index>(fixed.size()), values.rows(), fixed.size());
  std::vector<int> free_row(static_cast<std::size_t>(n), 0);
  for (int row : fixed) free_row[static_cast<std::size_t>(row)] = -1;
  int free_count = 0;
  for (int& row : free_row) row = row < 0 ? -1 : free_count++;

  Eigen::MatrixXd out = Eigen::MatrixXd::Zero(n, values.cols());
  for (std::size_t i = 0; i < fixed.size(); ++i) out.row(fixed[i]) = values.row(static_cast<Eigen::Index>(i));
  if (free_count == 0) return out;

  Eigen::MatrixXd load = -(matrix * out);
  if (right_side.size() > 0) load += right_side;
  std::vector<int> free_rows;
  for (int r = 0; r < n; ++r) {
    if (free_row[static_cast<std::size_t>(r)] >= 0) free_rows.push_back(r);
  }
  const Matrix reduced = by_columns(free_count, free_count, [&](Eigen::Index column, ColumnSum& sum) {
    for (Matrix::InnerIterator it(matrix, free_rows[static_cast<std::size_t>(column)]); it; ++it) {
      if (const int row = free_row[static_cast<std::size_t>(it.row())]; row >= 0) sum.add(row, it.value());
    }
  });
  Eigen::MatrixXd reduced_load(free_count, values.cols());
  for (int r = 0; r < free_count; ++r) reduced_load.row(r) = load.row(free_rows[static_cast<std::size_t>(r)]);
  auto solver = SparseSolver::factor(reduced);
  if (!solver) return tl::unexpected(solver.error());
  const Eigen::MatrixXd x = solver->solve(reduced_load);
  for (int r = 0; r < free_count; ++r) out.row(free_rows[static_cast<std::size_t>(r)]) = x.row(r);
  return out;
}

}  // namespace volute::planner
