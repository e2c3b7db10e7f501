// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DIFFUSION_MAP_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DIFFUSION_MAP_H

#if defined(CGAL_EIGEN3_ENABLED) && __has_include(<Spectra/SymEigsSolver.h>)

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/Surface/conductance.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>
#include <Spectra/SymEigsSolver.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation::internal {

// The random walk on the faces of Section III.B.1, with transition matrix P = D^-1 W.
struct Random_walk
{
  Eigen::VectorXd degrees;               // the diagonal of D
  Eigen::SparseMatrix<double> laplacian; // I - D^-1/2 W D^-1/2: similar to I - P, but symmetric
};

// The weight of staying, for a face of mean area. The weights of leaving add up to about 5 for a regular
// triangle, whatever its size, so that this makes the walk rest nearly in proportion to the areas.
constexpr double resting_weight = 50;

// The weights W. A face is left over an edge with the weight of its conductance. To stay has a weight proportional to
// the area, so that small faces are left sooner and the walk spreads over the surface alike wherever its faces are
// small or large, as heat does; a face without area is left at once.
inline Random_walk make_random_walk(const Indexed_surface& surface)
{
  using Index = Indexed_surface::Index;
  const Index n = surface.number_of_faces();
  const double mean_area = surface.area() / n;
  const double shortest = shortest_length(surface.area(), n); // 0 if all points are equal, or nearly

  std::vector<Eigen::Triplet<double>> weights;
  weights.reserve(surface.number_of_corners() + n);
  Eigen::VectorXd leaving = Eigen::VectorXd::Zero(n);
  for (Index f = 0; f < n; ++f)
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
      {
        const double weight = shortest > 0 ? conductance(surface.edge_length(f, c), surface.arc_length(f, g), shortest) : 1;
        weights.emplace_back(f, g, -weight);
        leaving[f] += weight;
      }
  Random_walk walk;
  walk.degrees.resize(n);
  for (Index f = 0; f < n; ++f)
    walk.degrees[f] = leaving[f] + resting_weight * (mean_area > 0 ? surface.area(f) / mean_area : 1);
  for (Index f = 0; f < n; ++f)
    weights.emplace_back(f, f, leaving[f]);
  for (auto& w : weights)
    w = {w.row(), w.col(), w.value() / std::sqrt(walk.degrees[w.row()] * walk.degrees[w.col()])};
  walk.laplacian.resize(n, n);
  walk.laplacian.setFromTriplets(weights.begin(), weights.end()); // adds up edges between the same faces
  return walk;
}

// Eigenpairs of the symmetric matrix I - S that is similar to I - P: the values are 1 - lambda, which keep
// their digits where the lambdas crowd below 1. In ascending order, without the trivial pair of value 0.
struct Eigenpairs
{
  std::vector<double> values;
  std::vector<Eigen::VectorXd> vectors; // orthonormal

  std::size_t size() const { return values.size(); }

  void sort_and_keep(std::size_t count)
  {
    std::vector<std::size_t> order(size());
    std::iota(order.begin(), order.end(), std::size_t(0));
    std::stable_sort(order.begin(), order.end(),
                     [this](std::size_t a, std::size_t b) { return values[a] < values[b]; });
    Eigenpairs sorted;
    for (std::size_t k = 0; k < count; ++k)
    {
      sorted.values.push_back(values[order[k]]);
      sorted.vectors.push_back(std::move(vectors[order[k]]));
    }
    *this = std::move(sorted);
  }
};

// How many of the ascending values make up the first `count` and all that equal the last of those. Part of
// an eigenspace would not do: its basis, and with it the distance, is up to the solver.
inline std::size_t count_with_multiplicity(const std::vector<double>& values, std::size_t count)
{
  constexpr double tolerance = 1e-6; // far above the errors of the solvers, far below usual gaps
  if (count == 0 || values.size() <= count)
    return values.size() < count ? values.size() : count;
  const double bound = values[count - 1] * (1 + tolerance) + std::numeric_limits<double>::epsilon();
  return static_cast<std::size_t>(std::upper_bound(values.begin(), values.end(), bound) - values.begin());
}

