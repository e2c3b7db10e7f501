// Copyright (c) 2026 The Protrusion_segmentation authors. All rights reserved.
//
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The text beside the mesh: the tree of segments, and what is known of the selected one.

"use strict";

function element(name, properties = {}, ...children)
{
  const result = Object.assign(document.createElement(name), properties);
  result.append(...children);
  return result;
}

function svgElement(name, attributes, text = "")
{
  const result = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes))
    result.setAttribute(key, value);
  result.textContent = text;
  return result;
}

function format(number) { return Number(number.toPrecision(4)).toLocaleString("en"); }

// Bars for the slots; the slot of the border is marked.
function histogram(values, slot, label)
{
  const [width, height, left, top] = [320, 110, 44, 16];
  const highest = Math.max(...values, Number.MIN_VALUE);
  const svg = svgElement("svg", {viewBox: `0 0 ${left + width + 14} ${top + height + 34}`, role: "img",
                                 "aria-label": `${label}; the border is in slot ${slot}`,
                                 "font-size": 11});
  const add = (...what) => svg.append(svgElement(...what));
  const step = width / values.length;
  values.forEach((value, i) => add("rect", {
    x: left + i * step, y: top + height * (1 - value / highest), width: step,
    height: height * value / highest, fill: i === slot ? "#c82828" : "#6c8ebf"}));
  const x = left + (slot + 0.5) * step;
  add("line", {x1: x, x2: x, y1: top, y2: top + height, stroke: "#c82828", "stroke-dasharray": "4 3"});
  add("text", {x, y: top - 4, fill: "#c82828", "text-anchor": "middle"}, `slot ${slot}`);
  add("path", {d: `M${left} ${top}V${top + height}H${left + width}`, fill: "none", stroke: "#222"});
  add("text", {x: left - 4, y: top + 9, "text-anchor": "end"}, format(highest));
  add("text", {x: left - 4, y: top + height, "text-anchor": "end"}, "0");
  for (let i = 0; i <= values.length; i += 10)
    add("text", {x: left + i * step, y: top + height + 13, "text-anchor": "middle"}, String(i));
  add("text", {x: left + width / 2, y: top + height + 28, "text-anchor": "middle"}, "slot");
  return svg;
}

function showsConfidence() { return document.getElementById("colors").value === "confidence"; }

// From the least sure, red, over light grey to the surest, blue: a scale that people who confuse red and green can read.
function colorOfShare(share)
{
  const [low, middle, high] = [[202, 0, 32], [235, 235, 235], [5, 90, 170]];
  const [from, to, t] = share < 0.5 ? [low, middle, 2 * share] : [middle, high, 2 * share - 1];
  return from.map((x, i) => Math.round(x + t * (to[i] - x)));
}

// The colour of a shown segment: its own, or that of its confidence.
function colorOf(model, segment)
{
  if (!showsConfidence())
    return model.colors[segment];
  const [least, largest] = model.scale();
  return colorOfShare(largest > least ? Math.min(1, (model.confidence(segment) - least) / (largest - least)) : 1);
}

class Panel
{
  constructor(editor, onSelect)
  {
    this.editor = editor;
    this.onSelect = onSelect;
    this.part("meanings").replaceChildren(...Object.entries(Panel.meanings).flatMap(
      ([name, meaning]) => [element("dt", {textContent: name}), element("dd", {textContent: meaning})]));
  }

  get model() { return this.editor.model; }

  showHead()
  {
    const {data} = this.model;
    const name = data.input.split(/[\\/]/).pop();
    document.title = `${name} – protrusions`;
    this.part("title").textContent = name;
    this.part("summary").textContent =
      `${data.faces.toLocaleString("en")} faces, ${data.segments} segments in ${format(data.seconds)} s; ` +
      (data.method === null ? `segments of ${data.labels}` : `method ${data.method}`) + (data.distance === null ? "" : `, distance ${data.distance}`);
    this.part("colors").parentElement.hidden = !this.model.hasConfidence();
    this.part("note").hidden = data.note === null;
    this.part("note").textContent = data.note ?? "";
  }

  part(id) { return document.getElementById(id); }

  show(selected)
  {
    this.showHead();
    const bodies = this.model.shownSegments().filter(s => this.model.isBody(s));
    this.part("tree").replaceChildren(...bodies.map(s => this.branch(s, selected)));
    this.part("details").replaceChildren(...this.details(selected));
    this.part("tips").replaceChildren(...this.editor.tips.map(face => this.itemOfTip(face)));
    this.part("scale").hidden = !showsConfidence();
  }

