// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is changed by hand: cuts that are taken back, names of segments, picked tips; and the model, if there comes another
// one. Every change can be undone.

"use strict";

class Editor
{
  constructor(model, onChange)
  {
    this.onChange = onChange;
    this.setModel(model);
    this.history = [];
  }

  setModel(model)
  {
    this.model = model;
    this.names = new Map(model.data.measures.filter(m => m.name !== null).map(m => [m.segment, m.name])); // of segments
    this.tips = []; // faces
  }

  // Other segments of the same mesh.
  replaceModel(model) { this.change(() => this.setModel(model)); }

  state()
  {
    return {model: this.model, joined: new Set(this.model.joined), names: new Map(this.names), tips: [...this.tips]};
  }

  change(make)
  {
    const before = this.state();
    make();
    this.history.push(before);
    this.onChange();
  }

  canUndo() { return this.history.length > 0; }

  undo()
  {
    const before = this.history.pop();
    if (before === undefined)
      return;
    this.model = before.model;
    this.names = before.names;
    this.tips = before.tips;
    this.model.setJoined(before.joined);
    this.onChange();
  }

  setLevel(numberOfSegments) { this.change(() => this.model.setLevel(numberOfSegments)); }

  canMerge(segment) { return this.model.protrusions.has(segment) && this.model.isShown(segment); }

  // Gives a protrusion to what it sticks out of.
  merge(segment)
  {
    if (this.canMerge(segment))
      this.change(() => this.model.setJoined(new Set([...this.model.joined, segment])));
  }

  rename(segment, name)
  {
    this.change(() => name === "" ? this.names.delete(segment) : this.names.set(segment, name));
  }

  // Once more takes it away.
  pick(face)
  {
    this.change(() =>
    {
      const place = this.tips.indexOf(face);
      if (place < 0)
        this.tips.push(face);
      else
        this.tips.splice(place, 1);
    });
  }

  // The picked tips where the finest segments have no other protrusion than the one that is shown.
  tipsWithoutSegment() { return this.tips.filter(face => !this.model.hasSmallerSegment(face)); }

  // Picked tips become shown segments; those without one are left.
  segmentFromTips()
  {
    this.change(() =>
    {
      const without = this.tipsWithoutSegment();
      this.model.addTips(this.tips);
      this.tips = without;
    });
  }

  nameOf(segment)
  {
    return this.names.get(segment) ?? (this.model.isBody(segment) ? `${segment}: body` : `${segment}`);
  }

  // As `segment_by_protrusions --tips` reads it: the tips of the shown protrusions, and the picked ones.
  tipsText()
  {
    const shown = this.model.shownSegments();
    const ofShown = shown.map(s => this.model.tip(s)).filter(face => face !== undefined);
    const tips = [...new Set([...ofShown, ...this.tips])];
    const named = shown.filter(s => this.names.has(s));
    const names = named.map(s => ({face: this.model.tip(s) ?? this.model.farthestFace(s), name: this.names.get(s)}));
    return JSON.stringify({input: this.model.data.input, tips, names}, null, 2) + "\n";
  }
}
