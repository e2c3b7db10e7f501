// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The report with the program behind it: picked tips segment anew, and files are those of the tool.

"use strict";

// What the buttons save: the words for it, and whether its files come in an archive.
const savedFiles = {
  save_seg: name => ({outputs: ["-o", `out/${name}.seg`]}),
  save_ply: name => ({outputs: ["-o", `out/${name}.ply`]}),
  save_obj: name => ({outputs: ["-o", `out/${name}.obj`], archive: `${name}.obj.zip`}),
  save_glb: name => ({outputs: ["-o", `out/${name}.glb`]}),
  save_3mf: name => ({outputs: ["-o", `out/${name}.3mf`]}),
  save_parts: (name, caps) => ({outputs: ["-o", "out/%s.stl", `--close=${caps}`], archive: `${name}.parts.zip`}),
  save_json: name => ({outputs: ["--json", `out/${name}.json`]}),
};

class Segmenting_report extends Report
{
  constructor(model, page)
  {
    super(model);
    this.page = page;
  }

  // Another mesh, or the same one from the beginning.
  begin(model)
  {
    this.editor.setModel(model);
    this.editor.history = [];
    this.beginView();
    document.getElementById("picking").checked = false;
    this.select(-1);
  }

  replaceModel(model)
  {
    this.selected = -1;
    this.editor.replaceModel(model);
  }

  show()
  {
    super.show();
    const {question} = this.model;
    if (this.shownQuestion && question !== this.shownQuestion)
      this.page.options.set(question.options); // also after undoing
    this.shownQuestion = question;
  }

  showSaving() {}

  showWhichNested()
  {
    super.showWhichNested();
    const {number} = this.model;
    const nested = document.getElementById("nested");
    const again = element("button", {type: "button", textContent: `segment into ${number}`,
                                     onclick: () => this.page.segmentInto(number)});
    nested.replaceChildren(`These are nested segments. The best ${number} may differ: `, again);
  }

  actions()
  {
    const saving = Object.entries(savedFiles).map(([id, request]) => [id, () => this.save(request)]);
    const {undo, merge, from_tips, save_tips} = super.actions();
    return {undo, merge, from_tips, save_tips, ...Object.fromEntries(saving)};
  }

  async save(request)
  {
    const {model} = this;
    const names = model.shownSegments().map(segment => this.editor.names.get(segment) ?? "");
    const {outputs, archive = ""} = request(this.name, document.getElementById("caps").value);
    const files = await this.page.ask("write", {
      ...model.question, outputs, archive, joined: [...model.joined], names: names.some(name => name !== "") ? names : []});
    for (const [name, bytes] of files ?? [])
      saveFile(name, bytes);
  }

  segmentFromTips() { this.page.segmentFromTips(this.editor.tipsText()); }
}