  branch(segment, selected)
  {
    const swatch = element("span", {className: "swatch"});
    swatch.style.background = `rgb(${colorOf(this.model, segment).join()})`;
    const button = element("button", {type: "button", onclick: () => this.onSelect(segment)},
                           swatch, this.editor.nameOf(segment));
    button.setAttribute("aria-pressed", segment === selected);
    if (showsConfidence() && Number.isFinite(this.model.confidence(segment)))
      button.append(` (${format(this.model.confidence(segment))})`);
    const children = this.model.children(segment);
    const item = element("li", {}, button);
    if (children.length > 0)
      item.append(element("ul", {}, ...children.map(s => this.branch(s, selected))));
    return item;
  }

  details(selected)
  {
    if (selected < 0)
      return [element("p", {textContent: "No segment is selected."})];
    const rows = [["faces", format(this.model.faceCounts[selected])]];
    if (Number.isFinite(this.model.confidence(selected)))
      rows.push(["confidence", format(this.model.confidence(selected))]);
    const protrusion = this.model.protrusions.get(selected);
    if (protrusion)
      rows.push(...this.rowsOf(protrusion));
    const table = element("table", {}, ...rows.map(([name, value]) => element(
      "tr", {title: Panel.meanings[name] ?? ""}, element("th", {textContent: name}), element("td", {textContent: value}))));
    return [element("h2", {textContent: `Segment ${this.editor.nameOf(selected)}`}), this.nameField(selected), table,
            ...(protrusion ? this.histogramsOf(protrusion) : [])];
  }

  nameField(segment)
  {
    const field = element("input", {id: "name", value: this.editor.names.get(segment) ?? "", placeholder: "its name"});
    field.onchange = () => this.editor.rename(segment, field.value.trim());
    return element("label", {className: "name"}, "name ", field);
  }

  itemOfTip(face)
  {
    const button = element("button", {type: "button", textContent: "×", title: "take this tip away",
                                      onclick: () => this.editor.pick(face)});
    return element("li", {}, `face ${face} `, button);
  }

  rowsOf(protrusion)
  {
    const hasSlot = protrusion.border_slot !== null;
    const rows = [["sticks out of segment", this.model.ancestors[protrusion.parent]], ["tip at face", this.model.tip(protrusion.segment)],
                  ...(protrusion.value === null ? []
                      : [[hasSlot ? "prominence of the border" : "value of the cut", format(protrusion.value)]]),
                  ...(protrusion.probability === null ? [] : [["probability of the border", format(protrusion.probability)]]),
                  ["area beyond the border", format(protrusion.area)],
                  ["length of the border", format(protrusion.border_length)]];
    if (protrusion.border_distance > 0)
      rows.push(["distance of the border from the tip", format(protrusion.border_distance)]);
    if (hasSlot)
      rows.push(["slot of the border", protrusion.border_slot]);
    return rows;
  }

  histogramsOf(protrusion)
  {
    const {border_slot: slot} = protrusion;
    if (slot === null)
      return [];
    return [element("h2", {textContent: "Distance histogram: faces"}),
            histogram(protrusion.distance_histogram, slot, "Distance histogram"),
            element("h2", {textContent: "Sectional-diameter histogram: diameters"}),
            histogram(protrusion.sectional_diameter_histogram, slot, "Sectional-diameter histogram")];
  }
}

// What the numbers are, and in which unit. Shown under the mouse, and in a list.
Panel.meanings = {
  "faces": "number of faces of the file",
  "confidence": "the probability of this segment's weakest border, or its value without probabilities; check low ones first",
  "sticks out of segment": "the segment that gets these faces if the two are merged",
  "tip at face": "the face farthest from the border, counted from 0 in the order of the file",
  "prominence of the border": "the logarithm of how many times wider the surface is behind the border",
  "value of the cut": "from -0.5 to 0.5; grows with the probability and with the size of both sides",
  "probability of the border": "from 0 to 1: how often people put the two sides into different segments",
  "area beyond the border": "of the segment and of all that sticks out of it",
  "length of the border": "in the file's unit of length",
  "distance of the border from the tip": "along the surface, in the file's unit of length",
  "slot of the border": "its slot among a hundred slots of distance from the tip",
};
