#!/usr/bin/env python3
# Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
#
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the figures of the user manual from the output of the package's own tools.

    scripts/manual/make_figures.py FOLDER [--spot FILE] [--only NAME...]

FOLDER, or a folder in it, holds the programs segment_by_protrusions and make_example_mesh, for instance
build/demo. Needed besides, all from Debian: f3d and xvfb, which
render the pictures, imagemagick, which makes them brighter and small, and chromium, which shows the
page of --report. FILE is the triangle mesh of Spot, the cow by Keenan Crane (public domain, CC0), which is no part of the
package: without it the figure `gallery` is not made.
"""

import argparse
import heapq
import json
import math
import pathlib
import struct
import subprocess
import tempfile

FIGURES = pathlib.Path(__file__).resolve().parents[2] / "doc/Protrusion_segmentation/fig"
TOOL_FIGURES = pathlib.Path(__file__).resolve().parent / "standalone"
FACES = 16000

# the number of segments, and where the camera stands as seen from the shape
SHAPES = {
    "octopus": (9, (7, -6, 6)),
    "teddy": (8, (8, -3, 1.5)),
    "hand": (6, (9, -1, 1)),
    "horse": (7, (4, -9, 1.5)),
    "chair": (6, (7, -5, 3)),
    "spot": (9, (-3, 4, 1.2)),
}
OWN_SHAPES = [shape for shape in SHAPES if shape != "spot"]
PLAIN = (205, 205, 200)
RED, BLUE, ORANGE = (200, 40, 40), (60, 110, 190), (235, 150, 40)
# one colour for each group of ten slots, from near to far
SLOT_GROUPS = [(68, 1, 84), (72, 40, 120), (62, 74, 137), (49, 104, 142), (38, 130, 142),
               (31, 158, 137), (53, 183, 121), (109, 205, 89), (180, 222, 44), (253, 231, 37)]


# ---- vectors and meshes ----

def add(a, b, factor=1.0):
    return tuple(x + factor * y for x, y in zip(a, b))


def subtract(a, b):
    return add(a, b, -1.0)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    length = math.sqrt(dot(a, a))
    return tuple(x / length for x in a) if length > 0 else (0.0, 0.0, 1.0)


class Mesh:
    """Triangles of an OFF file, with the colours of the faces if it has any."""

    def __init__(self, file):
        rows = [line.split() for line in file.read_text(encoding="ascii").splitlines()
                if line.strip() and not line.startswith("#")]
        counts = rows[1] if len(rows[0]) == 1 else rows[0][1:]
        first_vertex = 2 if len(rows[0]) == 1 else 1
        first_face = first_vertex + int(counts[0])
        self.points = [tuple(map(float, row[:3])) for row in rows[first_vertex:first_face]]
        faces = rows[first_face:first_face + int(counts[1])]
        self.faces = [tuple(map(int, row[1:4])) for row in faces]
        self.colors = [tuple(map(int, row[4:7])) for row in faces]
        self.centroids = [tuple(sum(self.points[v][i] for v in face) / 3 for i in range(3))
                          for face in self.faces]

    def normals(self):
        """Of the vertices: the mean over the faces around, by area."""
        sums = [(0.0, 0.0, 0.0)] * len(self.points)
        for a, b, c in self.faces:
            normal = cross(subtract(self.points[b], self.points[a]),
                           subtract(self.points[c], self.points[a]))
            for v in (a, b, c):
                sums[v] = add(sums[v], normal)
        return [unit(normal) for normal in sums]

    def dual_graph(self):
        """The neighbours of each face with the distances of the centroids."""
        faces_at_edge = {}
        for f, (a, b, c) in enumerate(self.faces):
            for edge in ((a, b), (b, c), (c, a)):
                faces_at_edge.setdefault((min(edge), max(edge)), []).append(f)
        graph = [[] for _ in self.faces]
        for pair in faces_at_edge.values():
            if len(pair) == 2:
                f, g = pair
                length = math.dist(self.centroids[f], self.centroids[g])
                graph[f].append((g, length))
                graph[g].append((f, length))
        return graph


def shortest_paths(graph, source):
    """The distance of each face from `source`, and the face before it on the way."""
    distances = [math.inf] * len(graph)
    before = [None] * len(graph)
    distances[source] = 0.0
    queue = [(0.0, source)]
    while queue:
        distance, face = heapq.heappop(queue)
        if distance > distances[face]:
            continue
        for neighbor, length in graph[face]:
            if distance + length < distances[neighbor]:
                distances[neighbor] = distance + length
                before[neighbor] = face
                heapq.heappush(queue, (distances[neighbor], neighbor))
    return distances, before


# ---- pictures ----

class Scene:
    """Coloured triangles with normals at their corners."""

    def __init__(self):
        self.corners = []  # (point, normal, color), three for each triangle

    def add_mesh(self, mesh, colors):
        normals = mesh.normals()
        for face, color in zip(mesh.faces, colors):
            self.corners += [(mesh.points[v], normals[v], color) for v in face]

    def add_sphere(self, center, radius, color, steps=12):
        def corner(i, j):
            theta, phi = math.pi * i / steps, math.pi * j / steps
            normal = (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi),
                      math.cos(theta))
            return (add(center, normal, radius), normal, color)
        for i in range(steps):
            for j in range(2 * steps):
                self.corners += [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1),
                                 corner(i, j), corner(i + 1, j + 1), corner(i, j + 1)]

    def add_line(self, points, radius, color):
        """A chain of overlapping spheres."""
        for a, b in zip(points, points[1:]):
            count = max(1, math.ceil(math.dist(a, b) / (0.5 * radius)))
            for i in range(count + 1):
                self.add_sphere(add(a, subtract(b, a), i / count), radius, color, steps=5)

    def write_ply(self, file):
        header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(self.corners)}"]
        header += [f"property float {name}" for name in ("x", "y", "z", "nx", "ny", "nz")]
        header += [f"property uchar {name}" for name in ("red", "green", "blue")]
        header += [f"element face {len(self.corners) // 3}",
                   "property list uchar int vertex_indices", "end_header\n"]
        with open(file, "wb") as out:
            out.write("\n".join(header).encode())
            for point, normal, color in self.corners:
                out.write(struct.pack("<6f3B", *point, *normal, *color))
            for i in range(0, len(self.corners), 3):
                out.write(struct.pack("<B3i", 3, i, i + 1, i + 2))

    def view(self, direction):
        """Focal point, half extents across and up, and depth, as seen from `direction`."""
        right = unit(cross((0, 0, 1), direction))
        up = cross(direction, right)
        ranges = []
        for axis in (right, up, direction):
            values = [dot(point, axis) for point, _, _ in self.corners]
            ranges.append((min(values), max(values)))
        focus = (0.0, 0.0, 0.0)
        for (low, high), axis in zip(ranges, (right, up, direction)):
            focus = add(focus, axis, (low + high) / 2)
        return focus, [(high - low) / 2 for low, high in ranges]

    def render(self, name, direction, area=75000):
        """A picture of about `area` pixels in the format of the shape."""
        view_angle = 20
        direction = unit(direction)
        focus, (across, upward, depth) = self.view(direction)
        distance = 1.04 * upward / math.tan(math.radians(view_angle / 2)) + depth
        camera = add(focus, direction, distance)
        width = round(math.sqrt(area * across / upward))
        with tempfile.TemporaryDirectory() as folder:
            ply, png = f"{folder}/scene.ply", f"{folder}/scene.png"
            self.write_ply(ply)
            subprocess.run(
                ["xvfb-run", "-a", "f3d", ply, "--output", png, "--dry-run", "--quiet",
                 f"--resolution={2 * width},{2 * round(area / width)}", "--up=+Z", "--bg-color=1,1,1",
                 "--scalars=RGB", "--comp=-2", "--roughness=0.6", "--fxaa",
                 f"--camera-view-angle={view_angle}",
                 "--camera-position=" + ",".join(f"{x:.6f}" for x in camera),
                 "--camera-focal-point=" + ",".join(f"{x:.6f}" for x in focus)],
                check=True, timeout=300)
            # f3d's light leaves white at little more than half
            subprocess.run(["convert", png, "-level", "0%,62%", "-resize", "50%", "-strip", "+dither",
                            "-colors", "128", "-white-threshold", "97%", f"PNG8:{FIGURES / name}"],
                           check=True)


def write_histogram(name, values, slot, title, label):
    """Bars for the slots as SVG, the bar of `slot` in red."""
    width, height, left, top = 320, 180, 50, 30
    step, highest = width / len(values), max(values)
    bars = "".join(
        f'<rect x="{left + i * step:.1f}" y="{top + height * (1 - value / highest):.1f}" '
        f'width="{step:.1f}" height="{height * value / highest:.1f}" '
        f'fill="{"#c82828" if i == slot else "#6c8ebf"}"/>\n' for i, value in enumerate(values))
    ticks = "".join(f'<text x="{left + i * step:.1f}" y="{top + height + 16}" '
                    f'text-anchor="middle">{i}</text>\n' for i in range(0, len(values) + 1, 10))
    x = left + (slot + 0.5) * step
    (FIGURES / name).write_text(f"""<?xml version="1.0" encoding="UTF-8"?>
