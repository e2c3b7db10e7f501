// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the quality benchmark concludes from scores, and how it reads the segmentations of others.

#include "check.h"
#include "Benchmark_folder.h"
#include "Model_classes.h"
#include "Segment_network.h"
#include "Segmentation_folder.h"
#include "bootstrap.h"
#include "comparison.h"
#include "rand_index_error_of_benchmark.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

namespace fs = std::filesystem;

namespace {

void test_means()
{
  CGAL_CHECK_CLOSE(mean_of_classes({{1, 2, 3}, {10}}), 6, 1e-12);
  CGAL_CHECK_CLOSE(mean_of_classes({{1, 2, 3}, {}}), 2, 1e-12);
}

// What is the same in all samples has no interval; one class does not lend its models to another.
void test_no_spread()
{
  const Mean_with_interval mean = bootstrap_mean({{1, 1, 1}, {5, 5}, {9}}, 1);
  CGAL_CHECK_CLOSE(mean.mean, 5, 1e-12);
  CGAL_CHECK_CLOSE(mean.low, 5, 1e-12);
  CGAL_CHECK_CLOSE(mean.high, 5, 1e-12);
}

// Two values that differ by one: each sample of them has mean 0, 1/2 or 1, the ends with probability 1/4.
void test_two_values()
{
  const Mean_with_interval mean = bootstrap_mean({{0, 1}}, 1);
  CGAL_CHECK_CLOSE(mean.mean, 0.5, 1e-12);
  CGAL_CHECK_EQUAL(mean.low, 0);
  CGAL_CHECK_EQUAL(mean.high, 1);
}

// Of many values the means are nearly normal: the interval is 1.96 standard errors to each side.
void test_many_values()
{
  std::mt19937 random(7);
  std::vector<double> values(400);
  double sum = 0, squares = 0;
  for (double& value : values)
  {
    value = double(random() % 1000);
    sum += value;
    squares += value * value;
  }
  const double mean = sum / 400, error = std::sqrt((squares / 400 - mean * mean) / 400);
  const Mean_with_interval found = bootstrap_mean({values}, 3);
  CGAL_CHECK_CLOSE(found.mean, mean, 1e-9);
  CGAL_CHECK_CLOSE(found.high - found.mean, 1.96 * error, 0.2 * error);
  CGAL_CHECK_CLOSE(found.mean - found.low, 1.96 * error, 0.2 * error);
}

void test_seed()
{
  const Values_by_class values = {{1, 4, 2, 8}, {5, 7, 1}};
  CGAL_CHECK_EQUAL(bootstrap_mean(values, 1).low, bootstrap_mean(values, 1).low);
  CGAL_CHECK_EQUAL(bootstrap_mean(values, 1).high, bootstrap_mean(values, 1).high);
}

Model_results results_of(int model,
                         const std::string& name,
                         const std::vector<std::optional<double>>& errors)
{
  Model_results result;
  result.model = model;
  result.class_name = name;
  for (const std::optional<double>& error : errors)
  {
    result.methods.emplace_back();
    result.methods.back().scores[Score::rand_index_error] = error;
  }
  return result;
}

// The second method is always worse by a tenth, though both vary much more: paired differences tell. The third is
// better and worse by turns.
void test_comparison()
{
  std::vector<Model_results> models;
  for (int i = 0; i < 20; ++i)
  {
    const double error = 0.05 * (i % 7);
    models.push_back(
      results_of(i + 1, i < 10 ? "A" : "B", {error, error + 0.1, error + (i % 2 ? 0.1 : -0.1)}));
  }
  models.push_back(results_of(21, "B", {0.1, std::nullopt, 0.1}));
  const Results results({"a", "b", "c"}, models);

  const auto clear = comparison(results, 1, 2, Score::rand_index_error);
  CGAL_CHECK(clear.has_value());
  CGAL_CHECK_CLOSE(clear->difference.mean, -0.1, 1e-12);
  CGAL_CHECK(clear->difference.excludes_zero());
  CGAL_CHECK_EQUAL(clear->first_is_better, 20); // the model without a score of one is left out
  CGAL_CHECK_EQUAL(clear->second_is_better, 0);
  CGAL_CHECK_EQUAL(clear->both_are_equal, 0);

  const auto open = comparison(results, 1, 3, Score::rand_index_error);
  CGAL_CHECK(!open->difference.excludes_zero());
  CGAL_CHECK_EQUAL(open->first_is_better, 10);
  CGAL_CHECK_EQUAL(open->second_is_better, 10);
  CGAL_CHECK_EQUAL(open->both_are_equal, 1);

  CGAL_CHECK(!comparison(results, 1, 2, Score::cut_discrepancy).has_value());
  CGAL_CHECK(!mean_with_interval(results, 1, Score::cut_discrepancy).has_value());
  const auto mean = mean_with_interval(results, 2, Score::rand_index_error);
  CGAL_CHECK_CLOSE(mean->mean, *results.of_classes(2, {"A", "B"})[Score::rand_index_error], 1e-12);
  CGAL_CHECK(mean->low < mean->mean && mean->mean < mean->high);
}

void test_classes()
{
  const Model_classes princeton;
  CGAL_CHECK_EQUAL(princeton.of_model(1), "Human");
  CGAL_CHECK_EQUAL(princeton.of_model(20), "Human");
  CGAL_CHECK_EQUAL(princeton.of_model(21), "Cup");
  CGAL_CHECK_EQUAL(princeton.of_model(260), "Bird");
  CGAL_CHECK_THROWS_WITH(princeton.of_model(261), std::invalid_argument, "261");
  CGAL_CHECK_EQUAL(princeton.of_model(281), "Armadillo");
  CGAL_CHECK_EQUAL(princeton.of_model(400), "FourLeg");
  CGAL_CHECK_THROWS(princeton.of_model(401), std::invalid_argument);
  const Model_classes own("People=1-200,Animals=201-300");
  CGAL_CHECK_EQUAL(own.of_model(200), "People");
  CGAL_CHECK_EQUAL(own.of_model(201), "Animals");
  CGAL_CHECK_THROWS(own.of_model(301), std::invalid_argument);
  for (const char* wrong :
       {"People", "People=", "People=1", "People=1-", "=1-2", "People=2-1", "People=1-2x", "A=1-2,,"})
    CGAL_CHECK_THROWS_WITH(Model_classes(wrong), std::invalid_argument, wrong);
}

// What it costs to part a side from the rest.
double cost(const std::vector<Segment_network::Link>& links, const std::vector<bool>& side)
{
  double sum = 0;
  for (const Segment_network::Link& link : links)
    sum += side[link.a] != side[link.b] ? link.cost : 0;
  return sum;
}

// The least cost of all sides with node 0 and without node 1, by trying.
double least_cost(const std::vector<Segment_network::Link>& links, std::size_t nodes)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t subset = 0; subset < (std::size_t(1) << nodes); ++subset)
  {
    std::vector<bool> side(nodes);
    for (std::size_t i = 0; i < nodes; ++i)
      side[i] = (subset >> i) & 1;
    if (side[0] && !side[1])
      least = (std::min)(least, cost(links, side));
  }
  return least;
}

