// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The form with the options of segment_by_protrusions. An empty field is the tool's default.

"use strict";

class Options
{
  constructor(about)
  {
    this.form = document.getElementById("options");
    this.fill("method", about.methods);
    this.fill("distance", about.distances, "the method's own");
    this.form.onchange = () => this.showWhatApplies();
    this.showWhatApplies();
  }

  field(name) { return this.form.elements[name]; }

  fill(name, choices, textOfDefault)
  {
    const options = choices.map(choice => element("option", {value: choice.name,
                                                             textContent: `${choice.name}: ${choice.description}`}));
    if (textOfDefault)
      options.unshift(element("option", {value: "", textContent: textOfDefault}));
    this.field(name).replaceChildren(...options);
  }

  values()
  {
    return Object.fromEntries(Array.from(this.form.elements).filter(field => field.name !== "").map(
      field => [field.name, field.type === "checkbox" ? field.checked : field.value.trim()]));
  }

  set(values)
  {
    for (const [name, value] of Object.entries(values))
      this.field(name)[this.field(name).type === "checkbox" ? "checked" : "value"] = value;
    this.showWhatApplies();
  }

  // The tool refuses options that have no meaning with the others, so the page does not offer them.
  showWhatApplies()
  {
    const {distance, joined} = this.values();
    const applies = {landmarks: distance === "landmark", eigenpairs: distance === "diffusion", time: distance === "diffusion",
                     gap: joined, weld: !joined};
    for (const [name, does] of Object.entries(applies))
    {
      this.field(name).disabled = !does;
      this.field(name).closest("label").hidden = !does;
    }
  }

  // As words of a command line. With tips their number is that of the segments.
  words({areThereTips = false} = {})
  {
    const values = this.values();
    const words = [];
    const add = (name, word) => { if (values[name] !== undefined && values[name] !== "") words.push(word, values[name]); };
    if (!areThereTips)
      add("segments", "-k");
    words.push("--method", values.method);
    add("distance", "--distance");
    for (const name of ["landmarks", "eigenpairs", "time", "seed", "weld"])
      if (!this.field(name).disabled)
        add(name, `--${name}`);
    if (values.joined)
      words.push(values.gap ? `--join-pieces=${values.gap}` : "--join-pieces");
    if (values.smooth)
      words.push("--smooth-borders");
    return words;
  }
}
