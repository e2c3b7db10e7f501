// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Compares the metrics to scores that the program of the Princeton Segmentation Benchmark computed
// for pairs of human segmentations.
//
// PRINCETON_FOLDER            folder with off/<model>.off and seg/<model>/<model>_<human>.seg
// PRINCETON_REFERENCE_SCORES  CSV with the columns named in `check_header()`
//
// Without these two the test is skipped (exit code 77): meshes and scores are not part of the
// package.

#include "check.h"
#include "rand_index_error_of_benchmark.h"

#include <CGAL/IO/SEG.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/segmentation_metrics.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <sstream>
#include <string>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Face = boost::graph_traits<Mesh>::face_descriptor;
using Segment_id_map = Mesh::Property_map<Face, std::size_t>;

constexpr int exit_code_of_a_skipped_test = 77;

// The benchmark's program computes and prints in single precision.
constexpr double tolerance = 1e-6;

// How the scores write a cut discrepancy without value.
const double undefined = std::numeric_limits<double>::quiet_NaN();

struct Row
{
  std::string model;
  std::string segmentation;
  std::string reference;
  std::vector<double> scores;
};

std::string without_carriage_return(const std::string& line)
{
  return line.substr(0, line.find('\r'));
}

void check_header(const std::string& header)
{
  CGAL_CHECK_EQUAL(header, std::string("model,segmentation,reference,GCE_faces,LCE_faces,GCE_area,"
                                  "LCE_area,Hamming,missing_rate,false_alarm_rate,"
                                  "cut_discrepancy,rand_index_error"));
}

Row parsed_row(const std::string& line)
{
  std::istringstream in(line);
  Row row;
  std::getline(in, row.model, ',');
  std::getline(in, row.segmentation, ',');
  std::getline(in, row.reference, ',');
  for (std::string score; std::getline(in, score, ',');)
    row.scores.push_back(std::stod(score));
  return row;
}

std::map<std::string, std::vector<Row>> rows_by_model(const std::string& file_name)
{
  std::ifstream in(file_name);
  std::string line;
  std::getline(in, line);
  check_header(without_carriage_return(line));

  std::map<std::string, std::vector<Row>> result;
  while (std::getline(in, line))
  {
    const Row row = parsed_row(without_carriage_return(line));
    result[row.model].push_back(row);
  }
  return result;
}

std::vector<double> scores(const Mesh& mesh, Segment_id_map segment_ids, Segment_id_map reference_ids)
{
  const auto metrics = CGAL::Protrusion_segmentation::segmentation_metrics(mesh, segment_ids,
                                                                           reference_ids);
  const auto& consistency = metrics.consistency_error;
  const auto& hamming = metrics.hamming_distance;
  const double rand_index_error = rand_index_error_of_benchmark(metrics.rand_index_error, mesh.number_of_faces());
  return {consistency.global,
          consistency.local,
          consistency.global_by_area,
          consistency.local_by_area,
          hamming.distance,
          hamming.missing_rate,
          hamming.false_alarm_rate,
          metrics.cut_discrepancy.value_or(undefined),
          rand_index_error};
}

Segment_id_map segmentation(const std::string& folder,
                            const std::string& model,
                            const std::string& human,
                            Mesh& mesh)
{
  const std::string name = folder + "/seg/" + model + "/" + model + "_" + human + ".seg";
  Segment_id_map segment_ids = mesh.add_property_map<Face, std::size_t>("f:" + human, 0).first;
  CGAL_CHECK(CGAL::IO::read_SEG(name, mesh, segment_ids));
  return segment_ids;
}

void check_score(double computed, double expected)
{
  if (std::isnan(expected))
    CGAL_CHECK(std::isnan(computed));
  else
    CGAL_CHECK_CLOSE(computed, expected, tolerance);
}

void check_model(const std::string& folder, const std::string& model, const std::vector<Row>& rows)
{
  Mesh mesh;
  CGAL_CHECK(CGAL::IO::read_polygon_mesh(folder + "/off/" + model + ".off", mesh));
  for (const Row& row : rows)
  {
    const std::vector<double> computed = scores(mesh, segmentation(folder, model, row.segmentation, mesh),
                                                segmentation(folder, model, row.reference, mesh));
    CGAL_CHECK_EQUAL(computed.size(), row.scores.size());
    for (std::size_t i = 0; i < (std::min)(computed.size(), row.scores.size()); ++i)
      check_score(computed[i], row.scores[i]);
  }
}

int main()
{
  const char* folder = std::getenv("PRINCETON_FOLDER");
  const char* reference_scores = std::getenv("PRINCETON_REFERENCE_SCORES");
  if (folder == nullptr || reference_scores == nullptr)
  {
    std::cout << "skipped: PRINCETON_FOLDER and PRINCETON_REFERENCE_SCORES are not set\n";
    return exit_code_of_a_skipped_test;
  }

  std::size_t number_of_rows = 0;
  for (const auto& [model, rows] : rows_by_model(reference_scores))
  {
    check_model(folder, model, rows);
    number_of_rows += rows.size();
  }
  std::cout << number_of_rows << " pairs of segmentations\n";
  CGAL_CHECK(number_of_rows > 0);
  return check::result();
}