// Some links are twice in the list, and the network is asked twice: the first answer leaves nothing behind.
void test_minimum_cuts()
{
  std::mt19937 random(3);
  const std::size_t nodes = 8;
  for (int round = 0; round < 50; ++round)
  {
    std::vector<Segment_network::Link> links;
    for (std::size_t i = 1; i < nodes; ++i) // connected
      links.push_back({random() % i, i, 1 + double(random() % 9)});
    for (int i = 0; i < 10; ++i)
    {
      const std::size_t a = random() % nodes, b = random() % nodes;
      if (a != b)
        links.push_back({a, b, 1 + double(random() % 9)});
    }
    Segment_network network(nodes, links);
    network.side_of({2, 3}, {4});
    const std::vector<bool> side = network.side_of({0}, {1});
    CGAL_CHECK(side[0] && !side[1]);
    CGAL_CHECK_CLOSE(cost(links, side), least_cost(links, nodes), 1e-9);
  }
}

// A folder that is gone with the object.
class Work_folder
{
public:
  Work_folder()
    : m_path(fs::temp_directory_path() /
             ("test_quality_benchmark." + std::to_string(std::random_device()())))
  {
    fs::create_directories(m_path);
  }
  Work_folder(const Work_folder&) = delete;
  Work_folder& operator=(const Work_folder&) = delete;
  ~Work_folder() { fs::remove_all(m_path); }

