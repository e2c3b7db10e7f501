// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The worker, around the compiled program: one question at a time, one answer for each. A question tells all that its answer
// depends on, and what is known from the last one is not computed again.
//
//   source   {id, files: [File, ...], main: name} or {id, example: name, faces: number}: where the mesh comes from
//   words    the options of segment_by_protrusions
//   texts    {name: text}: files besides

"use strict";

class Worker_program
{
  constructor(program)
  {
    this.program = program;
    this.fs = program.FS;
    this.fs.mkdir("/meshes");
    this.fs.chdir("/meshes");
    this.source = null; // the id of the one that is in the folder
    this.segmented = null; // what was segmented last, as text
  }

  // A function of program.h, by its name; arguments are texts and numbers.
  call(name, ...values)
  {
    const {_malloc, _free, lengthBytesUTF8, stringToUTF8, UTF8ToString} = this.program;
    const pointers = values.map(value =>
    {
      if (typeof value === "number")
        return 0;
      const size = lengthBytesUTF8(value) + 1, pointer = _malloc(size);
      stringToUTF8(value, pointer, size);
      return pointer;
    });
    const text = UTF8ToString(this.program[name](...values.map((value, i) => pointers[i] || value)));
    pointers.filter(pointer => pointer !== 0).forEach(_free);
    const answer = JSON.parse(text);
    if (answer.error !== undefined)
      throw new Error(answer.error);
    return answer;
  }

  clear()
  {
    for (const name of this.fs.readdir(".").filter(name => !name.startsWith(".")))
      if (this.fs.isFile(this.fs.stat(name).mode))
        this.fs.unlink(name);
  }

  async load(source)
  {
    if (source.id === this.source)
      return;
    this.source = this.segmented = null;
    this.clear();
    if (source.example !== undefined)
      this.call("_page_make_example", source.example, source.faces);
    for (const file of source.files ?? [])
      this.fs.writeFile(file.name, new Uint8Array(await file.arrayBuffer()));
    this.source = source.id;
  }

  words({source, words})
  {
    const name = source.main ?? `${source.example}.off`;
    return [name.startsWith("-") ? `./${name}` : name, ...words];
  }

  async segment(question)
  {
    await this.load(question.source);
    const key = JSON.stringify([this.words(question), question.texts]);
    this.segmented = null;
    for (const [name, text] of Object.entries(question.texts))
      this.fs.writeFile(name, text);
    const {data} = this.call("_page_segment", JSON.stringify(this.words(question)));
    this.segmented = key;
    return data;
  }

  // The files of `question.outputs`, which are words, too, as [name, bytes].
  async write(question)
  {
    await this.load(question.source);
    if (this.segmented !== JSON.stringify([this.words(question), question.texts]))
      await this.segment(question);
    const {joined, names, archive} = question;
    const words = [...this.words(question), ...question.outputs];
    const {files} = this.call("_page_write", JSON.stringify({words, joined, names, archive}));
    return files.map(name =>
    {
      const bytes = this.fs.readFile(`out/${name}`);
      this.fs.unlink(`out/${name}`);
      return [name, bytes];
    });
  }

  // An engine makes code fast that it has run a while. So the first mesh takes as long as the next ones.
  warmUp()
  {
    this.source = null;
    this.call("_page_make_example", "teddy", 1000);
    this.call("_page_segment", JSON.stringify(["teddy.off"]));
    this.clear();
  }

  about() { return this.call("_page_about"); }

  bytesOfMemory() { return this.program.HEAPU8.length; }
}

if (typeof importScripts === "function") // a worker, not the tests
{
  let last = 0; // time of the progress that the page was told
  const ready = makeProgram({
    onProgress: (share, stage, protrusions) =>
    {
      if (performance.now() < last + 50) // milliseconds
        return;
      last = performance.now();
      postMessage({progress: {share, stage, protrusions}});
    },
    onWarning: warning => postMessage({warning}),
  }).then(program => new Worker_program(program));
  let isAsked = false;
  ready.then(program => setTimeout(() => { if (!isAsked) program.warmUp(); }, 100)); // milliseconds, for the page to be drawn
  onmessage = async ({data: {id, action, question}}) =>
  {
    isAsked ||= question !== undefined;
    try
    {
      const program = await ready;
      const result = await program[action](question);
      postMessage({id, result, bytes: program.bytesOfMemory()});
    }
    catch (error)
    {
      // Only the tool's own messages leave the program as it was.
      postMessage({id, error: error.message, isBroken: error.constructor !== Error});
    }
  };
}
else
  module.exports = {makeProgram, Worker_program};
