/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

The concept `ProtrusionDistance` describes the requirements on a distance between the faces of a surface, by
which protrusion tips are selected and histograms are made (Section III.B of the paper). A model holds the
options of the distance and makes from them the distances on each part of a surface that is looked at.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Protrusion_segmentation::Geodesic_distance}
\cgalHasModels{CGAL::Protrusion_segmentation::Landmark_geodesic_distance}
\cgalHasModels{CGAL::Protrusion_segmentation::Diffusion_distance}
\cgalHasModels{CGAL::Protrusion_segmentation::Heat_distance}
\cgalHasModels{CGAL::Protrusion_segmentation::Exact_geodesic_distance}
\cgalHasModelsEnd

\sa `ProtrusionDistancesOnSurface`
*/
class ProtrusionDistance
{
public:
  /*!
  A model of `ProtrusionDistancesOnSurface`.
  */
  typedef unspecified_type On_surface;

  /*!
  prepares the distances on a part.

  It is called once for the whole surface or for each connected component, and once for every segment that is
  looked at later. It may throw any exception; the segmentation then ends with it and writes nothing.

  \param part the part, one connected piece of at least one face; it outlives the result. Faces may be polygons
              and may have no area. A part may have borders, and may touch itself in vertices.
  \param random_seed the seed of all that is random; equal seeds give equal distances

  \return the distances on `part`
  */
  On_surface on(const CGAL::Protrusion_segmentation::Indexed_surface& part, unsigned int random_seed) const;
};
