// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The diffusion distance (Section III.B.1) against its definition by powers of the transition matrix,
// and its eigenpairs against a dense solver.

#include "check.h"
#include "indexed_surfaces.h"
#include "test_distances.h"
#include "test_meshes.h"

#include <CGAL/Protrusion_segmentation/Diffusion_distance.h>
#include <CGAL/Protrusion_segmentation/internal/Distances/diffusion_map.h>

#include <Eigen/Dense>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Matrix = Eigen::MatrixXd;

// What the walk gets its weights from, straight from the documentation. For meshes without tiny lengths.
Matrix transition_matrix(const Indexed_surface& surface)
{
  const Eigen::Index n = surface.number_of_faces();
  Matrix w = Matrix::Zero(n, n);
  for (Index f = 0; f < n; ++f)
  {
    w(f, f) += 50 * surface.area(f) / (surface.area() / double(n));
    for (Index c = surface.first_corner(f); c < surface.first_corner(f + 1); ++c)
      if (const Index g = surface.neighbor(c); g != Indexed_surface::no_face())
        w(f, g) += surface.edge_length(f, c) /
                   std::sqrt(squared_distance(surface.centroid(f), surface.centroid(g)));
  }
  CGAL_CHECK(w.isApprox(w.transpose()));
  return w.array().colwise() / w.rowwise().sum().array();
}

// The stationary distribution, from the definition of one: pi P = pi.
Eigen::VectorXd stationary_distribution(const Matrix& p)
{
  Matrix power = p;
  for (int i = 0; i < 60; ++i)
    power = (power * power).eval();
  return power.row(0).transpose() / power.row(0).sum();
}

// All distances after t steps, from the definition. `p_t` is P^t.
Matrix distances_by_definition(const Matrix& p_t, const Eigen::VectorXd& stationary)
{
  Matrix d(p_t.rows(), p_t.rows());
  for (Eigen::Index i = 0; i < d.rows(); ++i)
    for (Eigen::Index j = 0; j < d.rows(); ++j)
      d(i, j) = std::sqrt(
        ((p_t.row(i) - p_t.row(j)).array().square() / stationary.transpose().array()).sum());
  return d;
}

Matrix all_distances(const Indexed_surface& surface, std::size_t number_of_eigenpairs, double time)
{
  auto distances = Diffusion_distance(number_of_eigenpairs, time).on(surface, quiet_execution());
  Matrix d(surface.number_of_faces(), surface.number_of_faces());
  std::vector<double> row;
  for (Index f = 0; f < surface.number_of_faces(); ++f)
  {
    distances(f, row);
    d.row(f) = Eigen::Map<const Eigen::RowVectorXd>(row.data(), d.cols());
  }
  return d;
}

double second_eigenvalue(const Indexed_surface& surface)
{
  return 1 - internal::dense_eigenpairs(internal::make_random_walk(surface), 1).values.front();
}

double largest_difference(const Matrix& a, const Matrix& b)
{
  return (a - b).cwiseAbs().maxCoeff();
}

std::vector<Test_mesh> small_meshes()
{
  return {tetrahedron(),       box(),
          box(2, 1, 1),        icosahedron(),
          dodecahedron(),      football(),
          sheet(5, 4),         torus(2, 0.5, 12, 6),
          pierced_plate(2, 1), regular_prism(7),
          l_prism(),           thin_strip(9, 0.1),
          moebius_strip(16),   random_surface(1),
          random_surface(2),   random_surface(3)};
}

// All eigenpairs: the sum over them is the sum over all faces.
void eigenpairs_give_the_distances_of_the_definition()
{
  for (const Test_mesh& mesh : small_meshes())
  {
    const Indexed_surface surface = to_surface(mesh);
    const Matrix p = transition_matrix(surface);
    const Eigen::VectorXd stationary = stationary_distribution(p);
    Matrix p_t = Matrix::Identity(p.rows(), p.rows());
    for (int t = 0; t <= 40; ++t, p_t = (p_t * p).eval())
      if (t < 4 || t % 10 == 0)
      {
        const double time = -t * std::log(second_eigenvalue(surface));
        CGAL_CHECK_CLOSE(largest_difference(all_distances(surface, mesh.faces.size(), time),
                                       distances_by_definition(p_t, stationary)),
                    0, 1e-8);
      }
  }
}

// At time 0, where all terms count alike, two faces are as far apart as w(i) + w(j) tells, whatever
// lies between them.
void at_time_0_all_terms_add_up_to_a_formula()
{
  const Indexed_surface surface = to_surface(random_surface(5));
  const Eigen::VectorXd stationary = stationary_distribution(transition_matrix(surface));
  const Matrix d = all_distances(surface, surface.number_of_faces(), 0);
  for (Eigen::Index i = 0; i < d.rows(); ++i)
    for (Eigen::Index j = 0; j < d.rows(); ++j)
      CGAL_CHECK_CLOSE(d(i, j), i == j ? 0 : std::sqrt(1 / stationary[i] + 1 / stationary[j]), 1e-8);
}