// (I - S + shift)^-1 on the complement of given eigenvectors: its largest eigenvalues are the smallest of
// I - S that are not known yet. Without inversion the solver would need thousands of products, since the
// smallest eigenvalues differ by about 1 / number of faces.
class Deflated_inverse
{
public:
  using Scalar = double;

  Deflated_inverse(const Eigen::SparseMatrix<double>& laplacian, Execution& execution)
    : m_n(laplacian.rows()), m_execution(execution)
  {
    Eigen::SparseMatrix<double> identity(m_n, m_n);
    identity.setIdentity();
    const Eigen::SparseMatrix<double> matrix = laplacian + shift() * identity;
    m_factors.analyzePattern(matrix);
    m_execution.check();
    m_factors.factorize(matrix);
    m_execution.check();
    if (m_factors.info() != Eigen::Success)
      throw std::runtime_error("Diffusion_distance: the matrix of " + std::to_string(m_n) +
                               " faces cannot be factorized");
  }

  // I - S has the eigenvalue 0; the shift is as small as rounding of a factorization allows
  static constexpr double shift() { return 1e-10; }

  void deflate(const Eigen::VectorXd& eigenvector)
  {
    m_known.conservativeResize(m_n, m_known.cols() + 1);
    m_known.rightCols(1) = eigenvector;
  }

  Eigen::Index rows() const { return m_n; }
  Eigen::Index cols() const { return m_n; }
  void perform_op(const double* x, double* y) const
  {
    m_execution.check();
    Eigen::VectorXd v = Eigen::Map<const Eigen::VectorXd>(x, m_n);
    project(v);
    v = m_factors.solve(v).eval();
    project(v);
    Eigen::Map<Eigen::VectorXd>(y, m_n) = v;
  }

private:
  void project(Eigen::VectorXd& v) const { v -= m_known * (m_known.transpose() * v).eval(); }

  Eigen::Index m_n;
  Execution& m_execution;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> m_factors;
  Eigen::MatrixXd m_known = Eigen::MatrixXd(m_n, 0);
};

// Appends the `count` next eigenpairs to `pairs`.
inline void append_next_eigenpairs(Deflated_inverse& inverse,
                                   std::size_t count,
                                   std::size_t maximum_restarts,
                                   Eigenpairs& pairs)
{
  constexpr double tolerance = 1e-11; // relative, of an eigenvector's residual
  const Eigen::Index k = static_cast<Eigen::Index>(count);
  // more vectors than the usual 2 k, since here a product costs more than orthogonalization
  const Eigen::Index number_of_vectors = (std::min)(inverse.rows(), 2 * k + 20);
  Spectra::SymEigsSolver<Deflated_inverse> solver(inverse, k, number_of_vectors);
  solver.init(); // a pseudo-random vector, always the same
  solver.compute(Spectra::SortRule::LargestAlge, static_cast<Eigen::Index>(maximum_restarts), tolerance);
  if (solver.info() != Spectra::CompInfo::Successful)
    throw std::runtime_error("Diffusion_distance: the eigenvalue solver did not converge for " +
                             std::to_string(count) + " eigenpairs on " + std::to_string(inverse.rows()) +
                             " faces");
  const Eigen::VectorXd values = solver.eigenvalues();
  const Eigen::MatrixXd vectors = solver.eigenvectors();
  for (Eigen::Index i = 0; i < k; ++i)
  {
    // an eigenvalue of I - S is 2 at most; a smaller value of the inverse is that of a known eigenvector
    pairs.values.push_back(values[i] > 0.25 ? 1 / values[i] - Deflated_inverse::shift()
                                            : std::numeric_limits<double>::infinity());
    pairs.vectors.push_back(vectors.col(i));
    inverse.deflate(vectors.col(i));
  }
}

