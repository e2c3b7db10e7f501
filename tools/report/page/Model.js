// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the tool wrote, as arrays, and the segments that are left when some cuts are taken back.

"use strict";

function decode(base64, Type)
{
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i)
    bytes[i] = text.charCodeAt(i);
  return new Type(bytes.buffer);
}

function typeOfBytes(bytes) { return {1: Uint8Array, 2: Uint16Array, 4: Uint32Array}[bytes]; }

class Model
{
  constructor(data)
  {
    this.data = data;
    const {mesh} = data;
    // from whole numbers of 16 bits to a ball of radius one
    this.positions = Float32Array.from(decode(mesh.positions, Uint16Array), x => x / 32767.5 - 1);
    this.triangles = decode(mesh.triangles, typeOfBytes(mesh.index_bytes));
    this.faces = mesh.faces === null ? null : decode(mesh.faces, Uint32Array); // of the triangles; null: they are faces
    this.segments = decode(mesh.segments, typeOfBytes(mesh.segment_bytes)); // of the faces, the finest
    this.borders = decode(mesh.borders, Uint32Array); // vertex, vertex, segment, segment
    this.colors = data.colors; // of the segments
    this.maximum = data.segments;
    this.minimum = data.segments - data.protrusions.length; // one for each connected component
    this.protrusions = new Map(data.protrusions.map(protrusion => [protrusion.segment, protrusion]));
    this.facesOfSegments = new Uint32Array(this.maximum);
    for (const segment of this.segments)
      ++this.facesOfSegments[segment];
    this.setLevel(this.maximum);
  }

  // With one segment less, the last protrusion is given to its parent, or to the nearest ancestor that is left.
  setLevel(numberOfSegments)
  {
    this.setJoined(new Set([...this.protrusions.keys()].slice(numberOfSegments - this.minimum)));
  }

  // Is it what the slider shows?
  isLevel() { return [...this.protrusions.keys()].slice(this.number - this.minimum).every(s => this.joined.has(s)); }

  // `joined`: the protrusions whose cuts are taken back
  setJoined(joined)
  {
    this.joined = joined;
    this.number = this.maximum - joined.size;
    this.ancestors = new Uint32Array(this.maximum);
    this.faceCounts = new Uint32Array(this.maximum);
    for (let s = 0; s < this.maximum; ++s)
    {
      this.ancestors[s] = this.ancestor(s);
      this.faceCounts[this.ancestors[s]] += this.facesOfSegments[s];
    }
  }

  // Shows the smallest protrusions around these faces, besides those that are shown.
  addTips(faces)
  {
    const added = new Set(faces.map(face => this.segments[face]));
    this.setJoined(new Set([...this.joined].filter(s => !added.has(s))));
  }

  // Is there a smaller segment around a face than the one that is shown?
  hasSmallerSegment(face) { return this.joined.has(this.segments[face]); }

  ancestor(segment)
  {
    while (this.joined.has(segment))
      segment = this.protrusions.get(segment).parent;
    return segment;
  }

  isBody(segment) { return !this.protrusions.has(segment); }

  isShown(segment) { return segment < this.maximum && !this.joined.has(segment); }

  shownSegments() { return Array.from({length: this.maximum}, (_, s) => s).filter(s => !this.joined.has(s)); }

  faceOfTriangle(triangle) { return this.faces === null ? triangle : this.faces[triangle]; }

  segmentOfFace(face) { return this.ancestors[this.segments[face]]; }

  children(segment)
  {
    return this.data.protrusions.filter(p => !this.joined.has(p.segment) && this.ancestors[p.parent] === segment)
      .map(p => p.segment);
  }

  // Of the border of a protrusion: its probability, or its value if the method does not estimate that.
  sureness(segment)
  {
    const {probability, value} = this.protrusions.get(segment);
    return probability ?? value;
  }

  // The least sureness of a border of a segment; infinity if there is none.
  confidence(segment)
  {
    const borders = this.children(segment);
    if (this.protrusions.has(segment))
      borders.push(segment);
    return Math.min(...borders.map(border => this.sureness(border) ?? Infinity));
  }

  // Segments that were given, not found, have borders without probabilities and values.
  hasConfidence() { return this.data.protrusions.some(p => this.sureness(p.segment) !== null); }

