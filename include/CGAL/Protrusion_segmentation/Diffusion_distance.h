// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_DIFFUSION_DISTANCE_H
#define CGAL_PROTRUSION_SEGMENTATION_DIFFUSION_DISTANCE_H

#if (defined(CGAL_EIGEN3_ENABLED) && __has_include(<Spectra/SymEigsSolver.h>)) || defined(DOXYGEN_RUNNING)

#include <CGAL/Protrusion_segmentation/Execution.h>
#include <CGAL/Protrusion_segmentation/Indexed_surface.h>
#include <CGAL/Protrusion_segmentation/internal/inline.h>

#include <Eigen/Core>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Protrusion_segmentation {

/*!
\ingroup PkgProtrusionSegmentationDistances

The diffusion distance DD of Section III.B.1 of the paper: two random walks start at the two faces; the distance
is how differently they are distributed after some time.

The walk leaves a face over an edge with a weight of the edge's length divided by the distance of the two
centroids. It stays with a weight of 50 times the area of the face, where the mean area of all faces is 1. So
it spreads as heat does, independently of the sizes of the faces and of the scale of the mesh. Let \f$W\f$ be the symmetric matrix of these weights, \f$D\f$ the diagonal matrix of its row sums
\f$d_i\f$, \f$P = D^{-1} W\f$, and \f$p_t(i, z)\f$ the entry of \f$P^t\f$ in row \f$i\f$ and column \f$z\f$. The squared
distance after \f$t\f$ steps is

\f[ \sum_z (p_t(i, z) - p_t(j, z))^2 \, w(z) = \sum_{k \geq 1} \lambda_k^{2t} (\psi_k(i) - \psi_k(j))^2 \f]

with \f$w(z) = \sum_k d_k / d_z\f$, the inverse of the walk's stationary distribution. Here \f$\psi_k\f$ are the right
eigenvectors of \f$P\f$, with a mean square of 1 under the stationary distribution; the trivial one, \f$\psi_0 = 1\f$, is
left out. The first few terms of the right sum make up the distance. All terms of an eigenvalue are taken or none, since
single eigenvectors of a multiple eigenvalue are not determined.

The unit of the number of steps is the time in which the slowest term decays, \f$1 / \ln(1 / \lambda_1)\f$
steps. So the distance hardly depends on the number of faces of a shape.

Preparing the distances on a surface costs one sparse factorization and some dozen solutions with it, about linear
time in practice; then the distances from a face take linear time per eigenpair. The memory is about 30
numbers per face and eigenpair.

The header needs the libraries Eigen and Spectra.

\cgalModels{ProtrusionDistance}
*/
class Diffusion_distance
{
public:
  /// the distances on one surface
  /// \cgalModels{ProtrusionDistancesOnSurface}
  class On_surface
  {
  public:
    /// computes the eigenpairs of a surface.
    /// \param surface the surface, which must outlive the object
    /// \param number_of_eigenpairs the number of terms, above 0
    /// \param time 0 or above
    /// \param execution asked whether to go on, which must outlive the object
    On_surface(const Indexed_surface& surface,
               std::size_t number_of_eigenpairs,
               double time,
               Execution& execution);

    /// computes the distances from a face.
    /// \param source the face
    /// \param distances is filled with the distances of all faces
    void operator()(Indexed_surface::Index source, std::vector<double>& distances);
    /// \return the face of eq. (1), found exactly: the distance is a metric
    Indexed_surface::Index face_of_largest_sum();
    /// \return from how many faces distances were computed so far
    std::size_t number_of_runs() const { return m_number_of_runs; }

    /// \return the number of terms: fewer than asked for if the surface has too few faces, more if the last one's
    /// eigenvalue is a multiple one
    std::size_t number_of_eigenpairs() const { return static_cast<std::size_t>(m_points.rows()); }

  private:
    const Indexed_surface& m_surface;
    Execution& m_execution;
    Eigen::MatrixXd m_points; // of each face its coordinates, whose Euclidean distances are the distances
    std::size_t m_number_of_runs = 0;
  };

  /// \return 300: further terms are no larger than the errors of the solver
  static constexpr std::size_t maximum_number_of_eigenpairs() { return 300; }
  /// \return 10, the larger of the numbers in Table I of the paper, DD(10)
  static constexpr std::size_t default_number_of_eigenpairs() { return 10; }
  /// \return 0.5, which has the least Rand index error on the development models of the Princeton benchmark
  static constexpr double default_time() { return 0.5; }

