// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The mesh on the canvas: colours, borders, the tip, turning by hand, and which segment is clicked.
// Positions are such that the mesh is in a ball of radius one. Drawn only when something changed.

"use strict";

class View
{
  constructor(canvas, model)
  {
    this.canvas = canvas;
    this.model = model;
    this.renderer = new THREE.WebGLRenderer({canvas, antialias: true, preserveDrawingBuffer: true});
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setClearColor(0xffffff);
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.05, 100);
    this.camera.position.z = View.startDistance;
    this.scene.add(this.camera, new THREE.AmbientLight(0xffffff, 0.5));
    const light = new THREE.DirectionalLight(0xffffff, 0.55);
    light.position.set(-0.4, 0.6, 1); // of the camera, so that it stays with the eye
    this.camera.add(light);
    this.turned = new THREE.Group();
    this.turned.rotation.set(-1.2, 0, -0.6); // the z axis upwards, seen a little from above
    this.scene.add(this.turned);
    this.addMesh();
    this.addMarks();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    this.resize();
  }

  addMesh()
  {
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
    const {positions, triangles, faces, segments, maximum} = this.model;
    const copies = new Map();
    const vertices = [];
    this.segmentOfVertex = []; // the finest
    const index = triangles.map((vertex, i) =>
    {
      const segment = segments[faces[Math.floor(i / 3)]];
      const key = vertex * maximum + segment;
      if (!copies.has(key))
      {
        copies.set(key, vertices.length);
        vertices.push(vertex);
        this.segmentOfVertex.push(segment);
      }
      return copies.get(key);
    });
    const copied = array => new THREE.BufferAttribute(
      new Float32Array(3 * vertices.length).map((_, i) => array[3 * vertices[Math.floor(i / 3)] + i % 3]), 3);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute("position", copied(positions));
    geometry.setAttribute("normal", copied(normals));
    geometry.setAttribute("color",
                          new THREE.BufferAttribute(new Uint8Array(3 * vertices.length), 3, true));
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
    this.turned.add(this.lines, this.tip, this.border);
  }

  // Colours for the current level; all but the selected segment are faint. -1 selects none.
  show(selected)
  {
    const {colors, ancestors} = this.model;
    const faint = color => color.map(c => Math.round(c + 0.6 * (255 - c)));
    const shown = colors.map((color, s) => selected < 0 || s === selected ? color : faint(color));
    const bytes = this.geometry.attributes.color.array;
    this.segmentOfVertex.forEach((segment, v) => bytes.set(shown[ancestors[segment]], 3 * v));
    this.geometry.attributes.color.needsUpdate = true;
    this.showLines();
    this.showTip(selected);
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
    const protrusion = this.model.protrusions.get(selected);
    this.tip.visible = protrusion !== undefined;
    if (protrusion)
      this.tip.position.set(...this.model.centroid(protrusion.tip));
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

  // The segment at a point of the window; -1 where there is none.
  segmentAt(x, y)
  {
    const box = this.canvas.getBoundingClientRect();
    const position = new THREE.Vector2(2 * (x - box.left) / box.width - 1,
                                       1 - 2 * (y - box.top) / box.height);
    const caster = new THREE.Raycaster();
    caster.setFromCamera(position, this.camera);
    const hits = caster.intersectObject(this.mesh);
    return hits.length === 0 ? -1 : this.model.segmentOfTriangle(hits[0].faceIndex);
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

View.startDistance = 3.6; // most meshes fill the canvas; the corners of a cube are just out of sight
