// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tool wrote, as arrays, and the segments at every number of segments.

"use strict";

function decode(base64, Type)
{
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

class Model
{
  constructor(data)
  {
    this.data = data;
    this.positions = decode(data.mesh.positions, Float32Array);
    this.triangles = decode(data.mesh.triangles, Uint32Array);
    this.faces = decode(data.mesh.faces, Uint32Array); // of the triangles
    this.segments = decode(data.mesh.segments, Uint32Array); // of the faces, the finest
    this.borders = decode(data.mesh.borders, Uint32Array); // vertex, vertex, segment, segment
    this.colors = data.colors; // of the segments
    this.maximum = data.segments;
    this.minimum = data.segments - data.protrusions.length; // one for each connected component
    this.protrusions = new Map(data.protrusions.map(protrusion => [protrusion.segment, protrusion]));
    this.setLevel(this.maximum);
  }

  // With one segment less, the last segment is given to its parent, or to the nearest ancestor that is left.
  setLevel(numberOfSegments)
  {
    this.level = numberOfSegments;
    this.ancestors = new Uint32Array(this.maximum);
    for (let s = 0; s < this.maximum; ++s)
      this.ancestors[s] = this.ancestor(s);
    this.faceCounts = new Uint32Array(this.maximum);
    for (const segment of this.segments)
      ++this.faceCounts[this.ancestors[segment]];
  }

  ancestor(segment)
  {
    while (segment >= this.level)
      segment = this.protrusions.get(segment).parent;
    return segment;
  }

  segmentOfTriangle(triangle) { return this.ancestors[this.segments[this.faces[triangle]]]; }

  children(segment)
  {
    return this.data.protrusions.filter(p => p.segment < this.level && this.ancestors[p.parent] === segment)
      .map(p => p.segment);
  }

  centroid(face)
  {
    const sum = [0, 0, 0];
    let count = 0;
    for (let t = this.faces.indexOf(face); this.faces[t] === face; ++t)
      for (let corner = 0; corner < 3; ++corner, ++count)
        for (let c = 0; c < 3; ++c)
          sum[c] += this.positions[3 * this.triangles[3 * t + corner] + c];
    return sum.map(x => x / count);
  }

  // The ends of all edges between two segments; with `segment`, only of its own border.
  borderEdges(segment)
  {
    const edges = [];
    for (let i = 0; i < this.borders.length; i += 4)
    {
      const sides = [this.ancestors[this.borders[i + 2]], this.ancestors[this.borders[i + 3]]];
      if (sides[0] !== sides[1] && (segment === undefined || sides.includes(segment)))
        edges.push([this.borders[i], this.borders[i + 1]]);
    }
    return edges;
  }

  point(vertex) { return Array.from(this.positions.subarray(3 * vertex, 3 * vertex + 3)); }
}
