// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The paper's method, whole, on bodies whose parts are known, and what its result depends on.

#include "segmentations.h"
#include "test_meshes.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

using namespace test_meshes;
using namespace CGAL::Protrusion_segmentation;

using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;

Segmentation paper_segmentation(const Test_mesh& mesh, std::size_t k)
{
  return paper_segmentation(to_graph<Mesh>(mesh), k);
}

void check_parts(const Test_mesh& mesh, double least_share)
{
  check_parts(mesh, paper_segmentation(mesh, number_of_parts(mesh)), least_share);
}

// The rest of the share is the width of the borders, which lie where the fillets end. (Where arms are
// thick, planes through the body that meet other arms mislead the histogram of diameters.)
void the_arms_of_a_star_are_cut_off()
{
  for (const std::size_t arms : {3, 5})
    check_parts(star(arms, 2, 0.1, 0.04, 0.1), 0.97);
  check_parts(star(3, 1, 0.15, 0.04, 0.15), 0.97);
}

void the_limbs_of_a_creature_are_cut_off()
{
  check_parts(creature(), 0.9);
}

void balls_are_cut_off_sticks()
{
  check_parts(capsule_with_ball(0.15), 0.98);
  check_parts(dumbbell(1, 1, 0.1), 0.98);
}

void protrusions_of_protrusions_are_cut_off()
{
  Segmentation_record<Mesh> record;
  const Segmentation found = paper_segmentation(to_graph<Mesh>(body_with_hands()), 12,
                                                CGAL::parameters::visitor(std::ref(record)));
  std::set<std::size_t> parents;
  for (const auto& protrusion : record.protrusions())
    parents.insert(protrusion.parent);
  std::cout << found.number << " segments of a body with hands, cut from " << parents.size()
            << " others\n";
  CGAL_CHECK(parents.size() > 1);
}

void a_smaller_number_of_segments_is_kept_to()
{
  const Test_mesh mesh = star(5, 1, 0.15, 0.04, 0.2);
  for (std::size_t k = 1; k <= 6; ++k)
    CGAL_CHECK_EQUAL(paper_segmentation(mesh, k).number, k);
}

Labels labels_of(const Test_mesh& mesh)
{
  return paper_segmentation(mesh, number_of_parts(mesh)).labels;
}

// Bodies without ties, cheap to mesh.
const std::vector<Test_mesh>& bodies()
{
  static const std::vector<Test_mesh> the_bodies = {star(4, 2, 0.15, 0.04, 0.2), creature(0.2),
                                                    bumpy_sphere(4, 3)};
  return the_bodies;
}

void scaling_by_powers_of_two_changes_nothing()
{
  for (const Test_mesh& mesh : bodies())
    for (const double factor : {std::ldexp(1., -900), 0.5, 4., std::ldexp(1., 900)})
      CGAL_CHECK(labels_of(scaled(mesh, factor)) == labels_of(mesh));
}

// 90 degrees about an axis: coordinates change places and signs, but no digit.
Test_mesh with_turned_axes(const Test_mesh& mesh, std::size_t turns)
{
  return transformed(mesh,
                     [turns](const Point& p)
                     {
                       const Point shifted = {p[turns % 3], p[(turns + 1) % 3], p[(turns + 2) % 3]};
                       return turns < 3 ? shifted : Point{-shifted[1], shifted[0], shifted[2]};
                     });
}

void motions_give_the_same_partition()
{
  for (const Test_mesh& mesh : bodies())
  {
    const Labels expected = as_partition(labels_of(mesh));
    for (std::size_t turns = 1; turns < 6; ++turns)
      CGAL_CHECK(as_partition(labels_of(with_turned_axes(mesh, turns))) == expected);
    CGAL_CHECK(as_partition(labels_of(rotated(mesh, {1, 2, 3}, 1))) == expected);
    CGAL_CHECK(as_partition(labels_of(rotated(mesh, {-2, 1, 0.5}, 2.5))) == expected);
    CGAL_CHECK(as_partition(labels_of(translated(mesh, {10, -20, 5}))) == expected);
    CGAL_CHECK(as_partition(labels_of(scaled(mesh, 1.7))) == expected);
  }
}

void the_orientation_does_not_matter()
{
  for (const Test_mesh& mesh : bodies())
    CGAL_CHECK(as_partition(labels_of(with_reversed_orientation(mesh))) == as_partition(labels_of(mesh)));
}

// Nor the numbers of the segments, nor where symmetry makes everything a tie.
void the_order_of_the_faces_does_not_matter()
{
  std::vector<Test_mesh> meshes = bodies();
  meshes.push_back(icosphere(3));
  meshes.push_back(merged({translated(star(6), {9, 0, 0}), star(6), translated(star(6), {-9, 0, 0})}));
  for (const Test_mesh& mesh : meshes)
  {
    const Labels expected = labels_of(mesh);
    for (std::uint_fast32_t seed = 0; seed < 3; ++seed)
    {
      const std::vector<std::size_t> order = random_permutation(mesh.faces.size(), seed);
      const Labels found = labels_of(with_face_order(mesh, order));
      Labels in_old_order(found.size());
      for (std::size_t f = 0; f < found.size(); ++f)
        in_old_order[order[f]] = found[f];
      CGAL_CHECK(in_old_order == expected);
    }
  }
}

void repeated_calls_give_the_same_labels()
{
  for (const Test_mesh& mesh : bodies())
    CGAL_CHECK(labels_of(mesh) == labels_of(mesh));
}

int main()
{
  the_arms_of_a_star_are_cut_off();
  the_limbs_of_a_creature_are_cut_off();
  balls_are_cut_off_sticks();
  protrusions_of_protrusions_are_cut_off();
  a_smaller_number_of_segments_is_kept_to();
  scaling_by_powers_of_two_changes_nothing();
  motions_give_the_same_partition();
  the_orientation_does_not_matter();
  the_order_of_the_faces_does_not_matter();
  repeated_calls_give_the_same_labels();
  return check::result();
}