// The eigenpairs by the Lanczos method on the inverse. It may miss copies of a multiple eigenvalue; so the
// solver is asked again for what is left, until the next value is larger than all that are wanted.
inline Eigenpairs sparse_eigenpairs(const Random_walk& walk,
                                    std::size_t count,
                                    Execution& execution,
                                    std::size_t maximum_restarts)
{
  constexpr std::size_t number_of_probes = 2;
  // An eigenvalue of higher multiplicity, as of a face with hundreds of equal neighbours, is cut off there.
  constexpr std::size_t maximum_number_of_probes = 200;
  Deflated_inverse inverse(walk.laplacian, execution);
  inverse.deflate(walk.degrees.cwiseSqrt().normalized());
  Eigenpairs pairs;
  append_next_eigenpairs(inverse, count, maximum_restarts, pairs);
  std::size_t complete = 0;
  for (bool is_complete = false; !is_complete && pairs.size() < count + maximum_number_of_probes;)
  {
    const std::size_t old_size = pairs.size();
    append_next_eigenpairs(inverse, number_of_probes, maximum_restarts, pairs);
    const double next = (std::min)(pairs.values[old_size], pairs.values[old_size + 1]);
    pairs.sort_and_keep(pairs.size());
    complete = count_with_multiplicity(pairs.values, count);
    is_complete = next > pairs.values[complete - 1];
  }
  pairs.sort_and_keep(complete);
  return pairs;
}

// The trivial pair is moved to the end, beyond the largest value possible, 2: were it left in its place, it
// would be mixed with others of value 0 where the surface is not connected.
inline Eigenpairs dense_eigenpairs(const Random_walk& walk, std::size_t count)
{
  const Eigen::VectorXd trivial = walk.degrees.cwiseSqrt().normalized();
  const Eigen::MatrixXd matrix = Eigen::MatrixXd(walk.laplacian) + 3 * trivial * trivial.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(matrix);
  if (solver.info() != Eigen::Success)
    throw std::runtime_error("Diffusion_distance: the dense eigenvalue solver did not converge on " +
                             std::to_string(walk.degrees.size()) + " faces");
  Eigenpairs pairs;
  for (Eigen::Index k = 0; k + 1 < solver.eigenvalues().size(); ++k)
  {
    pairs.values.push_back(solver.eigenvalues()[k]);
    pairs.vectors.push_back(solver.eigenvectors().col(k));
  }
  pairs.sort_and_keep(count_with_multiplicity(pairs.values, count));
  return pairs;
}

// The first `count` eigenpairs or all there are; more if the last one's eigenvalue is a multiple one.
inline Eigenpairs eigenpairs(const Random_walk& walk,
                             std::size_t count,
                             Execution& execution,
                             std::size_t maximum_restarts = 1000)
{
  // dense matrices where they are faster or where Lanczos vectors would have no room
  constexpr std::size_t smallest_sparse = 100;
  const std::size_t n = static_cast<std::size_t>(walk.degrees.size());
  if (n < 2)
    return {}; // there is only the trivial pair, or none
  return n < smallest_sparse || n < 3 * count ? dense_eigenpairs(walk, count)
                                              : sparse_eigenpairs(walk, count, execution, maximum_restarts);
}

// The right eigenvector psi of P for an eigenvector of S, normalized as by Coifman and Lafon: its mean
// square under the stationary distribution, which is proportional to the degrees, is 1.
inline Eigen::RowVectorXd right_eigenvector(const Random_walk& walk, const Eigen::VectorXd& eigenvector)
{
  return (eigenvector.array() * (walk.degrees.sum() / walk.degrees.array()).sqrt()).matrix().transpose();
}

// |lambda_k|^t for as many steps t as make `time` relaxation times of the slowest term that decays at all;
// a term with eigenvalue 1 tells components apart and stays.
inline double decay(const std::vector<double>& values, std::size_t k, double time)
{
  constexpr double zero = 1e-12; // a thousandth of the smallest value on meshes of millions of faces
  // finite and above 0 also for an eigenvalue 0, gone after a step, and for -1, which alternates for ever
  const auto rate = [](double value)
  {
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    return -std::log(std::clamp(std::abs(1 - value), epsilon, 1 - epsilon));
  };
  const auto slowest =
    std::find_if(values.begin(), values.end(), [](double value) { return value > zero; });
  if (time == 0 || slowest == values.end() || values[k] <= zero)
    return 1;
  return std::exp(-time * (rate(values[k]) / rate(*slowest)));
}

} // namespace CGAL::Protrusion_segmentation::internal

#endif // CGAL_EIGEN3_ENABLED and Spectra

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_DISTANCES_DIFFUSION_MAP_H