  // The ends of the scale of confidence: probabilities from 0 to 1, or the least and the largest value of a border.
  scale()
  {
    if (this.data.protrusions.every(p => p.probability !== null))
      return [0, 1];
    const values = this.data.protrusions.map(p => p.value);
    return [Math.min(...values), Math.max(...values)];
  }

  centroid(face)
  {
    let first = face;
    if (this.faces !== null) // ascending
      for (let low = 0, high = this.faces.length; low < high;)
      {
        const middle = (low + high) >> 1;
        if (this.faces[middle] < face)
          low = middle + 1;
        else
          high = middle;
        first = low;
      }
    const sum = [0, 0, 0];
    let count = 0;
    for (let t = first; t === first || (this.faces !== null && this.faces[t] === face); ++t)
      for (let corner = 0; corner < 3; ++corner, ++count)
        for (let c = 0; c < 3; ++c)
          sum[c] += this.positions[3 * this.triangles[3 * t + corner] + c];
    return sum.map(x => x / count);
  }

  // A face on a protrusion as it is shown: its tip, or, if another protrusion took that, the face farthest from the border.
  // None for a body.
  tip(segment)
  {
    const protrusion = this.protrusions.get(segment);
    if (!protrusion)
      return undefined;
    return this.segmentOfFace(protrusion.tip) === segment ? protrusion.tip : this.farthestFace(segment);
  }

  // The face of a shown segment that is farthest from the middle of its borders.
  farthestFace(segment)
  {
    const ends = this.borderEdges(segment).flat().map(v => this.point(v));
    const center = [0, 1, 2].map(c => ends.reduce((sum, p) => sum + p[c], 0) / Math.max(1, ends.length));
    let [best, farthest] = [undefined, -1];
    for (let face = 0; face < this.segments.length; ++face)
      if (this.segmentOfFace(face) === segment)
      {
        const point = this.centroid(face);
        const distance = Math.hypot(...point.map((x, c) => x - center[c]));
        if (distance > farthest)
          [best, farthest] = [face, distance];
      }
    return best;
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

  // The first triangle on a ray, by the algorithm of Moeller and Trumbore (1997); -1 if there is none. Without an object for
  // each triangle, a million of them take some hundredths of a second.
  firstTriangle([px, py, pz], [dx, dy, dz])
  {
    const {positions: p, triangles} = this;
    let [best, nearest] = [-1, Infinity];
    for (let t = 0; t < triangles.length; t += 3)
    {
      const [a, b, c] = [3 * triangles[t], 3 * triangles[t + 1], 3 * triangles[t + 2]];
      const ex = p[b] - p[a], ey = p[b + 1] - p[a + 1], ez = p[b + 2] - p[a + 2];
      const fx = p[c] - p[a], fy = p[c + 1] - p[a + 1], fz = p[c + 2] - p[a + 2];
      const hx = dy * fz - dz * fy, hy = dz * fx - dx * fz, hz = dx * fy - dy * fx;
      const determinant = ex * hx + ey * hy + ez * hz;
      if (determinant === 0)
        continue;
      const sx = px - p[a], sy = py - p[a + 1], sz = pz - p[a + 2];
      const u = (sx * hx + sy * hy + sz * hz) / determinant;
      if (u < 0 || u > 1)
        continue;
      const qx = sy * ez - sz * ey, qy = sz * ex - sx * ez, qz = sx * ey - sy * ex;
      const v = (dx * qx + dy * qy + dz * qz) / determinant;
      if (v < 0 || u + v > 1)
        continue;
      const distance = (fx * qx + fy * qy + fz * qz) / determinant;
      if (distance > 0 && distance < nearest)
        [best, nearest] = [t / 3, distance];
    }
    return best;
  }

  point(vertex) { return Array.from(this.positions.subarray(3 * vertex, 3 * vertex + 3)); }

  // The numbers under which the shown segments are saved, 0, 1, 2 ...
  savedNumbers() { return new Map(this.shownSegments().map((segment, i) => [segment, i])); }

  // One segment a line, for each face.
  segText()
  {
    const numbers = this.savedNumbers();
    const lines = Array.from(this.ancestors, segment => String(numbers.get(segment)));
    return Array.from(this.segments, segment => lines[segment]).join("\n") + "\n";
  }
}
