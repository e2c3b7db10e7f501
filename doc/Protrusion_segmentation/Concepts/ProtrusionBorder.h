/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

The concept `ProtrusionBorder` describes the requirements on a border method: what finds the border between a
protrusion and what it sticks out of, and by it splits a surface into segments. A model holds the options of
the method and is used by the functions of this package alone.

The types that it works with are those of the implementation, in the namespace `internal`: a
`Nested_segments` holds the segment of every face and from which segment each was cut, and begins with one
segment per connected component; a `Monitor` knows the visitor and stops the segmentation. They may change from
release to release, unlike those of a `ProtrusionDistance`.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Protrusion_segmentation::Minimum_cut_method}
\cgalHasModels{CGAL::Protrusion_segmentation::Histogram_method}
\cgalHasModelsEnd
*/
class ProtrusionBorder
{
public:
  /*!
  segments a surface.

  \tparam Distance a model of `ProtrusionDistance`
  \tparam Visitor a model of `ProtrusionSegmentationVisitor`

  \param surface the whole surface, of any number of connected components
  \param distance the distance by which tips are selected
  \param number_of_segments the number of segments, which a method may not reach; if it is not set, there are as
         many as there are evident protrusions
  \param monitor to be told what is found, and to be asked by `check()` between two steps

  \return the segments, each of them connected
  */
  template <typename Distance, typename Visitor>
  CGAL::Protrusion_segmentation::internal::Nested_segments
  segment(const CGAL::Protrusion_segmentation::Indexed_surface& surface,
          const Distance& distance,
          std::optional<std::size_t> number_of_segments,
          CGAL::Protrusion_segmentation::internal::Monitor<Visitor>& monitor) const;

  /*!
  cuts off the protrusions of given tips.

  \param surface the whole surface
  \param distance the distance by which borders are found
  \param tips faces of `surface`
  \param monitor as for `segment()`

  \return the segments, each of them connected, at most one for each tip and one for each component
  */
  template <typename Distance, typename Visitor>
  CGAL::Protrusion_segmentation::internal::Nested_segments
  segment_from_tips(const CGAL::Protrusion_segmentation::Indexed_surface& surface,
                    const Distance& distance,
                    const std::vector<CGAL::Protrusion_segmentation::Indexed_surface::Index>& tips,
                    CGAL::Protrusion_segmentation::internal::Monitor<Visitor>& monitor) const;
};
