// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mouse, keys and slider.

"use strict";

class Report
{
  constructor()
  {
    this.model = new Model(JSON.parse(document.getElementById("data").textContent));
    this.selected = -1;
    this.panel = new Panel(this.model, segment => this.select(segment));
    this.view = new View(document.getElementById("canvas"), this.model);
    this.connectSlider();
    this.connectPointer(this.view.canvas);
    this.connectKeys(this.view.canvas);
    this.setLevel(this.model.maximum);
    const named = Number.parseInt(location.hash.slice(1)); // page.html#3 begins with segment 3
    if (named < this.model.maximum)
      this.select(named);
  }

  select(segment)
  {
    this.selected = segment;
    this.panel.show(segment);
    this.view.show(segment);
  }

  setLevel(numberOfSegments)
  {
    this.model.setLevel(numberOfSegments);
    document.getElementById("level").value = numberOfSegments;
    document.getElementById("level_value").value = `${numberOfSegments} of ${this.model.maximum}`;
    this.select(this.selected < numberOfSegments ? this.selected : -1);
  }

  connectSlider()
  {
    const slider = document.getElementById("level");
    Object.assign(slider, {min: this.model.minimum, max: this.model.maximum, value: this.model.maximum});
    slider.oninput = () => this.setLevel(slider.valueAsNumber);
    document.getElementById("levels").hidden = this.model.minimum === this.model.maximum;
  }

  connectPointer(canvas)
  {
    let travelled = 0;
    canvas.onpointerdown = event =>
    {
      travelled = 0;
      canvas.setPointerCapture(event.pointerId);
    };
    canvas.onpointermove = event =>
    {
      if (event.buttons === 0)
        return;
      travelled += Math.hypot(event.movementX, event.movementY);
      if (event.buttons === 2 || event.shiftKey)
        this.view.move(event.movementX, event.movementY);
      else
        this.view.turn(0.008 * event.movementX, 0.008 * event.movementY); // radians per pixel
    };
    canvas.onpointerup = event =>
    {
      if (travelled < 5 && event.button === 0) // a click, by a hand that shakes
        this.select(this.view.segmentAt(event.clientX, event.clientY));
    };
    canvas.oncontextmenu = event => event.preventDefault();
    canvas.addEventListener("wheel", event =>
    {
      event.preventDefault();
      this.view.zoom(Math.exp(0.001 * event.deltaY));
    }, {passive: false});
  }

  connectKeys(canvas)
  {
    const actions = {ArrowLeft: () => this.view.turn(-0.1, 0), ArrowRight: () => this.view.turn(0.1, 0),
                     ArrowUp: () => this.view.turn(0, -0.1), ArrowDown: () => this.view.turn(0, 0.1),
                     "+": () => this.view.zoom(0.9), "-": () => this.view.zoom(1 / 0.9),
                     Escape: () => this.select(-1)};
    canvas.onkeydown = event =>
    {
      if (!(event.key in actions))
        return;
      event.preventDefault();
      actions[event.key]();
    };
  }
}

try
{
  window.report = new Report();
}
catch (error)
{
  document.getElementById("hint").textContent = `The mesh cannot be shown: ${error.message}`;
}