  std::string path(const std::string& name = "") const
  {
    return name.empty() ? m_path.string() : (m_path / name).string();
  }
  void write(const std::string& name, const std::string& text) const
  {
    fs::create_directories((m_path / name).parent_path());
    std::ofstream(m_path / name) << text;
  }

private:
  fs::path m_path;
};

void test_folder()
{
  const Work_folder work;
  const File_faces faces(4);
  work.write("1.seg", "0\n1\n1\n3\n");
  work.write("1.seconds", "2.5\n");
  work.write("2/2_0.seg", "7\n7\n7\n7\n");
  work.write("3/a.seg", "0\n0\n0\n0\n");
  work.write("3/b.seg", "0\n0\n0\n0\n");
  work.write("4.seg", "0\n0\n");
  work.write("5.seg", "0\n0\nx\n0\n");
  work.write("5.seconds", "fast\n");

  const Segmentation_folder folder("Mine=" + work.path());
  CGAL_CHECK_EQUAL(folder.name(), "Mine");
  CGAL_CHECK(folder.labels(1, faces) == Labels({0, 1, 1, 3}));
  CGAL_CHECK_EQUAL(*folder.seconds(1), 2.5);
  CGAL_CHECK(folder.labels(2, faces) == Labels({7, 7, 7, 7}));
  CGAL_CHECK(!folder.seconds(2).has_value());
  CGAL_CHECK_THROWS_WITH(folder.labels(3, faces), std::runtime_error, "more than one");
  CGAL_CHECK_THROWS_WITH(folder.labels(4, faces), std::runtime_error, "4.seg: there are only 2 segment ids");
  CGAL_CHECK_THROWS_WITH(folder.labels(5, faces), std::runtime_error, "5.seg: line 3");
  CGAL_CHECK_THROWS_WITH(folder.seconds(5), std::runtime_error, "5.seconds");
  CGAL_CHECK_THROWS_WITH(folder.labels(6, faces), std::runtime_error, "6.seg: there is no such file");
}

void test_wrong_folders()
{
  const Work_folder work;
  work.write("something.txt", "");
  CGAL_CHECK_THROWS_WITH(Segmentation_folder(work.path()), std::invalid_argument, "NAME=FOLDER");
  CGAL_CHECK_THROWS_WITH(Segmentation_folder("=" + work.path()), std::invalid_argument, "NAME=FOLDER");
  CGAL_CHECK_THROWS_WITH(Segmentation_folder("a,b=" + work.path()), std::invalid_argument, "NAME=FOLDER");
  CGAL_CHECK_THROWS_WITH(Segmentation_folder("a=" + work.path("b")), std::invalid_argument, "is no folder");
  CGAL_CHECK_THROWS_WITH(Segmentation_folder("a=" + work.path()), std::invalid_argument, "no .seg files");
}

void test_written_folder()
{
  const Work_folder work;
  const File_faces faces(4);
  const Labels labels = {4, 0, 0, 2};
  add_to_segmentation_folder(work.path("a/b"), 12, faces, labels, 0.25);
  add_to_segmentation_folder(work.path("a/b"), 13, faces, labels, std::nullopt);
  const Segmentation_folder folder("B=" + work.path("a/b"));
  CGAL_CHECK(folder.labels(12, faces) == labels);
  CGAL_CHECK_EQUAL(*folder.seconds(12), 0.25);
  CGAL_CHECK(folder.labels(13, faces) == labels);
  CGAL_CHECK(!folder.seconds(13).has_value());
}

