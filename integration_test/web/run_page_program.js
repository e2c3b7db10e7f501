// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program of the page under node, without a browser:
//
//   node run_page_program.js PAGE FOLDER WORDS MESH...
//
// WORDS is a JSON array of options of segment_by_protrusions. Writes FOLDER/<file>.seg for each mesh, and prints a JSON object a
// line: {"mesh", "seconds", "megabytes"} or {"mesh", "error"}. A MESH "example:octopus:24000" is one that the page makes; its file
// is written, too. The seconds are those that the program tells, to read and to segment.

"use strict";

const fs = require("fs");
const os = require("os");
const path = require("path");

function programOf(page)
{
  const text = /<script type="text\/plain" id="program">\n([^]*?)<\/script>/.exec(fs.readFileSync(page, "utf8"))[1];
  const file = path.join(fs.mkdtempSync(path.join(os.tmpdir(), "page-")), "program.js");
  fs.writeFileSync(file, text);
  try
  {
    return require(file);
  }
  finally
  {
    fs.rmSync(path.dirname(file), {recursive: true});
  }
}

function sourceOf(mesh)
{
  if (mesh.startsWith("example:"))
  {
    const [, example, faces] = mesh.split(":");
    return {id: mesh, example, faces: Number(faces)};
  }
  const bytes = fs.readFileSync(mesh);
  const name = path.basename(mesh);
  return {id: mesh, main: name, files: [{name, arrayBuffer: async () => bytes}]};
}

async function run(program, folder, words, mesh)
{
  const question = {source: sourceOf(mesh), words, texts: {}};
  const data = await program.segment(question);
  const name = question.source.main ?? `${question.source.example}.off`;
  const request = {...question, outputs: ["-o", "out/labels.seg"], joined: [], names: [], archive: ""};
  const [[, bytes]] = await program.write(request);
  fs.writeFileSync(path.join(folder, `${name}.seg`), bytes);
  if (question.source.example)
    fs.writeFileSync(path.join(folder, name), program.fs.readFile(name));
  return {mesh, seconds: data.seconds, segments: data.segments, faces: data.faces,
          megabytes: program.bytesOfMemory() / 2 ** 20};
}

async function main([page, folder, words, ...meshes])
{
  const {makeProgram, Worker_program} = programOf(page);
  let program;
  for (const mesh of meshes)
  {
    if (!program)
    {
      program = new Worker_program(await makeProgram({}));
      program.warmUp(); // as the page does
    }
    let result;
    try
    {
      result = await run(program, folder, JSON.parse(words), mesh);
    }
    catch (error)
    {
      result = {mesh, error: error.message};
      if (error.constructor !== Error) // it did not end by itself
        program = undefined;
    }
    console.log(JSON.stringify(result));
  }
}

main(process.argv.slice(2));