  /// `number_of_eigenpairs` terms after `time` relaxation times of the random walk: \f$t\f$ = `time` /
  /// \f$\ln(1 / \lambda_1)\f$ steps. At time 0 all terms have the same weight; with time the
  /// distance approaches a multiple of the difference in \f$\psi_1\f$.
  /// \param number_of_eigenpairs the number of terms, from 1 to `maximum_number_of_eigenpairs()`
  /// \param time 0 or above
  /// \throw std::invalid_argument if `number_of_eigenpairs` is out of range, or `time` is negative or not finite
  explicit Diffusion_distance(std::size_t number_of_eigenpairs = default_number_of_eigenpairs(),
                              double time = default_time())
    : m_number_of_eigenpairs(number_of_eigenpairs), m_time(time)
  {
    if (number_of_eigenpairs == 0 || number_of_eigenpairs > maximum_number_of_eigenpairs())
      throw std::invalid_argument("Diffusion_distance: number_of_eigenpairs is " + std::to_string(number_of_eigenpairs) +
                                  ", but it must be from 1 to " + std::to_string(maximum_number_of_eigenpairs()));
    if (!(time >= 0 && std::isfinite(time)))
      throw std::invalid_argument("Diffusion_distance: time is negative or not finite");
  }

  /// computes the eigenpairs of a surface.
  /// \param surface the surface, which must outlive the result
  /// \param execution asked whether to go on, which must outlive the result
  /// \return the distances on it
  /// \throw std::runtime_error if the eigenvalue solver does not converge
  On_surface on(const Indexed_surface& surface, Execution& execution) const
  {
    return On_surface(surface, m_number_of_eigenpairs, m_time, execution);
  }

private:
  std::size_t m_number_of_eigenpairs;
  double m_time;
};

} // namespace CGAL::Protrusion_segmentation

#if !defined(DOXYGEN_RUNNING) && !defined(CGAL_PROTRUSION_SEGMENTATION_COMPILED_DISTANCES)

#include <CGAL/Protrusion_segmentation/internal/Distances/Largest_sum/largest_distance_sum.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/diffusion_map.h>

namespace CGAL::Protrusion_segmentation {

CGAL_PROTRUSION_SEGMENTATION_INLINE
Diffusion_distance::On_surface::On_surface(const Indexed_surface& surface,
                                           std::size_t number_of_eigenpairs,
                                           double time,
                                           Execution& execution)
  : m_surface(surface), m_execution(execution)
{
  const internal::Random_walk walk = internal::make_random_walk(surface);
  const internal::Eigenpairs pairs = internal::eigenpairs(walk, number_of_eigenpairs, execution);
  const Eigen::Index size = static_cast<Eigen::Index>(pairs.size());
  m_points.resize(size, surface.number_of_faces());
  for (Eigen::Index k = 0; k < size; ++k)
    m_points.row(k) = internal::decay(pairs.values, static_cast<std::size_t>(k), time) *
                      internal::right_eigenvector(walk, pairs.vectors[static_cast<std::size_t>(k)]);
}

CGAL_PROTRUSION_SEGMENTATION_INLINE void
Diffusion_distance::On_surface::operator()(Indexed_surface::Index source, std::vector<double>& distances)
{
  ++m_number_of_runs;
  distances.resize(m_surface.number_of_faces());
  const Eigen::VectorXd from = m_points.col(source);
  for (Indexed_surface::Index f = 0; f < m_surface.number_of_faces(); ++f)
    distances[f] = (m_points.col(f) - from).norm();
}

CGAL_PROTRUSION_SEGMENTATION_INLINE Indexed_surface::Index
Diffusion_distance::On_surface::face_of_largest_sum()
{
  return internal::largest_distance_sum(m_surface, *this, m_execution);
}

} // namespace CGAL::Protrusion_segmentation

#endif

#else // without Eigen or Spectra, the header compiles, and its use says what is missing

#include <CGAL/Default.h>

#include <type_traits>

namespace CGAL::Protrusion_segmentation {

template <typename Spectra = Default>
class Diffusion_distance
{
public:
  template <typename... Arguments>
  explicit Diffusion_distance(const Arguments&...)
  {
    static_assert(!std::is_same<Spectra, Default>::value,
                  "Diffusion_distance needs CGAL with Eigen, and Spectra (Debian: libspectra-dev): link with "
                  "CGAL::Eigen3_support, or request the component Spectra of Protrusion_segmentation");
  }
};

} // namespace CGAL::Protrusion_segmentation

#endif // CGAL_EIGEN3_ENABLED and Spectra

#endif // CGAL_PROTRUSION_SEGMENTATION_DIFFUSION_DISTANCE_H
