// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Segments a mesh of the scene: a slider goes through the numbers of segments, tips are picked by the mouse, and segments
// become items of their own.

#include "Scene_spheres_item.h"
#include "Scene_surface_mesh_item.h"
#include "ui_Protrusion_segmentation_widget.h"

#include <CGAL/Protrusion_segmentation/Histogram_method.h>
#include <CGAL/Three/CGAL_Lab_plugin_helper.h>
#include <CGAL/Three/CGAL_Lab_plugin_interface.h>
#include <CGAL/Three/Scene_group_item.h>
#include <CGAL/Three/Three.h>
#include <CGAL/boost/graph/Face_filtered_graph.h>
#include <CGAL/boost/graph/copy_face_graph.h>
#include <CGAL/protrusion_segmentation.h>

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QMainWindow>
#include <QProgressDialog>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <functional>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace Protrusions = CGAL::Protrusion_segmentation;
using CGAL::Three::Three;

namespace {

using Segment_map = SMesh::Property_map<face_descriptor, std::size_t>;

// Shows how far a segmentation is, after half a second, and stops it on demand.
class Progress_visitor : public Protrusions::Segmentation_visitor<SMesh>
{
public:
  explicit Progress_visitor(QWidget* parent)
    : m_dialog(QObject::tr("Looking for protrusions"), QObject::tr("Stop"), 0, steps, parent)
  {
    m_dialog.setWindowModality(Qt::WindowModal);
    m_dialog.setMinimumDuration(500);
    m_dialog.setAutoReset(false);
  }
  void on_progress(double share) { m_dialog.setValue(static_cast<int>(share * (steps - 1))); }
  bool go_further() { return !m_dialog.wasCanceled(); }

private:
  static constexpr int steps = 1000;
  QProgressDialog m_dialog;
};

// The body is grey; colours of segments with near numbers lie far apart on the wheel of hues.
QColor segment_color(std::size_t segment)
{
  if (segment == 0)
    return QColor(150, 150, 145);
  return QColor::fromHsvF(std::fmod(0.3819660 * static_cast<double>(segment), 1.), 0.7, 0.75);
}

} // namespace

class Protrusion_segmentation_plugin : public QObject, public CGAL::Three::CGAL_Lab_plugin_helper
{
  Q_OBJECT
  Q_INTERFACES(CGAL::Three::CGAL_Lab_plugin_interface)
  Q_PLUGIN_METADATA(IID "com.geometryfactory.CGALLab.PluginInterface/1.0")

public:
  QList<QAction*> actions() const override { return {m_action}; }

  bool applicable(QAction*) const override
  {
    return qobject_cast<Scene_surface_mesh_item*>(scene->item(scene->mainSelectionIndex())) != nullptr;
  }

  void init(QMainWindow* main_window, CGAL::Three::Scene_interface* scene_interface, Messages_interface*) override
  {
    mw = main_window;
    scene = scene_interface;
    m_action = new QAction(tr("Protrusion Segmentation"), mw);
    m_action->setObjectName("actionProtrusion_segmentation");
    m_action->setProperty("subMenuName", "Triangulated Surface Mesh Segmentation");
    connect(m_action, SIGNAL(triggered()), this, SLOT(show_dock()));
    connect(Three::connectableScene(), SIGNAL(itemAboutToBeDestroyed(CGAL::Three::Scene_item*)), this,
            SLOT(forget(CGAL::Three::Scene_item*)));
    connect(Three::mainViewer(), SIGNAL(selectedPoint(double, double, double)), this,
            SLOT(pick_point(double, double, double)));

    m_dock = new QDockWidget(tr("Protrusion Segmentation"), mw);
    m_dock->setVisible(false);
    m_widget.setupUi(m_dock);
    addDockWidget(m_dock);
    connect(m_widget.segment_button, SIGNAL(clicked()), this, SLOT(segment()));
    connect(m_widget.number_slider, SIGNAL(valueChanged(int)), this, SLOT(show_number(int)));
    connect(m_widget.pick_box, SIGNAL(toggled(bool)), this, SLOT(pick(bool)));
    connect(m_widget.clear_button, SIGNAL(clicked()), this, SLOT(clear_tips()));
    connect(m_widget.tips_button, SIGNAL(clicked()), this, SLOT(segment_from_tips()));
    connect(m_widget.split_button, SIGNAL(clicked()), this, SLOT(split()));
  }

  void closure() override { m_dock->hide(); }

public Q_SLOTS:
  void show_dock()
  {
    m_dock->show();
    m_dock->raise();
  }

