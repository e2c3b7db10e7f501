// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later

#include "random_shapes.h"

#include "body_functions.h"
#include "shape_meshes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <random>
#include <utility>

namespace {

using namespace body_functions;
using namespace test_meshes;

// Uniform numbers that are the same on every machine.
class Random
{
public:
  explicit Random(std::uint32_t seed) : m_generator(seed) {}

  double in(double low, double high) { return low + (high - low) * double(m_generator()) / 4294967296.; }
  std::size_t below(std::size_t n) { return m_generator() % n; }
  std::size_t from_to(std::size_t low, std::size_t high) { return low + below(high - low + 1); }
  bool happens(double probability) { return in(0, 1) < probability; }

  Point direction()
  {
    const double z = in(-1, 1), turn = in(0, 2 * pi), r = std::sqrt(1 - z * z);
    return {r * std::cos(turn), r * std::sin(turn), z};
  }

  // Up to `n` directions with angles of at least that cosine between them.
  std::vector<Point> directions(std::size_t n, double largest_cosine)
  {
    std::vector<Point> result;
    for (int trial = 0; trial < 300 && result.size() < n; ++trial)
    {
      const Point d = direction();
      bool is_free = true;
      for (const Point& other : result)
        is_free = is_free && dot(d, other) < largest_cosine;
      if (is_free)
        result.push_back(d);
    }
    return result;
  }

private:
  std::mt19937 m_generator;
};

Body random_body(Random& random, double size)
{
  const Point sizes = {size * random.in(.7, 1.5), size * random.in(.7, 1), size * random.in(.6, 1)};
  const double rounding = random.in(.02, .2);
  switch (random.below(4))
  {
  case 0: return ball({0, 0, 0}, size);
  case 1: return ellipsoid({0, 0, 0}, sizes);
  case 2: return box({0, 0, 0}, sizes, rounding);
  default: return cylinder({0, 0, -.7 * sizes[0]}, {0, 0, .7 * sizes[0]}, sizes[1], .05);
  }
}

// How far the body reaches that way.
double reach(const Body& body, const Point& direction)
{
  double t = 0;
  while (t < 3 && body(t * direction) < 0)
    t += .02;
  return t;
}

Shape pegs(Random& random)
{
  Shape shape;
  const double size = random.in(.7, 1.1), radius = random.in(.1, .28), length = random.in(.35, 1.1);
  shape.parts.push_back(random_body(random, size));
  const bool is_round = random.happens(.5);
  const double end = radius * random.in(.5, 1);
  const Body body = shape.parts[0];
  for (const Point& d : random.directions(random.from_to(1, 8), .55))
  {
    const Point tip = (reach(body, d) + length) * d;
    shape.parts.push_back(is_round ? tube({{0, 0, 0}, tip}, radius, end) : cylinder({0, 0, 0}, tip, radius));
  }
  return shape;
}

// A bent path from a point on, on the whole along a direction.
std::vector<Point> bent_path(Random& random, const Point& from, const Point& direction, double length, double bend)
{
  const Point turn = random.direction();
  const double waves = random.in(.5, 1.2);
  std::vector<Point> path;
  for (int i = 0; i <= 12; ++i)
  {
    const double t = i / 12.;
    path.push_back(from + t * length * direction + bend * length * t * std::sin(waves * pi * t) * turn);
  }
  return path;
}

Shape limbs(Random& random)
{
  Shape shape;
  const double size = random.in(.45, .8), radius = random.in(.12, .3), length = random.in(.8, 1.6);
  const double end = radius * random.in(.3, 1), bend = random.happens(.5) ? random.in(0, .35) : 0;
  const bool has_twigs = random.happens(.25), is_flat = random.happens(.3);
  shape.parts.push_back(random_body(random, size));
  const std::size_t number = random.from_to(2, is_flat ? 6 : 8);
  std::vector<Point> directions = is_flat ? std::vector<Point>() : random.directions(number, .5);
  for (std::size_t i = 0; is_flat && i < number; ++i)
    directions.push_back({std::cos(2 * pi * double(i) / double(number)), std::sin(2 * pi * double(i) / double(number)), 0});
  const Body body = shape.parts[0];
  for (const Point& d : directions)
  {
    const std::vector<Point> path = bent_path(random, .5 * size * d, d, length + reach(body, d) - .5 * size, bend);
    shape.parts.push_back(tube(path, radius, end));
    if (!has_twigs || !random.happens(.5))
      continue;
    const Point& at = path[8];
    const Point away = random.direction();
    const Point side = away + (.6 - dot(away, d)) * d;
    shape.parts.push_back(tube({at, at + random.in(.4, .7) / test_meshes::length(side) * side}, radius * .6, radius * .35));
  }
  return shape;
}

Shape animal(Random& random)
{
  Shape shape;
  const double length = random.in(.8, 1.3), thickness = random.in(.35, .55), leg = random.in(.1, .19);
  const double height = random.in(.8, 1.5), apart = thickness * random.in(.5, .75), shift = .75 * length;
  shape.parts.push_back(ellipsoid({0, 0, 0}, {length, thickness, thickness * random.in(.9, 1.2)}));
  for (const double x : {-shift, shift})
    for (const double y : {-apart, apart})
    {
      const double forwards = random.in(-.25, .25);
      shape.parts.push_back(tube({{x, y, -.1}, {x + forwards, y, -.1 - .5 * height}, {x + .3 * forwards, y, -.1 - height}},
                                 leg * 1.3, leg * .8));
    }
  const Point head = {length + random.in(.2, .6), 0, random.in(.3, .9)};
  const double skull_length = random.in(.28, .45);
  const Body skull = ellipsoid(head, {skull_length, .25, .26}), neck = tube({{.8 * length, 0, .1}, head}, .22, .18);
  shape.parts.push_back([=](const Point& p) { return (std::min)(skull(p), neck(p)); });
  if (random.happens(.8))
  {
    const double rise = random.in(-.5, .6), tail = random.in(.6, 1.2), radius = random.in(.08, .14);
    shape.parts.push_back(tube(bent_path(random, {-.9 * length, 0, .1}, {-.8, 0, rise}, tail, .2), radius, .06));
  }
  for (const double y : {-1., 1.})
    if (random.happens(.3))
      shape.parts.push_back(tube({head + .1 * Point{0, y, 1}, head + .32 * Point{0, y, 1.6}}, .09, .05));
  return shape;
}

Shape plate_with_pegs(Random& random)
{
  Shape shape;
  const double x = random.in(.8, 1.5), y = random.in(.7, 1.2), h = random.in(.06, .15), r = random.in(.08, .25);
  const double length = random.in(.5, 1.6), edge = random.in(.1, .3) + r;
  if (random.happens(.3))
    shape.parts.push_back(cylinder({0, 0, -h}, {0, 0, h}, (std::max)(x, y)));
  else
    shape.parts.push_back(box({0, 0, 0}, {x, y, h}));
  const bool is_round = random.happens(.5);
  const auto leg = [&](double px, double py, double side)
  {
    const Point from = {px, py, 0}, to = {px * random.in(1, 1.05), py, side * (h + length)};
    shape.parts.push_back(is_round ? tube({from, to}, r, r * .9) : cylinder(from, to, r));
  };
  const double side = random.happens(.5) ? 1 : -1;
  if (random.happens(.3))
  {
    const double py = random.in(-.4, .4) * y, px = random.in(-.4, .4) * x;
    leg(px, py, side);
  }
  else
    for (const double px : {edge - x, x - edge})
      for (const double py : {edge - y, y - edge})
        leg(.9 * px, .9 * py, side);
  if (shape.parts.size() > 2 && side < 0 && random.happens(.4)) // a back
    shape.parts.push_back(box({-.92 * x, 0, .8}, {h, .9 * y, .8}));
  return shape;
}

// Of a figure that is cut out of the plane z = 0.
std::vector<Body> parts_of_figure(Random& random)
{
  std::vector<Body> parts;
  const double size = random.in(.45, .8), radius = random.in(.12, .35) * size / .6;
  const double end = radius * random.in(.25, 1), length = random.in(.7, 1.3), start = random.in(0, 2 * pi);
  parts.push_back(random.happens(.6) ? ball({0, 0, 0}, size) : box({0, 0, 0}, {size, size * random.in(.7, 1.2), 1}, .1));
  const std::size_t number = random.below(7); // none: it is one part
  const double fits = number == 0 ? radius : (std::min)(radius, 2.2 * size / double(number));
  for (std::size_t i = 0; i < number; ++i)
  {
    const double turn = start + 2 * pi * (double(i) + random.in(-.12, .12)) / double(number);
    const Point d = {std::cos(turn), std::sin(turn), 0};
    parts.push_back(tube({.3 * size * d, (size + length) * d}, fits, (std::min)(fits, end)));
  }
  return parts;
}

Shape cookie(Random& random)
{
  Shape shape;
  const double h = random.in(.05, .28);
  for (const Body& part : parts_of_figure(random))
    shape.parts.push_back(plate(part, h));
  return shape;
}

Shape tube_of_one_part(Random& random)
{
  const double r = random.in(.1, .22), turns = random.in(1, 4), a = random.in(.3, .8), b = random.in(.3, 1.5);
  const std::size_t kind = random.below(4);
  std::vector<Point> path;
  for (int i = 0; i <= 160; ++i)
  {
    const double t = i / 160., u = 2 * pi * t;
    switch (kind)
    {
    case 0: path.push_back({1.1 * std::cos(turns * u), 1.1 * std::sin(turns * u), turns * t * 3.2 * r - 1}); break;
    case 1: path.push_back({3.6 * t - 1.8, a * std::sin(turns * 2 * t), a * std::cos(b + 3 * t)}); break;
    case 2: path.push_back({(1.3 + a * .7 * std::cos(3 * u)) * std::cos(2 * u), (1.3 + a * .7 * std::cos(3 * u)) * std::sin(2 * u),
                            (.45 + r) * std::sin(3 * u)}); break;
    default: path.push_back({1.5 * std::cos(u), b * std::sin(u), a * std::sin(2 * u)});
    }
  }
  Shape shape;
  shape.parts.push_back(tube(path, r, r));
  return shape;
}

Body rough(Random& random, Body body, double height, double frequency)
{
  std::vector<std::pair<Point, double>> waves;
  for (int i = 0; i < 12; ++i)
  {
    const double length = frequency * random.in(.6, 1.5);
    const Point wave = length * random.direction();
    waves.emplace_back(wave, random.in(0, 2 * pi));
  }
  return [=, body = std::move(body)](const Point& p)
  {
    double sum = 0;
    for (const auto& [wave, phase] : waves)
      sum += std::sin(dot(p, wave) + phase);
    return body(p) + height * sum / 12;
  };
}

// A body, in one half of the cases with limbs, that is full of valleys.
Shape rough_shape(Random& random)
{
  Shape shape;
  if (random.happens(.5))
    shape = limbs(random);
  else
    shape.parts.push_back(random_body(random, random.in(.8, 1.2)));
  const double frequency = random.in(9, 16), height = random.in(2, 3.5) / frequency;
  for (Body& part : shape.parts)
  {
    Random same_waves = random;
    part = rough(same_waves, part, height, frequency);
  }
  return shape;
}

Shape body_of_one_part(Random& random)
{
  Shape shape;
  const double size = random.in(.9, 1.3);
  Body body = random_body(random, size);
  const double low = random.in(.25, 1), frequency = random.in(2, 6);
  switch (random.below(7))
  {
  case 0: body = torus(1.2, random.in(.15, .6)); break;
  case 1: body = rough(random, body, low * .2, frequency * 2); break;
  case 2: body = rough(random, box({0, 0, -.6}, {2, 2, .5}), low * .5, frequency); break;
  case 3: body = plate(body, random.in(.05, .2)); break;
  case 4: // pockets or holes
  {
    const double floor = random.happens(.5) ? random.in(0, .3) : -2, r = random.in(.12, .22);
    body = box({0, 0, 0}, {1.4, 1, .15 + .45 * low});
    for (const double x : {-.9, 0., .9})
      for (const double y : {-.5, .5})
        if (random.happens(.7))
          body = without(body, cylinder({x, y, floor}, {x, y, 2}, r));
    break;
  }
  case 5: // a pot
    body = without(cylinder({0, 0, -1}, {0, 0, 1}, size), cylinder({0, 0, -.85 * low}, {0, 0, 2}, size * (.6 + .05 * frequency)));
    break;
  default: break;
  }
  shape.parts.push_back(body);
  return shape;
}

void add_noise(Random& random, Test_mesh& mesh, double height)
{
  for (Point& p : mesh.points)
  {
    const double length = random.in(-height, height);
    p = p + length * random.direction();
  }
}

// The upper side of a figure with some thickness.
Test_mesh sheet(Random& random)
{
  Shape shape;
  for (const Body& part : parts_of_figure(random))
    shape.parts.push_back(plate(part, .15));
  Test_mesh mesh = kept_faces(mesh_of(shape, random.in(28, 60)), [](const Point& p) { return p[2] > .1499; });
  const double round = random.in(-.15, .15), saddle = random.in(-.15, .15), share = random.below(3) / 2.;
  for (Point& p : mesh.points)
    p[2] = share * (round * (p[0] * p[0] + p[1] * p[1]) + saddle * (p[0] * p[0] - p[1] * p[1]));
  if (random.happens(.4))
    add_noise(random, mesh, std::pow(10, random.in(-4, -2.2)));
  return mesh;
}

} // namespace

