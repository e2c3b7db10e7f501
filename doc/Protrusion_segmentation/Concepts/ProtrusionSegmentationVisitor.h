/*!
\ingroup PkgProtrusionSegmentationConcepts
\cgalConcept

What a visitor of a segmentation has to offer. It is told of the progress and of what was found, and may stop the
call. It is passed as the named parameter `visitor` and copied, unless it is passed by `std::ref()`.

All calls come from the thread that called the function of the package. A visitor may throw any exception: the
call ends with it and writes nothing.

Both methods go through the same stages:
- reading: the mesh is read as index arrays;
- preparation: what a method needs to know of a surface is computed: weights and a coarse graph, or what the
  distances on a segment are made from;
- tips: protrusion tips of a segment are selected (Section III.C of the paper);
- borders: histograms or cuts are computed, and borders chosen (Section III.D). `Histogram_method` computes the
  histograms of a tip as soon as it is selected, so that this stage lies within the one before;
- labels: the faces of protrusions get their segments.

All but the first may come several times. They do not come where nothing is searched: on a convex component if no number of
segments is given, and if as many segments are asked for as there are components, or fewer. Where threads segment
components side by side, a visitor hears of those of its own thread. Every begin has its end, also if an exception passes.

\cgalHasModelsBegin
\cgalHasModels{CGAL::Protrusion_segmentation::Segmentation_visitor}
\cgalHasModels{CGAL::Protrusion_segmentation::Segmentation_record}
\cgalHasModelsEnd
*/
class ProtrusionSegmentationVisitor
{
public:
  /// \name Stages
  /// @{
  void on_reading_begin();     ///< reading begins
  void on_reading_end();       ///< reading ends
  void on_preparation_begin(); ///< preparation begins
  void on_preparation_end();   ///< preparation ends
  void on_tips_begin();        ///< the selection of tips begins
  void on_tips_end();          ///< the selection of tips ends
  void on_borders_begin();     ///< the computation of borders begins
  void on_borders_end();       ///< the computation of borders ends
  void on_labels_begin();      ///< labelling begins
  void on_labels_end();        ///< labelling ends
  /// @}

  /// \name Progress
  /// @{

  /// is called several times a second. The share never falls, and is 1 at the end.
  /// \param share about how much of the work is done, from 0 to 1. Without a number of segments the amount of work
  ///        is not known before, and the share approaches 1 until the end.
  void on_progress(double share);
  /// is called several times a second.
  /// \return `false` to stop: the call writes nothing and throws
  ///         `CGAL::Protrusion_segmentation::Segmentation_stopped`
  bool go_further();
  /// is called when the work on a segment ends.
  /// \param number_of_runs from how many more faces distances were computed. `Minimum_cut_method` may need more of
  ///        them with several threads than with one.
  void on_distances(std::size_t number_of_runs);
  /// @}

  /// \name Findings
  /// @{

  /// is called if there are small components, which get no segments of their own:
  /// `CGAL::segmentation_via_protrusion_tips()` says which these are.
  /// \param number_of_small_components how many there are, at least 1
  void on_small_components(std::size_t number_of_small_components);
  /// is called for each protrusion tip that is selected, which need not become a segment.
  /// \param face the face at the tip
  void on_tip(face_descriptor face);
  /// is called for each face that is farthest from the tips but does not become one, because it lies on the border
  /// of a segment that was cut off before.
  /// \param face the face
  void on_eliminated_tip(face_descriptor face);
  /// is called for each protrusion that is cut off. A visitor that inherits this function and `on_tip()` from
  /// `CGAL::Protrusion_segmentation::Segmentation_visitor` saves the time to describe protrusions.
  /// \param protrusion all that is known of it
  void on_protrusion(const CGAL::Protrusion_segmentation::Protrusion<face_descriptor>& protrusion);
  /// @}
};
