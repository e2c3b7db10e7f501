// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh on the canvas: colours, borders, tips, turning by hand, and which face is clicked.
// Positions are such that the mesh is in a ball of radius one. Drawn only when something changed.

"use strict";

class View
{
  constructor(canvas, editor)
  {
    this.canvas = canvas;
    this.editor = editor;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.05, 100);
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 0.5));
    const light = new THREE.DirectionalLight(0xffffff, 0.55);
    light.position.set(-0.4, 0.6, 1); // of the camera, so that it stays with the eye
    this.camera.add(light);
    this.turned = new THREE.Group();
    this.scene.add(this.turned);
    this.addMarks();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
  }

  get model() { return this.editor.model; }

  // The whole mesh with an axis upwards, "y" or "z", seen a little from above.
  begin(up)
  {
    this.turned.rotation.set(...(up === "z" ? [-1.2, 0, -0.6] : [-1.2 + Math.PI / 2, -0.6, 0]));
    this.turned.position.set(0, 0, 0);
    this.resize();
    this.showAll();
  }

  // The camera goes as far away as it must for all vertices to be seen.
  showAll()
  {
    const margin = 1.12;
    const up = margin / Math.tan(Math.PI * this.camera.fov / 360), right = up / Math.max(0.1, this.camera.aspect);
    this.turned.updateMatrixWorld();
    const point = new THREE.Vector3();
    let distance = 1;
    for (let v = 0; v < this.model.positions.length; v += 3)
    {
      point.fromArray(this.model.positions, v).applyMatrix4(this.turned.matrixWorld);
      distance = Math.max(distance, point.z + up * Math.abs(point.y), point.z + right * Math.abs(point.x));
    }
    this.camera.position.z = distance;
    this.draw();
  }

  // The mesh of the model, split at its borders, in place of that of another model.
  setMesh()
  {
    if (this.modelOfMesh === this.model)
      return;
    this.modelOfMesh = this.model;
    if (this.mesh)
    {
      this.turned.remove(this.mesh);
      this.mesh.geometry.dispose();
      this.mesh.material.dispose();
    }
    const shared = new THREE.BufferGeometry();
    shared.setAttribute("position", new THREE.BufferAttribute(this.model.positions, 3));
    shared.setIndex(new THREE.BufferAttribute(this.model.triangles, 1));
    shared.computeVertexNormals();
    this.geometry = this.splitAtBorders(shared.attributes.normal.array);
    const material = new THREE.MeshLambertMaterial({vertexColors: true, side: THREE.DoubleSide,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1});
    this.mesh = new THREE.Mesh(this.geometry, material);
    this.turned.add(this.mesh);
  }

  // Colours are of vertices, so there is a vertex for each of the segments around it. All other vertices
  // are shared, since drawing takes time for each.
  splitAtBorders(normals)
  {
    const {positions, triangles, segments, maximum} = this.model;
    const count = positions.length / 3;
    const none = 0xffffffff;
    const segmentOf = new Uint32Array(count).fill(none); // of the first copy, which has the vertex's number
    const copies = new Map();
    const [vertices, segmentsOfCopies] = [[], []];
    const index = new Uint32Array(triangles.length);
    for (let i = 0; i < triangles.length; ++i)
    {
      const vertex = triangles[i];
      const segment = segments[this.model.faceOfTriangle(Math.floor(i / 3))];
      if (segmentOf[vertex] === none)
        segmentOf[vertex] = segment;
      index[i] = vertex;
      if (segmentOf[vertex] === segment)
        continue;
      const key = vertex * maximum + segment;
      if (!copies.has(key))
      {
        copies.set(key, count + vertices.length);
        vertices.push(vertex);
        segmentsOfCopies.push(segment);
      }
      index[i] = copies.get(key);
    }
    this.segmentOfVertex = new Uint32Array(count + vertices.length); // the finest
    this.segmentOfVertex.set(segmentOf.map(segment => segment === none ? 0 : segment));
    this.segmentOfVertex.set(segmentsOfCopies, count);
    const copied = array =>
    {
      const result = new Float32Array(3 * (count + vertices.length));
      result.set(array);
      vertices.forEach((v, i) => result.set(array.subarray(3 * v, 3 * v + 3), 3 * (count + i)));
      return new THREE.BufferAttribute(result, 3);
    };
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", copied(positions));
    geometry.setAttribute("normal", copied(normals));
    geometry.setAttribute("color",
                          new THREE.BufferAttribute(new Uint8Array(3 * this.segmentOfVertex.length), 3, true));
    geometry.setIndex(new THREE.BufferAttribute(index, 1));
    return geometry;
  }

  addMarks()
  {
    this.lines = new THREE.LineSegments(new THREE.BufferGeometry(),
                                        new THREE.LineBasicMaterial({color: 0x404040}));
    this.tip = new THREE.Mesh(new THREE.SphereGeometry(0.025, 24, 16),
                              new THREE.MeshLambertMaterial({color: 0xd01818}));
    this.rod = new THREE.CylinderGeometry(0.006, 0.006, 1, 6);
    this.rodMaterial = new THREE.MeshBasicMaterial({color: 0x101010});
    this.border = new THREE.Group();
    this.picked = new THREE.Group();
    this.pickedMaterial = new THREE.MeshLambertMaterial({color: 0x1060d0});
    this.turned.add(this.lines, this.tip, this.border, this.picked);
  }

  // Colours for the current level; all but the selected segment are faint. -1 selects none.
  show(selected)
  {
    this.setMesh();
    const {maximum, ancestors} = this.model;
    const faint = color => color.map(c => Math.round(c + 0.6 * (255 - c)));
    const shown = new Uint8Array(3 * maximum); // for the finest segments
    for (let s = 0; s < maximum; ++s)
    {
      const color = colorOf(this.model, ancestors[s]);
      shown.set(selected < 0 || ancestors[s] === selected ? color : faint(color), 3 * s);
    }
    const bytes = this.geometry.attributes.color.array;
    const segments = this.segmentOfVertex;
    for (let v = 0; v < segments.length; ++v)
      for (let c = 0; c < 3; ++c)
        bytes[3 * v + c] = shown[3 * segments[v] + c];
    this.geometry.attributes.color.needsUpdate = true;
    this.showLines();
    this.showTip(selected);
    this.showPickedTips();
    this.showBorder(selected);
    this.draw();
  }

  showLines()
  {
    const points = this.model.borderEdges().flatMap(edge => edge.map(v => this.vector(v)));
    this.lines.geometry.dispose();
    this.lines.geometry = new THREE.BufferGeometry().setFromPoints(points);
  }

  showTip(selected)
  {
    const face = this.model.tip(selected);
    this.tip.visible = face !== undefined;
    if (face !== undefined)
      this.tip.position.set(...this.model.centroid(face));
  }

  showPickedTips()
  {
    this.picked.remove(...this.picked.children);
    for (const face of this.editor.tips)
    {
      const mark = new THREE.Mesh(this.tip.geometry, this.pickedMaterial);
      mark.position.set(...this.model.centroid(face));
      this.picked.add(mark);
    }
  }

  // Lines are one pixel wide everywhere, so the selected border is made of rods.
  showBorder(selected)
  {
    this.turned.remove(this.border);
    const edges = selected < 0 ? [] : this.model.borderEdges(selected);
    if (edges.length === 0)
      return;
    this.border = new THREE.InstancedMesh(this.rod, this.rodMaterial, edges.length);
    this.border.frustumCulled = false; // culling would look at a single rod
    const up = new THREE.Vector3(0, 1, 0);
    edges.forEach(([v, w], i) =>
    {
      const [a, b] = [this.vector(v), this.vector(w)];
      const along = b.clone().sub(a);
      const turn = new THREE.Quaternion().setFromUnitVectors(up, along.clone().normalize());
      this.border.setMatrixAt(i, new THREE.Matrix4().compose(
        a.add(b).multiplyScalar(0.5), turn, new THREE.Vector3(1, along.length(), 1)));
    });
    this.turned.add(this.border);
  }

  vector(vertex) { return new THREE.Vector3(...this.model.point(vertex)); }

  draw()
  {
    if (this.isDue)
      return;
    this.isDue = true;
    requestAnimationFrame(() =>
    {
      this.isDue = false;
      this.renderer.render(this.scene, this.camera);
    });
  }

  resize()
  {
    const {clientWidth: width, clientHeight: height} = this.canvas.parentElement;
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  // The angles are in radians, to the right and downwards.
  turn(right, down)
  {
    const turn = new THREE.Quaternion().setFromEuler(new THREE.Euler(down, right, 0));
    this.turned.quaternion.premultiply(turn);
    this.draw();
  }

  // in pixels
  move(right, down)
  {
    const scale = 2 * Math.tan(Math.PI * this.camera.fov / 360) * this.camera.position.z /
                  this.canvas.clientHeight;
    this.turned.position.add(new THREE.Vector3(right * scale, -down * scale, 0));
    this.draw();
  }

  zoom(factor)
  {
    this.camera.position.z = Math.min(40, Math.max(0.2, this.camera.position.z * factor));
    this.draw();
  }

  // The face at a point of the window; -1 where there is none.
  faceAt(x, y)
  {
    const box = this.canvas.getBoundingClientRect();
    const position = new THREE.Vector2(2 * (x - box.left) / box.width - 1,
                                       1 - 2 * (y - box.top) / box.height);
    this.scene.updateMatrixWorld();
    const back = new THREE.Matrix4().getInverse(this.turned.matrixWorld);
    const from = this.camera.position.clone().applyMatrix4(back);
    const to = new THREE.Vector3(position.x, position.y, 0.5).unproject(this.camera).applyMatrix4(back);
    const triangle = this.model.firstTriangle(from.toArray(), to.sub(from).toArray());
    return triangle < 0 ? -1 : this.model.faceOfTriangle(triangle);
  }

  // Where a face is in the window, hidden or not.
  positionOf(face)
  {
    this.scene.updateMatrixWorld();
    const point = this.turned.localToWorld(new THREE.Vector3(...this.model.centroid(face)));
    point.project(this.camera);
    const box = this.canvas.getBoundingClientRect();
    return [box.left + (point.x + 1) / 2 * box.width, box.top + (1 - point.y) / 2 * box.height];
  }
}
