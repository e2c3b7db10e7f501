/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

The concept `ProtrusionDistancesOnSurface` describes the requirements on the distances between the faces of one
surface. They are computed for one source after the other, so a model may keep work arrays.

Distances should grow along the surface away from the source, as lengths do. They need not be symmetric or a metric.
They are checked: if they are not as described below, the call of the package throws `std::invalid_argument` with the
number of the face and what is wrong.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Protrusion_segmentation::Geodesic_distance::On_surface}
\cgalHasModels{CGAL::Protrusion_segmentation::Landmark_geodesic_distance::On_surface}
\cgalHasModels{CGAL::Protrusion_segmentation::Diffusion_distance::On_surface}
\cgalHasModels{CGAL::Protrusion_segmentation::Heat_distance::On_surface}
\cgalHasModels{CGAL::Protrusion_segmentation::Exact_geodesic_distance::On_surface}
\cgalHasModelsEnd

\sa `ProtrusionDistance`
*/
class ProtrusionDistancesOnSurface
{
public:
  /*!
  computes the distances from a face to all faces. The visitor is asked before each call whether to stop.

  \param source the face
  \param distances is resized to the number of faces and filled with numbers: none infinite or negative, 0 for
                   `source`
  */
  void operator()(CGAL::Protrusion_segmentation::Indexed_surface::Index source, std::vector<double>& distances);

  /*!
  computes the distances from a face up to a bound.

  Optional: without it, all distances are computed even where only those inside a border are needed.

  \param source the face
  \param distances is resized to the number of faces and filled as above, but distances above `bound` may be
                   too large or infinite
  \param bound the largest distance that is needed; may be infinite
  */
  void operator()(CGAL::Protrusion_segmentation::Indexed_surface::Index source, std::vector<double>& distances,
                  double bound);

  /*!
  finds the face with the largest sum of distances to all faces, eq. (1) of the paper.

  Optional: without it, distances are computed from every face of the surface, which takes quadratic time.

  \return the face
  */
  CGAL::Protrusion_segmentation::Indexed_surface::Index face_of_largest_sum();

  /*!
  Optional: without it, the calls of `operator()` are counted.

  \return the number of faces from which distances were computed so far; the visitor is told of it
  */
  std::size_t number_of_runs() const;
};