// After a long time only the slowest term is left, a difference on a line.
void at_a_large_time_the_slowest_term_is_left()
{
  const Indexed_surface surface = to_surface(star(1));
  const double time = 40;
  const Matrix one = all_distances(surface, 1, time), ten = all_distances(surface, 10, time);
  CGAL_CHECK(one.maxCoeff() > 0);
  CGAL_CHECK_CLOSE(largest_difference(one, ten), 0, 1e-6 * one.maxCoeff());
  CGAL_CHECK_EQUAL(all_distances(surface, 10, 1e6).maxCoeff(), 0);
}

void check_residuals(const Indexed_surface& surface, const internal::Eigenpairs& pairs)
{
  const internal::Random_walk walk = internal::make_random_walk(surface);
  for (std::size_t k = 0; k < pairs.size(); ++k)
  {
    const Eigen::VectorXd& v = pairs.vectors[k];
    CGAL_CHECK_CLOSE((walk.laplacian * v - pairs.values[k] * v).norm(), 0, 1e-8);
    CGAL_CHECK_CLOSE(walk.degrees.cwiseSqrt().normalized().dot(v), 0, 1e-8);
    for (std::size_t l = 0; l <= k; ++l)
      CGAL_CHECK_CLOSE(v.dot(pairs.vectors[l]), k == l ? 1 : 0, 1e-8);
  }
}

// Also where eigenvalues are multiple, of which Lanczos methods miss copies.
void sparse_eigenpairs_are_those_of_a_dense_solver()
{
  for (const Test_mesh& mesh :
       {box(7, 7, 7), icosphere(2), dumbbell(1, 1, 0.3, 3, 0.4), torus(2, 0.5, 24, 12), sheet(18, 18),
        bumpy_sphere(2, 1), height_field(12, 12, 1), merged({icosphere(2), icosphere(2)})})
  {
    const Indexed_surface surface = to_surface(mesh);
    const internal::Random_walk walk = internal::make_random_walk(surface);
    const internal::Eigenpairs dense = internal::dense_eigenpairs(walk, mesh.faces.size());
    for (std::size_t count : {1, 2, 5, 10})
    {
      const internal::Eigenpairs sparse = internal::sparse_eigenpairs(walk, count, quiet_execution(),
                                                                      1000);
      CGAL_CHECK_EQUAL(sparse.size(), internal::count_with_multiplicity(dense.values, count));
      CGAL_CHECK(sparse.size() >= count);
      for (std::size_t k = 0; k < (std::min)(sparse.size(), dense.size()); ++k)
        CGAL_CHECK_CLOSE(sparse.values[k], dense.values[k], 1e-8 * dense.values[k] + 1e-12);
      check_residuals(surface, sparse);
    }
  }
}

// A cube's eigenvalues are up to three-fold; a turned cube with faces in another order has the same
// distances all the same.
void symmetry_does_not_matter()
{
  const Test_mesh cube = box(9, 9, 9);
  const std::vector<std::size_t> order = random_permutation(cube.faces.size(), 4);
  const Indexed_surface surface = to_surface(cube);
  const Indexed_surface turned = to_surface(with_face_order(rotated(cube, {1, 2, 3}, 1), order));
  for (std::size_t count : {1, 2, 3, 5, 7})
  {
    const Matrix a = all_distances(surface, count, 0.3), b = all_distances(turned, count, 0.3);
    double largest = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = 0; j < order.size(); ++j)
        largest = (std::max)(largest, std::abs(b(Eigen::Index(i), Eigen::Index(j)) -
                                             a(Eigen::Index(order[i]), Eigen::Index(order[j]))));
    CGAL_CHECK_CLOSE(largest, 0, 1e-7 * a.maxCoeff());
  }
}

void scale_does_not_matter()
{
  const Matrix expected = all_distances(to_surface(random_surface(6)), 8, 0.5);
  for (double factor : {1e-6, 3., 1e6})
    CGAL_CHECK_CLOSE(
      largest_difference(all_distances(to_surface(scaled(random_surface(6), factor)), 8, 0.5), expected),
      0, 1e-7 * expected.maxCoeff());
}

// The same shape with four times as many faces.
void tessellation_hardly_matters()
{
  const auto extent = [](const Test_mesh& mesh)
  { return all_distances(to_surface(mesh), 10, 0.5).maxCoeff(); };
  const double coarse = extent(capsule_with_ball(0.3, 3, 0.8, 0.2));
  const double fine = extent(capsule_with_ball(0.3, 3, 0.8, 0.1));
  CGAL_CHECK_CLOSE(fine, coarse, 0.1 * coarse);
}

