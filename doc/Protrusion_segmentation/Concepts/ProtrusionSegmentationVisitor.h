/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

The concept `ProtrusionSegmentationVisitor` describes the requirements on what is told of the progress and of
the findings of a segmentation, and may stop it. Faces are numbered in the order of `faces(tmesh)`.

A visitor is copied unless it is passed by `std::ref()`. It may throw any exception; the segmentation then ends
with it and writes nothing.

\cgalRefines{CopyConstructible}

\cgalHasModelsBegin
\cgalHasModels{CGAL::Protrusion_segmentation::Default_visitor}
\cgalHasModelsEnd
*/
class ProtrusionSegmentationVisitor
{
public:
  /*!
  is called when a stage starts. Stages may come more than once, and do not contain each other.
  \param stage the stage
  */
  void stage_starts(CGAL::Protrusion_segmentation::Stage stage);

  /*!
  is called when a stage ends, also if it is stopped or an exception passes.
  \param stage the stage that started last
  */
  void stage_ends(CGAL::Protrusion_segmentation::Stage stage);

  /*!
  is called again and again.
  \param share the share of the segments asked for that are found, from 0 to 1; if no number of segments was
               asked for, it grows with every segment. It is 1 at the end.
  */
  void progress(double share);

  /*!
  is called between two steps, each of which is short against the whole.
  \return `false` to stop: the function that the visitor was passed to then returns 0 and writes nothing
  */
  bool go_further();

  /*!
  is called for each protrusion tip that is found, which need not become a segment.
  \param face the face at the tip
  */
  void tip_found(std::size_t face);

  /*!
  is called for each face that would be a tip but for where it lies, at the border of a segment cut off before.
  \param face the face
  */
  void tip_eliminated(std::size_t face);

  /*!
  is called for each protrusion that is cut off.
  \param protrusion all that is known of it
  */
  void protrusion_found(const CGAL::Protrusion_segmentation::Protrusion& protrusion);

  /*!
  is called when work on a part ends.
  \param number_of_runs from how many more faces distances were computed
  */
  void distances_computed(std::size_t number_of_runs);
};