<svg xmlns="http://www.w3.org/2000/svg" width="{width + left + 20}" height="{height + top + 45}"
     font-family="sans-serif" font-size="12">
<rect width="100%" height="100%" fill="white"/>
<text x="{left + width / 2}" y="16" text-anchor="middle" font-size="14">{title}</text>
{bars}<line x1="{x:.1f}" x2="{x:.1f}" y1="{top}" y2="{top + height}" stroke="#c82828" stroke-dasharray="4 3"/>
<text x="{x + 5:.1f}" y="{top + 12}" fill="#c82828">slot {slot}</text>
<path d="M{left} {top}V{top + height}H{left + width}" fill="none" stroke="black"/>
{ticks}<text x="{left + width / 2}" y="{top + height + 36}" text-anchor="middle">slot</text>
<text x="{left - 6}" y="{top + 10}" text-anchor="end">{highest:.3g}</text>
<text x="{left - 6}" y="{top + height}" text-anchor="end">0</text>
<text transform="translate(16 {top + height / 2}) rotate(-90)" text-anchor="middle">{label}</text>
</svg>
""", encoding="utf-8")


# ---- figures ----

class Workshop:
    """Runs the tools and keeps what they made."""

    def __init__(self, programs, folder, spot):
        self.spot = spot
        self.programs = {name: next(file for file in sorted(programs.rglob(name)) if file.is_file())
                         for name in ("make_example_mesh", "segment_by_protrusions")}
        self.folder = folder

    def mesh_file(self, shape):
        if shape == "spot":
            return self.spot
        file = self.folder / f"{shape}.off"
        if not file.exists():
            subprocess.run([self.programs["make_example_mesh"], shape, file, "--faces", str(FACES)],
                           check=True, stdout=subprocess.DEVNULL)
        return file

    def segment(self, shape, *options, segments=None):
        """The mesh coloured by segment, its segment ids, and the JSON record."""
        k = str(segments or SHAPES[shape][0])
        out = self.folder / "_".join([shape, k, *map(str, options)]).replace("/", "-")
        files = {kind: out.with_suffix(out.suffix + kind) for kind in (".off", ".seg", ".json")}
        subprocess.run([self.programs["segment_by_protrusions"], self.mesh_file(shape), "-k", k,
                        "-o", files[".off"], "-o", files[".seg"], "--json", files[".json"],
                        "--quiet", *options], check=True)
        ids = [int(line) for line in files[".seg"].read_text(encoding="ascii").split()]
        return Mesh(files[".off"]), ids, json.loads(files[".json"].read_text(encoding="utf-8"))


def show(mesh, colors, name, shape, **size):
    scene = Scene()
    scene.add_mesh(mesh, colors)
    scene.render(name, SHAPES[shape][1], **size)


def join(pictures, name, height, rows=1):
    """One picture of several side by side, in rows."""
    count = -(-len(pictures) // rows)
    arguments = ["-background", "white", "-gravity", "center"]
    for i in range(0, len(pictures), count):
        arguments += ["(", *pictures[i:i + count], "-resize", f"x{height}", "-bordercolor", "white", "-border", "6x0", "+append",
                      ")"]
    subprocess.run(["convert", *arguments, "-append", "-strip", "+dither", "-colors", "128", "-white-threshold", "97%",
                    f"PNG8:{FIGURES / name}"], check=True)


def nested(workshop):
    """Fig. 1 of the paper: protrusions that have protrusions."""
    mesh, ids, record = workshop.segment("teddy", "--method", "minimum-cut", segments=8)
    parent = {protrusion["segment"]: protrusion["parent"] for protrusion in record["protrusions"]}
    color = dict(zip(ids, mesh.colors))
    for k in (3, 6, 8):
        colors = []
        for segment in ids:
            while segment >= k:
                segment = parent[segment]
            colors.append(color[segment])
        show(mesh, colors, f"nested_{k}.png", "teddy")


def tips(record):
    return [protrusion["tip"] for protrusion in record["protrusions"]]


def surface_distance(workshop):
    """Fig. 3: a path on the surface and a straight line between the tips of two arms."""
    mesh, _, record = workshop.segment("octopus", "--method", "minimum-cut")
    graph = mesh.dual_graph()
    arms = sorted(record["protrusions"], key=lambda protrusion: protrusion["area"])[-8:]
    pairs = [(a["tip"], b["tip"]) for a in arms for b in arms if a["tip"] < b["tip"]]
    # of the pairs, the one in front of the camera
    direction = SHAPES["octopus"][1]
    start, end = max(pairs, key=lambda pair: sum(dot(mesh.centroids[f], direction) for f in pair))
    before = shortest_paths(graph, start)[1]
    path = [end]
    while path[-1] != start:
        path.append(before[path[-1]])
    scene = Scene()
    scene.add_mesh(mesh, [PLAIN] * len(mesh.faces))
    scene.add_line([mesh.centroids[f] for f in path], 0.04, RED)
    scene.add_line([mesh.centroids[start], mesh.centroids[end]], 0.04, BLUE)
    for face in (start, end):
        scene.add_sphere(mesh.centroids[face], 0.12, ORANGE)
    scene.render("surface_distance.png", direction, area=110000)


def tip_spheres(workshop):
    """Fig. 4: tips of protrusions as spheres."""
    for shape in OWN_SHAPES:
        direction = SHAPES[shape][1]
        mesh, _, record = workshop.segment(shape, "--method", "paper")
        scene = Scene()
        scene.add_mesh(mesh, [PLAIN] * len(mesh.faces))
        for tip in tips(record):
            scene.add_sphere(mesh.centroids[tip], 0.14, RED)
        scene.render(workshop.folder / f"tips_{shape}.png", direction)
    join([workshop.folder / f"tips_{shape}.png" for shape in OWN_SHAPES], "tips.png", 180)


def slots(workshop):
    """Figs. 5 to 7: slots of the distance as colours, and both histograms."""
    mesh, _, record = workshop.segment("chair", "--method", "paper")
    protrusion = record["protrusions"][0]
    distances = shortest_paths(mesh.dual_graph(), protrusion["tip"])[0]
    farthest = max(distances)
    show(mesh, [SLOT_GROUPS[min(9, int(10 * d / farthest))] for d in distances], "slots.png", "chair",
         area=110000)
    write_histogram("distance_histogram.svg", protrusion["distance_histogram"],
                    protrusion["border_slot"], "Distance histogram", "faces")
    write_histogram("diameter_histogram.svg", protrusion["sectional_diameter_histogram"],
                    protrusion["border_slot"], "Sectional-diameter histogram", "diameter")


def gallery(workshop):
    """Fig. 8: segmentations of all shapes, and of a mesh that many know."""
    if not workshop.spot:
        return
    order = ["spot", "octopus", "teddy", "horse", "chair", "hand"]
    for shape in order:
        mesh, _, _ = workshop.segment(shape, "--method", "minimum-cut", "--smooth-borders")
        if shape == "spot":  # whose second coordinate goes upwards
            mesh.points = [(x, -z, y) for x, y, z in mesh.points]
        show(mesh, mesh.colors, workshop.folder / f"gallery_{shape}.png", shape, area=250000)
        if shape == "horse":
            show(mesh, mesh.colors, "package.png", shape, area=22500)
    join([workshop.folder / f"gallery_{shape}.png" for shape in order], "readme.png", 270, rows=2)


def smooth_borders(workshop):
    """Borders along edges, and smooth ones: a teddy bear from near."""
    names = []
    for options in ((), ("--smooth-borders",)):
        mesh, _, _ = workshop.segment("teddy", "--method", "minimum-cut", *options)
        names.append(workshop.folder / f"borders_{len(names)}.png")
        show(mesh, mesh.colors, names[-1], "teddy", area=500000)
        subprocess.run(["convert", names[-1], "-gravity", "center", "-crop", "60%x40%+0-120", "+repage", names[-1]],
                       check=True)
    join(names, "smooth_borders.png", 260)


def report(workshop):
    """The page of --report with a segment that is selected."""
    page = workshop.folder / "octopus.html"
    workshop.segment("octopus", "--method", "paper", "--report", page)
    picture = workshop.folder / "report.png"
    subprocess.run(["chromium", "--headless=new", "--no-sandbox", "--use-angle=swiftshader",
                    "--enable-unsafe-swiftshader", "--window-size=1200,980", f"--screenshot={picture}",
                    "--virtual-time-budget=20000", f"{page.resolve().as_uri()}#8"],
                   check=True, timeout=300, capture_output=True)
    subprocess.run(["convert", picture, "-resize", "900x", "-strip", "+dither", "-colors", "96",
                    f"PNG8:{TOOL_FIGURES / 'report.png'}"], check=True)


def landmarks(workshop):
    """Figs. 9 and 10: the geodesic distance against its approximations by landmarks."""
    for shape, height in (("octopus", 140), ("chair", 300)):
        names = []
        for name, options in (("GD", []), *((f"LGD{n}", ["--distance", "landmark", "--landmarks", f"{n}%"])
                                            for n in (10, 5, 1))):
            mesh, _, _ = workshop.segment(shape, "--method", "paper", *options)
            names.append(workshop.folder / f"{shape}_{name}.png")
            show(mesh, mesh.colors, names[-1], shape)
        join(names, f"landmarks_{shape}.png", height)


def main():
    figures = {f.__name__: f for f in (nested, surface_distance, tip_spheres, slots, gallery,
                                     smooth_borders, report, landmarks)}
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("programs", type=pathlib.Path, help="folder of the built tools")
    parser.add_argument("--spot", type=pathlib.Path, help="mesh file of Spot, for the figure gallery")
    parser.add_argument("--only", nargs="+", choices=figures, default=list(figures))
    parser.add_argument("--work", type=pathlib.Path, help="folder to keep meshes and segmentations in")
    arguments = parser.parse_args()
    FIGURES.mkdir(exist_ok=True)
    with tempfile.TemporaryDirectory() as temporary:
        folder = arguments.work or pathlib.Path(temporary)
        folder.mkdir(parents=True, exist_ok=True)
        workshop = Workshop(arguments.programs.resolve(), folder.resolve(), arguments.spot)
        for name in arguments.only:
            figures[name](workshop)


if __name__ == "__main__":
    main()