// A folder with two models, the second with a face of no area between two faces, and one of the first face again, turned
// over; the third cannot be read.
void test_models()
{
  const Work_folder work;
  const std::string vertices = "0 0 0\n1 0 0\n0 1 0\n1 1 0\n";
  work.write("off/1.off", "OFF 4 2 0\n" + vertices + "3 0 1 2\n3 2 1 3\n");
  work.write("off/2.off", "OFF 4 4 0\n" + vertices + "3 0 1 2\n3 1 1 2\n3 2 1 3\n3 2 1 0\n");
  work.write("off/3.off", "OFF 4 1 0\n" + vertices + "3 0 1 4\n");
  work.write("seg/1/1_0.seg", "5\n6\n");
  work.write("seg/2/2_0.seg", "5\n8\n6\n9\n");
  work.write("seg/3/3_0.seg", "5\n");
  work.write("nSeg-ByModel.txt", "2\n2\n2\n");

  const Benchmark_folder folder(work.path());
  CGAL_CHECK(folder.models("") == std::vector<int>({1, 2, 3}));
  for (const int number : {1, 2})
  {
    const Model model = folder.read_model(number);
    CGAL_CHECK_EQUAL(model.mesh.number_of_faces(), 2);
    CGAL_CHECK_EQUAL(model.humans.size(), 1);
    CGAL_CHECK(model.humans.front() == Labels({5, 6}));
    CGAL_CHECK(model.faces.labels_of_file({5, 6}) == (number == 1 ? Labels({5, 6}) : Labels({5, 5, 6, 5})) ||
          model.faces.labels_of_file({5, 6}) == Labels({5, 6, 6, 5}));
  }
  CGAL_CHECK_THROWS_WITH(folder.read_model(3), std::runtime_error, "3.off: line 6: ");
  CGAL_CHECK(folder.models("1-3/2") == std::vector<int>({1, 3}));
  CGAL_CHECK_THROWS_WITH(folder.models("1-3/x"), std::invalid_argument, "1-3/x");
}

// The archive's folder, or the one within it, is named. An error names the file that is missing.
void test_layout_of_archive()
{
  const Work_folder work;
  CGAL_CHECK_THROWS_WITH(Benchmark_folder(work.path("psb")), std::runtime_error, "psb/off: cannot be opened");
  work.write("psb/data/off/1.off", "OFF 3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  CGAL_CHECK_THROWS_WITH(Benchmark_folder(work.path("psb")), std::runtime_error,
                    "psb/nSeg-ByModel.txt: cannot be opened");
  work.write("psb/util/parameters/nSeg-ByModel.txt", "2\n");
  CGAL_CHECK_THROWS_WITH(Benchmark_folder(work.path("psb")).read_model(1), std::runtime_error,
                    "seg/1: cannot be opened");
  work.write("psb/data/seg/Benchmark/1/1_0.seg", "5\n");
  for (const char* folder : {"psb", "psb/data"})
  {
    const Model model = Benchmark_folder(work.path(folder)).read_model(1);
    CGAL_CHECK_EQUAL(model.number_of_segments, 2);
    CGAL_CHECK_EQUAL(model.humans.size(), 1);
  }
}

// The benchmark's program divides the number of disagreeing pairs by n * floor((n - 1) / 2).
void test_rand_index_error()
{
  const auto converted = [](double disagreements, std::size_t n)
  { return rand_index_error_of_benchmark(disagreements / (static_cast<double>(n * (n - 1)) / 2), n); };
  CGAL_CHECK_CLOSE(converted(3, 4), 3 / (4 * 1.), 1e-15);
  CGAL_CHECK_CLOSE(converted(9, 6), 9 / (6 * 2.), 1e-15);
  CGAL_CHECK_CLOSE(converted(2, 3), 2 / (3 * 1.), 1e-15);
  CGAL_CHECK_CLOSE(converted(6, 5), 6 / (5 * 2.), 1e-15);
  CGAL_CHECK_EQUAL(converted(6, 4), 1); // 6 / 4, cut
  CGAL_CHECK_EQUAL(converted(0, 4), 0);
  CGAL_CHECK_EQUAL(converted(1, 2), 1); // one pair, though floor(1 / 2) is 0
  CGAL_CHECK_EQUAL(rand_index_error_of_benchmark(0, 1), 0);
  CGAL_CHECK_EQUAL(rand_index_error_of_benchmark(0, 0), 0);
}

} // namespace

int main()
{
  test_means();
  test_no_spread();
  test_two_values();
  test_many_values();
  test_seed();
  test_comparison();
  test_classes();
  test_minimum_cuts();
  test_folder();
  test_wrong_folders();
  test_written_folder();
  test_models();
  test_rand_index_error();
  test_layout_of_archive();
  return check::result();
}
