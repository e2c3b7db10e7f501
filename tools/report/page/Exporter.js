// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shown segments as meshes, without the tool: in triangles, with coordinates as exact as the page has them.

"use strict";

class Exporter
{
  constructor(editor) { this.editor = editor; }

  get model() { return this.editor.model; }

  // Those of the file.
  coordinates([x, y, z])
  {
    const {center, radius} = this.model.data.mesh;
    return [x, y, z].map((value, c) => Number((center[c] + radius * value).toPrecision(7))).join(" ");
  }

  trianglesOf(segment)
  {
    const {triangles} = this.model;
    const result = [];
    for (let t = 0; t < triangles.length / 3; ++t)
      if (segment === undefined || this.model.segmentOfFace(this.model.faceOfTriangle(t)) === segment)
        result.push([triangles[3 * t], triangles[3 * t + 1], triangles[3 * t + 2]]);
    return result;
  }

  // The edges of triangles that no other triangle has the other way, as closed walks that come to no point twice.
  static loops(triangles)
  {
    const ends = new Map(); // of the edges from a point
    for (const triangle of triangles)
      triangle.forEach((a, i) => ends.set(a, [...(ends.get(a) ?? []), triangle[(i + 1) % 3]]));
    const open = new Map();
    for (const [a, all] of ends)
      open.set(a, all.filter(b => !(ends.get(b) ?? []).includes(a)));
    const loops = [];
    for (const begin of open.keys())
      for (let walk = [begin]; (open.get(walk[walk.length - 1]) ?? []).length > 0;)
      {
        const next = open.get(walk[walk.length - 1]).pop();
        const place = walk.indexOf(next);
        if (place >= 0)
          loops.push(walk.splice(place));
        walk.push(next);
      }
    return loops;
  }

  subtree(segment) { return [segment, ...this.model.children(segment).flatMap(s => this.subtree(s))]; }

  // Of each shown segment the triangles, closed where protrusions were cut off: by a fan around the mean of the rim, for the
  // protrusion and turned over for what it sticks out of. So volumes add up to that of the mesh. What is open stays open.
  closedParts()
  {
    const points = Array.from({length: this.model.positions.length / 3}, (_, v) => this.model.point(v));
    const parts = new Map(this.model.shownSegments().map(s => [s, this.trianglesOf(s)]));
    const triangles = new Map(parts);
    const isOpen = new Set(Exporter.loops(this.trianglesOf()).flat());
    for (const segment of parts.keys())
    {
      if (this.model.isBody(segment))
        continue;
      const parent = this.model.ancestors[this.model.protrusions.get(segment).parent];
      for (const loop of Exporter.loops(this.subtree(segment).flatMap(s => triangles.get(s))))
      {
        if (loop.some(v => isOpen.has(v)))
          continue;
        const middle = points.push([0, 1, 2].map(c => loop.reduce((sum, v) => sum + points[v][c], 0) / loop.length)) - 1;
        const edges = loop.map((v, i) => [v, loop[(i + 1) % loop.length]]);
        parts.set(segment, [...parts.get(segment), ...edges.map(([a, b]) => [b, a, middle])]);
        parts.set(parent, [...parts.get(parent), ...edges.map(([a, b]) => [a, b, middle])]);
      }
    }
    return new Map([...parts].map(([segment, faces]) => [segment, Exporter.withOwnPoints(points, faces)]));
  }

  static withOwnPoints(points, faces)
  {
    const numbers = new Map();
    for (const v of faces.flat())
      if (!numbers.has(v))
        numbers.set(v, numbers.size);
    return {points: Array.from(numbers.keys(), v => points[v]), faces: faces.map(face => face.map(v => numbers.get(v)))};
  }

  // In one word, for all formats and for names of files.
  nameOf(segment)
  {
    const name = this.editor.names.get(segment) ?? `segment_${this.model.savedNumbers().get(segment)}`;
    return name.replace(/[^\p{L}\p{N}_.-]+/gu, "_");
  }

  // All triangles, coloured, with the number under which their segment is saved.
  plyText()
  {
    const {positions} = this.model;
    const numbers = this.model.savedNumbers();
    const triangles = this.trianglesOf();
    const lines = ["ply", "format ascii 1.0", `element vertex ${positions.length / 3}`,
                   ...["x", "y", "z"].map(name => `property double ${name}`), `element face ${triangles.length}`,
                   "property list uchar int vertex_indices", "property uint segment",
                   ...["red", "green", "blue"].map(name => `property uchar ${name}`), "end_header"];
    for (let v = 0; v < positions.length / 3; ++v)
      lines.push(this.coordinates(this.model.point(v)));
    triangles.forEach((triangle, t) =>
    {
      const segment = this.model.segmentOfFace(this.model.faceOfTriangle(t));
      lines.push(["3", ...triangle, numbers.get(segment), ...this.model.colors[segment]].join(" "));
    });
    return lines.join("\n") + "\n";
  }

  // The closed parts as objects.
  objText()
  {
    const lines = [];
    let before = 1;
    for (const [segment, {points, faces}] of this.closedParts())
    {
      lines.push(`o ${this.nameOf(segment)}`);
      const first = before; // of its points
      points.forEach(p => lines.push(`v ${this.coordinates(p)}`));
      faces.forEach(face => lines.push(`f ${face.map(i => i + first).join(" ")}`));
      before += points.length;
    }
    return lines.join("\n") + "\n";
  }

  // One closed part.
  stlText(segment)
  {
    const {points, faces} = this.closedParts().get(segment);
    const facets = faces.map(face => "facet normal 0 0 0\nouter loop\n" +
      face.map(i => `vertex ${this.coordinates(points[i])}\n`).join("") + "endloop\nendfacet\n");
    return `solid ${this.nameOf(segment)}\n${facets.join("")}endsolid ${this.nameOf(segment)}\n`;
  }
}
