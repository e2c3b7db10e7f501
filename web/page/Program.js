// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The program in its worker, seen from the page.

"use strict";

class Program
{
  constructor()
  {
    this.text = document.getElementById("program").textContent;
    this.onProgress = () => {};
    this.onWarning = () => {};
    this.next = 0;
    this.start();
  }

  start()
  {
    this.address ??= URL.createObjectURL(new Blob([this.text], {type: "text/javascript"}));
    this.waiting = new Map();
    this.bytes = 0;
    this.worker = new Worker(this.address);
    this.worker.onmessage = ({data}) => this.receive(data);
    this.worker.onerror = event => this.fail(event.message);
  }

  receive({id, result, error, isBroken, progress, warning, bytes})
  {
    if (progress !== undefined)
      return this.onProgress(progress);
    if (warning !== undefined)
      return this.onWarning(warning);
    const {resolve, reject} = this.waiting.get(id);
    this.waiting.delete(id);
    this.bytes = bytes ?? this.bytes;
    if (isBroken)
      this.restart();
    error === undefined ? resolve(result) : reject(new Error(isBroken ? `The program failed: ${error}` : error));
  }

  fail(message)
  {
    const all = [...this.waiting.values()];
    this.restart();
    all.forEach(({reject}) => reject(new Error(`The program failed: ${message}`)));
  }

  restart()
  {
    this.worker.terminate();
    this.start();
  }

  // The memory of a program never shrinks.
  restartIfLarge()
  {
    if (this.bytes > 500e6)
      this.restart();
  }

  // Resolves to undefined if it is stopped.
  ask(action, question)
  {
    return new Promise((resolve, reject) =>
    {
      const id = this.next++;
      this.waiting.set(id, {resolve, reject});
      this.worker.postMessage({id, action, question});
    });
  }

  stop()
  {
    const all = [...this.waiting.values()];
    this.restart();
    all.forEach(({resolve}) => resolve(undefined));
  }
}