// Eigenvalue 1 is double; the second pair tells the components apart at every time.
void components_are_apart()
{
  for (std::size_t levels : {0, 2})
  {
    const Test_mesh ball = icosphere(levels);
    const Indexed_surface surface = to_surface(merged({ball, translated(ball, {5, 0, 0})}));
    const Index n = Index(ball.faces.size());
    for (double time : {0., 1., 100.})
    {
      const Matrix d = all_distances(surface, 1, time);
      CGAL_CHECK_CLOSE(d(0, n - 1), 0, 1e-6);
      CGAL_CHECK_CLOSE(d(0, n), 2, 1e-6); // psi is 1 on the one and -1 on the other
    }
  }
}

// Where nothing holds the walk in a face, it may forget all in a step, or alternate for ever.
void walks_that_do_not_rest_have_finite_distances()
{
  CGAL_CHECK_CLOSE(internal::decay({1., 1.5}, 0, 0.5), std::exp(-0.5), 1e-12);
  CGAL_CHECK_CLOSE(internal::decay({2.}, 0, 0.5), std::exp(-0.5), 1e-12);
  Test_mesh needles;
  needles.points = {{0, 0, 0}, {1, 0, 0}, {0.5, 1e-40, 0}, {0.5, -1e-40, 0}};
  needles.add_face({0, 1, 2});
  needles.add_face({1, 0, 3});
  CGAL_CHECK(all_distances(to_surface(needles), 10, 0.5).allFinite());
}

void tiny_surfaces_have_the_pairs_that_there_are()
{
  const auto pairs = [](const Test_mesh& mesh)
  { return Diffusion_distance(10).on(to_surface(mesh), quiet_execution()).number_of_eigenpairs(); };
  CGAL_CHECK_EQUAL(pairs(Test_mesh()), 0);
  CGAL_CHECK_EQUAL(pairs(single_triangle()), 0);
  CGAL_CHECK_EQUAL(pairs(thin_strip(1)), 1);
  CGAL_CHECK_EQUAL(pairs(tetrahedron()), 3);
  CGAL_CHECK(pairs(star(4)) >= 10);
}

void failure_of_the_solver_is_reported()
{
  const internal::Random_walk walk = internal::make_random_walk(to_surface(bumpy_sphere(4, 2)));
  CGAL_CHECK_THROWS_WITH(internal::sparse_eigenpairs(walk, 60, quiet_execution(), 1), std::runtime_error,
                    "did not converge");
}

void impossible_options_are_refused()
{
  CGAL_CHECK_THROWS_WITH(Diffusion_distance(0), std::invalid_argument, "number_of_eigenpairs");
  for (double time : {-1., infinity, std::nan("")})
    CGAL_CHECK_THROWS_WITH(Diffusion_distance(5, time), std::invalid_argument, "time");
}

struct Counting_observer : internal::Observer
{
  bool go_further() override
  {
    ++questions;
    return true;
  }
  std::size_t questions = 0;
};

// Between two products of the Lanczos method there is no more than one.
void every_product_of_the_eigenvalue_solver_asks()
{
  const Indexed_surface surface = to_surface(bumpy_sphere(3, 1));
  Counting_observer observer;
  Execution execution(observer, 0, false);
  const internal::Deflated_inverse inverse(internal::make_random_walk(surface).laplacian, execution);
  std::vector<double> x(surface.number_of_faces(), 1), y(surface.number_of_faces());
  for (std::size_t i = 0; i < 3; ++i)
  {
    const std::size_t questions = observer.questions;
    inverse.perform_op(x.data(), y.data());
    CGAL_CHECK_EQUAL(observer.questions, questions + 1);
  }
}

int main()
{
  eigenpairs_give_the_distances_of_the_definition();
  at_time_0_all_terms_add_up_to_a_formula();
  at_a_large_time_the_slowest_term_is_left();
  sparse_eigenpairs_are_those_of_a_dense_solver();
  symmetry_does_not_matter();
  scale_does_not_matter();
  tessellation_hardly_matters();
  components_are_apart();
  walks_that_do_not_rest_have_finite_distances();
  tiny_surfaces_have_the_pairs_that_there_are();
  failure_of_the_solver_is_reported();
  impossible_options_are_refused();
  every_product_of_the_eigenvalue_solver_asks();
  check_is_a_metric(Diffusion_distance(), 1e-9);
  check_search_finds_the_largest_sum(Diffusion_distance(), 1e-9);
  check_survives_awkward_surfaces(Diffusion_distance());
  check_segments_stars(Diffusion_distance());
  return check::result();
}