  // Computes the hierarchy of the selected mesh, and shows as many segments as the method finds.
  void segment()
  {
    take_selected_item();
    guarded(
      [this](SMesh& mesh)
      {
        Progress_visitor visitor(mw);
        const auto np = CGAL::parameters::visitor(std::ref(visitor));
        Segment_map segments = segment_map(mesh);
        const std::size_t number =
          with_method([&](const auto& method)
                      { return CGAL::segmentation_via_protrusion_tips(mesh, segments, method, np); });
        const std::size_t largest = (std::min<std::size_t>)(num_faces(mesh), m_widget.maximum_box->value());
        if (largest == 0) // nothing to segment
          return;
        Protrusions::Segment_hierarchy hierarchy =
          with_method([&](const auto& method)
                      { return CGAL::protrusion_hierarchy(mesh, (std::max)(largest, number), method, np); });
        take_hierarchy(std::move(hierarchy), number);
      });
  }

  void show_number(int number)
  {
    m_widget.number_label->setText(QString::number(number));
    if (m_hierarchy)
      guarded(
        [&](SMesh& mesh)
        {
          m_hierarchy->segment_ids(mesh, static_cast<std::size_t>(number), segment_map(mesh));
          color(mesh, static_cast<std::size_t>(number));
        });
  }

  void pick(bool is_on)
  {
    if (is_on)
      take_selected_item();
  }

  // While tips are picked, a click with the shift key on a tip takes it away, anywhere else it makes one.
  void pick_point(double x, double y, double z)
  {
    if (!m_widget.pick_box->isChecked() || !m_item)
      return;
    const Point_3 point(x, y, z);
    const SMesh& mesh = *m_item->face_graph();
    const double radius = 1.1 * tip_radius(); // of what is drawn, and rounding
    const auto found =
      std::find_if(m_tips.begin(), m_tips.end(),
                   [&](face_descriptor tip)
                   { return CGAL::squared_distance(centroid(mesh, tip), point) <= radius * radius; });
    if (found != m_tips.end())
      m_tips.erase(found);
    else
      m_tips.push_back(nearest_face(mesh, point));
    show_tips();
  }

  void clear_tips()
  {
    m_tips.clear();
    show_tips();
  }

  void segment_from_tips()
  {
    guarded(
      [this](SMesh& mesh)
      {
        Progress_visitor visitor(mw);
        Segment_map segments = segment_map(mesh);
        const std::size_t number = with_method(
          [&](const auto& method)
          {
            return CGAL::segmentation_from_protrusion_tips(mesh, m_tips, segments, method,
                                                           CGAL::parameters::visitor(std::ref(visitor)));
          });
        drop_hierarchy();
        color(mesh, number);
      });
  }

  // Makes a group of items, one for each segment that is shown.
  void split()
  {
    guarded(
      [this](SMesh& mesh)
      {
        auto* group = new CGAL::Three::Scene_group_item(tr("%1 (segments)").arg(m_item->name()));
        scene->addItem(group);
        for (std::size_t s = 0; s < m_number_of_segments; ++s)
        {
          SMesh part;
          CGAL::copy_face_graph(CGAL::Face_filtered_graph<SMesh>(mesh, s, segment_map(mesh)), part);
          auto* item = new Scene_surface_mesh_item(std::move(part));
          item->setName(tr("%1 (segment %2)").arg(m_item->name()).arg(s));
          item->setColor(segment_color(s));
          item->setRenderingMode(m_item->renderingMode());
          scene->addItem(item);
          scene->changeGroup(item, group);
        }
        if (m_number_of_segments > 0)
          m_item->setVisible(false);
        scene->itemChanged(m_item);
      });
  }

  void forget(CGAL::Three::Scene_item* item)
  {
    if (item == m_spheres)
      m_spheres = nullptr;
    if (item == m_item)
      take_item(nullptr);
  }

private:
  // Calls `work` with the mesh, and tells the user what goes wrong.
  template <typename Work>
  void guarded(Work work)
  {
    if (!m_item)
    {
      Three::warning(tr("Select a surface mesh and segment it first."));
      return;
    }
    QApplication::setOverrideCursor(Qt::WaitCursor);
    try
    {
      work(*m_item->face_graph());
    }
    catch (const Protrusions::Segmentation_stopped&)
    {
      // the user did that
    }
    catch (const std::exception& error)
    {
      Three::error(error.what());
    }
    QApplication::restoreOverrideCursor();
  }

  // Calls `work` with the method that is chosen.
  template <typename Work>
  std::invoke_result_t<Work, const Protrusions::Minimum_cut_method&> with_method(Work work) const
  {
    if (m_widget.method_box->currentIndex() == 0)
      return work(Protrusions::Minimum_cut_method());
    return work(Protrusions::Histogram_method());
  }

  static Segment_map segment_map(SMesh& mesh)
  {
    return mesh.add_property_map<face_descriptor, std::size_t>("f:protrusion_segment", 0).first;
  }

