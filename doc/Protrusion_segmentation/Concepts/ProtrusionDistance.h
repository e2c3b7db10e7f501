/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

The concept `ProtrusionDistance` describes the requirements on a distance between the faces of a surface, by
which protrusion tips are selected and borders are found (Section III.B of the paper). A model holds the
options of the distance and prepares the distances on each surface. A method keeps a copy of it.

\cgalRefines{CopyConstructible}

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
  prepares the distances on a surface.

  It is called for each connected component and for each segment that is divided. It may throw any exception; the
  call of the package then ends with it and writes nothing.

  \param surface one connected piece of at least one face; it outlives the result. Faces may be polygons and may
                 have no area. The surface may have a boundary, and may touch itself in vertices.
  \param execution outlives the result. Random choices depend on its random seed alone. Long loops call its function
                   `check()` several times a second. That throws
                   `CGAL::Protrusion_segmentation::Segmentation_stopped` if the visitor stops the call; do not catch it. A model may use several threads if `is_parallel()` says so.

  \return the distances on `surface`
  */
  On_surface on(const CGAL::Protrusion_segmentation::Indexed_surface& surface,
                CGAL::Protrusion_segmentation::Execution& execution) const;
};
