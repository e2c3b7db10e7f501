// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The page: where meshes come from, what is under way, and what is shown.

"use strict";

class Page
{
  constructor()
  {
    this.program = new Program();
    this.program.onProgress = progress => this.showProgress(progress);
    this.program.onWarning = warning => { this.part("warning").textContent = warning; };
    this.report = null;
    this.sources = 0;
    this.isBusy = false;
    this.connectFiles();
    this.part("stop").onclick = () => this.stop();
    this.part("new_mesh").onclick = () => this.showStart(true);
    this.part("back").onclick = () => this.showStart(false);
    this.part("options").onsubmit = event =>
    {
      event.preventDefault();
      this.segmentAgain();
    };
    this.program.ask("about").then(about => this.begin(about), error => this.showError(error.message));
  }

  part(id) { return document.getElementById(id); }

  begin(about)
  {
    this.options = new Options(about);
    this.part("version").textContent = about.version;
    this.part("formats").textContent = about.formats.toUpperCase();
    this.part("examples").replaceChildren(...about.examples.map(name => element(
      "button", {type: "button", textContent: name, onclick: () => this.openExample(name)})));
    this.extensions = about.formats.split(", ");
    document.body.classList.add("ready");
  }

  connectFiles()
  {
    const input = this.part("files");
    this.part("drop").onclick = () => input.click();
    input.onchange = () =>
    {
      this.openFiles([...input.files]);
      input.value = "";
    };
    let depth = 0; // of what is dragged over
    const highlight = change =>
    {
      depth += change;
      document.body.classList.toggle("dragging", depth > 0);
    };
    window.addEventListener("dragenter", event => { event.preventDefault(); highlight(1); });
    window.addEventListener("dragleave", () => highlight(-1));
    window.addEventListener("dragover", event => event.preventDefault());
    window.addEventListener("drop", event =>
    {
      event.preventDefault();
      highlight(-depth);
      this.openFiles([...event.dataTransfer.files]);
    });
  }

  // Of several files one is the mesh; the others are those that it names.
  openFiles(files)
  {
    if (files.length === 0 || this.isBusy || !this.options)
      return;
    const isMesh = file => this.extensions.some(extension => file.name.toLowerCase().replace(/\.gz$/, "").endsWith(`.${extension}`));
    const {name} = files.find(isMesh) ?? files[0];
    this.open({files, main: name});
  }

  openExample(example)
  {
    if (!this.isBusy)
      this.open({example, faces: 24000});
  }

  async open(source)
  {
    this.program.restartIfLarge();
    const options = this.options.values();
    options.segments = ""; // as many as this mesh has
    this.options.set(options);
    const model = await this.segment({source: {...source, id: ++this.sources}, words: this.options.words(), texts: {},
                                      options: this.options.values()});
    if (!model)
      return;
    this.showStart(false);
    document.body.classList.add("shown");
    if (this.report)
      this.report.begin(model);
    else
      window.report = this.report = new Segmenting_report(model, this);
  }

  // The same mesh with the options as they are, and `more` than they tell.
  async segmentAgain(more = {})
  {
    const areThereTips = more.texts !== undefined;
    const {source} = this.report.model.question;
    const model = await this.segment({source, words: [...this.options.words({areThereTips}), ...(more.words ?? [])],
                                      texts: more.texts ?? {}, options: this.options.values()});
    if (model)
      this.report.replaceModel(model);
  }

  segmentInto(number)
  {
    this.options.set({...this.options.values(), segments: String(number)});
    return this.segmentAgain();
  }

  segmentFromTips(text) { return this.segmentAgain({words: ["--tips", "tips.json"], texts: {"tips.json": text}}); }

  // Undefined if it was stopped or failed.
  async segment(question)
  {
    const data = await this.ask("segment", question);
    return data && Object.assign(new Model(data), {question});
  }

  async ask(action, question)
  {
    this.showBusy(true);
    try
    {
      return await this.program.ask(action, question);
    }
    catch (error)
    {
      this.showError(error.message);
      return undefined;
    }
    finally
    {
      this.showBusy(false);
    }
  }

  stop()
  {
    this.program.stop();
    this.showError("Stopped.");
  }

  showBusy(isBusy)
  {
    this.isBusy = isBusy;
    document.body.classList.toggle("busy", isBusy);
    this.part("warning").textContent = "";
    if (isBusy)
    {
      this.showError("");
      this.showProgress({share: 0, stage: "", protrusions: 0});
    }
  }

  showProgress({share, stage, protrusions})
  {
    this.part("progress").value = share;
    const count = protrusions === 0 ? "" : protrusions === 1 ? "1 protrusion, " : `${protrusions} protrusions, `;
    this.part("stage").textContent = count + (stage || "starting");
  }

  showError(message)
  {
    this.part("start_message").textContent = message;
    this.report?.say(message);
  }

  showStart(isShown)
  {
    document.body.classList.toggle("starting", isShown);
    if (isShown)
      this.part("start_message").textContent = "";
  }
}

window.page = new Page();