const std::vector<std::string>& kinds_of_random_shapes()
{
  static const std::vector<std::string> kinds = {"Pegs", "Limbs", "Animals", "Plates", "Sheets", "Cookies", "Tubes", "Bodies", "Rough"};
  return kinds;
}

Test_mesh random_shape(std::size_t kind, std::uint32_t seed)
{
  Random random(seed);
  if (kinds_of_random_shapes().at(kind) == "Sheets")
    return sheet(random);
  Shape (*const makers[])(Random&) = {pegs,   limbs,  animal,           plate_with_pegs,
                                      nullptr, cookie, tube_of_one_part, body_of_one_part, rough_shape};
  Shape shape = makers[kind](random);
  shape.blend = random.happens(.2) ? 0 : random.in(.01, .07);
  const double finer = kinds_of_random_shapes()[kind] == "Rough" ? 1.6 : 1; // valleys are narrow
  Test_mesh mesh = mesh_of(shape, finer * random.in(22, 55));
  const double change = random.in(0, 1);
  if (change < .15)
    add_noise(random, mesh, random.in(.002, .012));
  else if (change < .4)
  {
    const Point up = change < .3 ? Point{0, 0, 1} : random.direction();
    double low = 1e9, high = -1e9;
    for (const Point& p : mesh.points)
    {
      low = (std::min)(low, dot(p, up));
      high = (std::max)(high, dot(p, up));
    }
    const double cut = low + (high - low) * (change < .3 ? random.in(.05, .2) : random.in(.3, .5));
    mesh = kept_faces(mesh, [&](const Point& p) { return dot(p, up) > cut; });
  }
  return mesh;
}
