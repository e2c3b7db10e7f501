// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "planar_cuts.h"

#include <CGAL/Polygon_mesh_processing/compute_normal.h>
#include <CGAL/Polygon_mesh_processing/measure.h>

#include <pcl/console/print.h>
#include <pcl/segmentation/cpc_segmentation.h>
#include <pcl/segmentation/supervoxel_clustering.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <random>
#include <set>

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;

using Cloud_point = pcl::PointXYZRGBA; // the least of those that the library is compiled for
using Supervoxels = pcl::SupervoxelClustering<Cloud_point>;

// Points on the faces, in a unit in which the mesh has area one.
struct Cloud
{
  pcl::PointCloud<Cloud_point>::Ptr points{new pcl::PointCloud<Cloud_point>};
  pcl::PointCloud<pcl::Normal>::Ptr normals{new pcl::PointCloud<pcl::Normal>};
  std::vector<std::size_t> faces; // of the points
};

double random_share(std::mt19937& random)
{
  return double(random()) / 4294967296.;
}

Point random_point(const Mesh& mesh, Face f, std::mt19937& random)
{
  double s = random_share(random), t = random_share(random);
  if (s + t > 1)
  {
    s = 1 - s;
    t = 1 - t;
  }
  const Halfedge h = mesh.halfedge(f);
  const Point& p = mesh.point(mesh.source(h));
  return p + s * (mesh.point(mesh.target(h)) - p) + t * (mesh.point(mesh.target(mesh.next(h))) - p);
}

void add_point(Cloud& cloud, const Point& p, const Vector& normal, double unit)
{
  Cloud_point point;
  point.x = float(p.x() / unit);
  point.y = float(p.y() / unit);
  point.z = float(p.z() / unit);
  cloud.points->push_back(point);
  cloud.normals->push_back(pcl::Normal(float(normal.x()), float(normal.y()), float(normal.z())));
}

// Every face has a point, large ones have more.
Cloud cloud_on(const Mesh& mesh, std::size_t number, unsigned int seed)
{
  Cloud cloud;
  std::mt19937 random(seed);
  const double area = PMP::area(mesh);
  for (const Face f : mesh.faces())
  {
    const double wanted = double(number) * PMP::face_area(f, mesh) / area + random_share(random);
    const Vector normal = PMP::compute_face_normal(f, mesh);
    for (std::size_t i = 0; i < (std::max)(std::size_t(1), std::size_t(wanted)); ++i)
    {
      add_point(cloud, random_point(mesh, f, random), normal, std::sqrt(area));
      cloud.faces.push_back(f);
    }
  }
  return cloud;
}

// The number of the segment of most points of each face.
Labels labels_of_faces(const Cloud& cloud,
                       const pcl::PointCloud<pcl::PointXYZL>& labelled,
                       std::size_t number_of_faces)
{
  std::vector<std::map<std::uint32_t, std::size_t>> votes(number_of_faces);
  for (std::size_t i = 0; i < cloud.faces.size(); ++i)
    ++votes[cloud.faces[i]][labelled[i].label];
  Labels labels;
  for (const auto& of_face : votes)
    labels.push_back(std::max_element(of_face.begin(), of_face.end(),
                                      [](const auto& a, const auto& b) { return a.second < b.second; })
                       ->first);
  return labels;
}

class Planar_cutter
{
public:
  Planar_cutter(const Cloud& cloud, const Planar_cuts_options& options)
    : m_options(options),
      m_supervoxels(float(options.voxel), float(options.supervoxel))
  {
    m_supervoxels.setUseSingleCameraTransform(false);
    m_supervoxels.setInputCloud(cloud.points);
    m_supervoxels.setNormalCloud(cloud.normals);
    m_supervoxels.setColorImportance(0);
    m_supervoxels.setSpatialImportance(1);
    m_supervoxels.setNormalImportance(4);
    m_supervoxels.extract(m_clusters);
    m_supervoxels.getSupervoxelAdjacency(m_neighbors);
  }

  // Of the points. Cuts are made down to a score.
  pcl::PointCloud<pcl::PointXYZL> labelled(float least_score) const
  {
    pcl::CPCSegmentation<Cloud_point> segmentation;
    segmentation.setConcavityToleranceThreshold(10);
    segmentation.setSmoothnessCheck(true, float(m_options.voxel), float(m_options.supervoxel), 0.1f);
    segmentation.setKFactor(0);
    segmentation.setInputSupervoxels(m_clusters, m_neighbors);
    segmentation.setMinSegmentSize(3);
    segmentation.setCutting(25, m_options.least_links, least_score, true, true, false);
    segmentation.setRANSACIterations(m_options.planes);
    segmentation.segment();
    pcl::PointCloud<pcl::PointXYZL> result = *m_supervoxels.getLabeledCloud();
    segmentation.relabelCloud(result);
    return result;
  }

private:
  Planar_cuts_options m_options;
  Supervoxels m_supervoxels;
  std::map<std::uint32_t, pcl::Supervoxel<Cloud_point>::Ptr> m_clusters;
  std::multimap<std::uint32_t, std::uint32_t> m_neighbors;
};

} // namespace

Labels planar_cuts_segmentation(const Mesh& mesh,
                                std::size_t number_of_segments,
                                unsigned int seed,
                                const Planar_cuts_options& options)
{
  pcl::console::setVerbosityLevel(pcl::console::L_ERROR);
  const Cloud cloud = cloud_on(mesh, options.points, seed);
  const Planar_cutter cutter(cloud, options);
  Labels best;
  std::size_t least = (std::numeric_limits<std::size_t>::max)();
  for (const float least_score :
       {0.64f, 0.32f, 0.16f, 0.08f, 0.04f, 0.02f}) // 0.16 is the library's default
  {
    Labels labels = labels_of_faces(cloud, cutter.labelled(least_score), mesh.number_of_faces());
    const std::size_t number = std::set<std::size_t>(labels.begin(), labels.end()).size();
    const std::size_t difference = number > number_of_segments ? number - number_of_segments
                                                               : number_of_segments - number;
    if (difference >= least)
      continue;
    least = difference;
    best = std::move(labels);
  }
  return best;
}