  void take_selected_item()
  {
    // A click on a sphere selects the spheres. The mesh below them stays the one to work on.
    if (!m_spheres || scene->item(scene->mainSelectionIndex()) != m_spheres)
      take_item(getSelectedItem<Scene_surface_mesh_item>());
  }

  void take_item(Scene_surface_mesh_item* item)
  {
    if (item == m_item)
      return;
    m_item = item;
    m_widget.item_label->setText(item ? item->name() : tr("none"));
    m_number_of_segments = 0;
    drop_hierarchy();
    clear_tips();
  }

  void take_hierarchy(Protrusions::Segment_hierarchy&& hierarchy, std::size_t number)
  {
    drop_hierarchy();
    const int least = static_cast<int>(hierarchy.minimum_number_of_segments());
    const int largest = static_cast<int>(hierarchy.maximum_number_of_segments());
    m_widget.number_slider->setRange(least, largest);
    m_widget.number_slider->setValue(static_cast<int>(number));
    m_widget.number_slider->setEnabled(largest > least);
    m_hierarchy = std::move(hierarchy);
    show_number(m_widget.number_slider->value());
  }

  void drop_hierarchy()
  {
    m_hierarchy.reset();
    m_widget.number_slider->setEnabled(false);
    m_widget.number_label->setText("-");
  }

  void color(SMesh& mesh, std::size_t number_of_segments)
  {
    m_number_of_segments = number_of_segments;
    m_widget.number_label->setText(QString::number(number_of_segments));
    m_item->setItemIsMulticolor(true);
    if (m_item->renderingMode() == FlatPlusEdges) // the edges of a fine mesh hide the colours
      m_item->setFlatMode();
    const Segment_map segments = segment_map(mesh);
    auto patches = get(CGAL::face_patch_id_t<int>(), mesh);
    for (const face_descriptor f : faces(mesh))
      put(patches, f, static_cast<int>(get(segments, f)));
    m_item->color_vector().clear();
    for (std::size_t s = 0; s < number_of_segments; ++s)
      m_item->color_vector().push_back(segment_color(s));
    m_item->computeItemColorVectorAutomatically(false);
    m_item->setProperty("NbPatchIds", static_cast<int>(number_of_segments)); // for the plugin that joins and splits
    m_item->invalidateOpenGLBuffers();
    scene->itemChanged(m_item);
  }

  // A sphere at the centroid of every tip that is picked.
  void show_tips()
  {
    m_widget.tips_label->setText(QString::number(m_tips.size()));
    if (!m_spheres && m_tips.empty())
      return;
    if (!m_spheres)
    {
      m_spheres = new Scene_spheres_item(nullptr, 0, false, false);
      m_spheres->setName(tr("Protrusion tips"));
      m_spheres->setRenderingMode(Gouraud);
      const int selected = scene->mainSelectionIndex();
      scene->addItem(m_spheres);
      scene->setSelectedItem(selected);
    }
    m_spheres->clear_spheres();
    if (m_item)
    {
      const SMesh& mesh = *m_item->face_graph();
      for (const face_descriptor tip : m_tips)
        m_spheres->add_sphere(EPICK::Sphere_3(centroid(mesh, tip), CGAL::square(tip_radius())), 0,
                              CGAL::IO::Color(200, 40, 40));
    }
    m_spheres->invalidateOpenGLBuffers();
    m_spheres->computeElements(); // it does not do so when it is drawn
    scene->itemChanged(m_spheres);
  }

  // of the spheres: easily seen, and hides little
  double tip_radius() const { return 0.01 * m_item->bboxDiagonal(); }

  static face_descriptor nearest_face(const SMesh& mesh, const Point_3& point)
  {
    return *std::min_element(mesh.faces().begin(), mesh.faces().end(),
                             [&](face_descriptor f, face_descriptor g)
                             {
                               return CGAL::squared_distance(centroid(mesh, f), point) <
                                      CGAL::squared_distance(centroid(mesh, g), point);
                             });
  }

  static Point_3 centroid(const SMesh& mesh, face_descriptor face)
  {
    EPICK::Vector_3 sum(0, 0, 0);
    int number = 0;
    for (const vertex_descriptor v : vertices_around_face(mesh.halfedge(face), mesh))
    {
      sum = sum + (mesh.point(v) - CGAL::ORIGIN);
      ++number;
    }
    return CGAL::ORIGIN + sum / number;
  }

  QAction* m_action = nullptr;
  QDockWidget* m_dock = nullptr;
  Ui::Protrusion_segmentation m_widget;

  Scene_surface_mesh_item* m_item = nullptr; // of which all that follows is
  std::optional<Protrusions::Segment_hierarchy> m_hierarchy;
  std::size_t m_number_of_segments = 0; // that are shown
  std::vector<face_descriptor> m_tips;
  Scene_spheres_item* m_spheres = nullptr; // at the tips
};

#include "Protrusion_segmentation_plugin.moc"
