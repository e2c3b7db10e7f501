// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mouse, keys, slider and buttons.

"use strict";

function saveFile(name, text)
{
  const link = element("a", {href: URL.createObjectURL(new Blob([text], {type: "text/plain"})), download: name});
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

class Report
{
  constructor(model)
  {
    this.editor = new Editor(model, () => this.show());
    this.exporter = new Exporter(this.editor);
    this.selected = -1;
    this.panel = new Panel(this.editor, segment => this.select(segment));
    this.view = new View(document.getElementById("canvas"), this.editor);
    this.beginView();
    document.getElementById("level").oninput = event => this.setLevel(event.target.valueAsNumber);
    this.connectButtons();
    this.connectPointer(this.view.canvas);
    this.connectKeys(this.view.canvas);
    const named = Number.parseInt(location.hash.slice(1)); // page.html#3 begins with segment 3
    this.select(named < this.model.maximum ? named : -1);
  }

  get model() { return this.editor.model; }

  select(segment)
  {
    this.selected = segment;
    this.show();
  }

  show()
  {
    if (this.selected >= 0 && !this.model.isShown(this.selected))
      this.selected = this.model.ancestors[this.selected];
    this.showLevel();
    this.showWhichNested();
    document.getElementById("undo").disabled = !this.editor.canUndo();
    document.getElementById("merge").disabled = !this.editor.canMerge(this.selected);
    this.showSaving();
    document.getElementById("from_tips").disabled = this.editor.tips.length === 0;
    this.say("");
    this.panel.show(this.selected);
    this.view.show(this.selected);
  }

  showSaving() { document.getElementById("save_stl").disabled = this.selected < 0; }

  showLevel()
  {
    const {number, minimum, maximum} = this.model;
    Object.assign(document.getElementById("level"), {min: minimum, max: maximum, value: number});
    document.getElementById("level_value").value = `${number} of ${maximum}`;
    document.getElementById("levels").hidden = minimum === maximum;
  }

  // One line on the mesh, until something changes.
  say(text) { document.getElementById("message").textContent = text; }

  // The slider does not show what -k finds.
  showWhichNested()
  {
    const {number, maximum, minimum, data} = this.model;
    const nested = document.getElementById("nested");
    nested.hidden = !this.model.isLevel() || number === maximum || number === minimum || data.labels !== null ||
                    data.tips_requested !== null;
    const call = `-k ${number} --of ${data.hierarchy_requested ?? maximum}`;
    nested.replaceChildren("These are nested segments, of ", element("code", {textContent: call}), ". ",
                           element("code", {textContent: `-k ${number}`}), " alone may find better ones.");
  }

  setLevel(numberOfSegments) { this.editor.setLevel(numberOfSegments); }

  // The name of the file without folder and extension.
  get name() { return this.model.data.input.split(/[\\/]/).pop().replace(/\.[^.]*$/, "") || "mesh"; }

  // With the axis upwards that is usual in the format.
  beginView()
  {
    const up = /\.(obj|glb|gltf)(\.gz)?$/i.test(this.model.data.input) ? "y" : "z";
    document.getElementById("up").value = up;
    this.view.begin(up);
  }

  // What the buttons do.
  actions()
  {
    return {undo: () => this.editor.undo(), merge: () => this.merge(),
            from_tips: () => this.segmentFromTips(),
            save_seg: () => saveFile(`${this.name}.seg`, this.model.segText()),
            save_ply: () => saveFile(`${this.name}.ply`, this.exporter.plyText()),
            save_obj: () => saveFile(`${this.name}.parts.obj`, this.exporter.objText()),
            save_stl: () => saveFile(`${this.name}.${this.exporter.nameOf(this.selected)}.stl`,
                                     this.exporter.stlText(this.selected)),
            save_tips: () => saveFile(`${this.name}.tips.json`, this.editor.tipsText())};
  }

  connectButtons()
  {
    for (const [id, action] of Object.entries(this.actions()))
      document.getElementById(id).onclick = action;
    document.getElementById("colors").onchange = () => this.show();
    document.getElementById("up").onchange = event => this.view.begin(event.target.value);
  }

  isPicking() { return document.getElementById("picking").checked; }

  click(x, y)
  {
    const face = this.view.faceAt(x, y);
    if (this.isPicking() && face >= 0)
      this.editor.pick(face);
    else
      this.select(face < 0 ? -1 : this.model.segmentOfFace(face));
    if (face < 0)
      this.say("There is no face at this place.");
  }

  merge()
  {
    if (this.editor.canMerge(this.selected))
      this.editor.merge(this.selected);
    else
      this.say(this.selected < 0 ? "No segment is selected." : "A body has no parent to be merged into.");
  }

  segmentFromTips()
  {
    this.editor.segmentFromTips();
    if (this.editor.tips.length > 0)
      this.say(`No further segment of this page ends at face ${this.editor.tips.join(", ")}. Save tips and names: ` +
               "segment_by_protrusions --tips looks for one.");
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
        this.click(event.clientX, event.clientY);
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
                     Escape: () => this.select(-1), Delete: () => this.merge()};
    canvas.onkeydown = event =>
    {
      if (event.key === "z" && event.ctrlKey)
        this.editor.canUndo() ? this.editor.undo() : this.say("There is nothing to undo.");
      else if (event.key in actions)
        actions[event.key]();
      else
        return;
      event.preventDefault();
    };
  }
}
