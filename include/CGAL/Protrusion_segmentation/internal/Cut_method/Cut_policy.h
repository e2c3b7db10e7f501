// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_POLICY_H
#define CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_POLICY_H

#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_clues.h>
#include <CGAL/Protrusion_segmentation/internal/Cut_method/Cut_weights.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace CGAL {
namespace Protrusion_segmentation {
namespace internal {

// What a cut costs and what it is worth: the decisions of the method, in one place. The quality benchmark
// overrides single ones to measure what they bring.
//
// The constants were chosen on half of the development models of the Princeton benchmark; lengths are in units
// of the square root of the area of the surface.
class Cut_policy
{
public:
  virtual ~Cut_policy() = default;

  // What a cut costs along an edge. One along a seam of concave curvature c costs
  // least + (1 - least) exp(-decay c) per unit of length; all three constants lie on plateaus.
  virtual double cost(double border_length, double curvature) const
  {
    constexpr double least_cost = 0.02;
    constexpr double cost_decay = 0.1;
    constexpr double convex_share = 0.2; // a ridge is a better border than a flat place, but not by much
    const double strength = curvature > 0 ? curvature : -curvature * convex_share;
    return border_length * (least_cost + (1 - least_cost) * std::exp(-cost_decay * strength));
  }

  // By how much one radian of concave angle lengthens an arc. Between .15 and .4 the result is the same, but the
  // candidates get better.
  virtual double length_of_angle() const { return 0.4; }

  // How many regions that hang together are candidates in a segment, beside ten level sets. The Rand index error on the
  // development models of the Princeton benchmark is .088 with none and .086 with eight; six or twelve are as good.
  virtual std::size_t number_of_regions() const
  {
    constexpr std::size_t number_of_regions = 8;
    return number_of_regions;
  }

  // Of a candidate and the minimum cut near it, the cheaper one, by their relative costs.
  virtual bool prefers_minimum_cut(double cost_of_candidate, double cost_of_minimum_cut) const
  {
    return cost_of_minimum_cut < cost_of_candidate;
  }

  // How many sets of cuts are kept while segments are added. With more, errors of the value are exploited: the Rand
  // index error on the development models of the Princeton benchmark is .089 with three, and no lower with five.
  virtual std::size_t number_of_sets() const
  {
    constexpr std::size_t number_of_sets = 3;
    return number_of_sets;
  }

  // The share of the area of both that two segments have in common if the one that is searched later takes over the cuts of the
  // other one. On the development models of the Princeton benchmark, in the mean over three orders of the disks, the Rand index
  // error is .0876 and .0902 (with and without a number of segments) if only segments that are cut off from such a one do so,
  // with .9 it is .0890 and .0901, with .85 .0885 and .0914 in four fifths of the time, with .8 .0892 and .0916. With another
  // set of meshes errors do not change. With 1 every segment is searched.
  virtual double least_overlap_of_copies() const
  {
    constexpr double least_overlap_of_copies = 0.85;
    return least_overlap_of_copies;
  }

  // What a cut is taken to be worth at most, relative to the area of its segment, before this is searched. None is worth more
  // than half, but hardly one as much as this. With .5, errors are the same within .0002, and a fifteenth more time is needed.
  virtual double largest_relative_value() const
  {
    constexpr double largest_relative_value = 0.4;
    return largest_relative_value;
  }

  // Whether a border becomes a minimum cut once more when it gets to the faces.
  virtual bool moves_borders_on_faces() const { return true; }

  // How much speaks for a cut, as the logarithm of odds.
  virtual double log_odds(const Cut_clues& clues) const { return Cut_weights()(clues); }
};

// The same where nobody asks for a number of segments. Then a hill, a scale of a shell or a pocket is no protrusion, however
// deep the seam around it is: it faces one way as a whole. With these two the Rand index error on the development models of the
// Princeton benchmark is .0874, without .0880, and the cut discrepancy .161 for .175; with a weight of 8, or limits up to .7,
// they are .0873 to .0879 and .160 to .161. Of other meshes, terrain, a mushroom and the shell of a turtle stay in one piece.
// With a number of segments, where flat ones are welcome if nothing else is left, errors do not change.
//
// Besides, shoulders count twice as much, and a cut without any needs more to speak for it. Fewer trunks of animals are cut
// into bands then, and segments are as steady; on the Princeton benchmark errors are .090 and .093 for .088 and .093.
class Evident_cut_policy : public Cut_policy
{
public:
  double log_odds(const Cut_clues& clues) const override
  {
    constexpr double largest_flatness = 0.6;
    constexpr double weight_of_flatness = 12;
    return m_weights(clues) - weight_of_flatness * (std::max)(0., clues.flatness - largest_flatness);
  }

private:
  // Of 59 meshes from elsewhere a koala keeps its band with a weight of 6, a cow its two with a weight of 7, each with a bias
  // that gives the same sum at a shoulder of .2. A bias of -2.6 brings them back; -2.8 is as good within chance.
  static Cut_weights weights_without_number()
  {
    Cut_weights weights;
    weights.bias = -3;
    weights.larger_shoulder = 8;
    weights.largest_larger_shoulder = 0.3;
    return weights;
  }

  Cut_weights m_weights = weights_without_number();
};

inline double logistic(double log_odds)
{
  return 1 / (1 + std::exp(-log_odds));
}

// The probability that people put two points on different sides of a border into different segments. The odds that cuts are
// chosen by promise more: the best of many cuts is the most overestimated one. But they choose better than odds that are
// right on average, by which large cuts of little evidence would be preferred. Both constants were fitted by
// `border_probabilities` of the quality benchmark.
inline double probability_of_border(double log_odds)
{
  constexpr double probability_bias = 0.53;
  constexpr double probability_slope = 0.25;
  return logistic(probability_bias + probability_slope * log_odds);
}

inline const Cut_policy& default_cut_policy()
{
  static const Cut_policy policy;
  return policy;
}

inline const Cut_policy& evident_cut_policy()
{
  static const Evident_cut_policy policy;
  return policy;
}

} // namespace internal
} // namespace Protrusion_segmentation
} // namespace CGAL

#endif // CGAL_PROTRUSION_SEGMENTATION_INTERNAL_CUT_METHOD_CUT_POLICY_H
