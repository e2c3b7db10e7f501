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

class Panel
{
  constructor(model, onSelect)
  {
    this.model = model;
    this.onSelect = onSelect;
    const {data} = model;
    const name = data.input.split(/[\\/]/).pop();
    document.title = `${name} – protrusions`;
    this.part("title").textContent = name;
    this.part("summary").textContent =
      `${data.faces.toLocaleString("en")} faces, ${data.segments} segments in ${format(data.seconds)} s; ` +
      `method ${data.method}, distance ${data.distance}`;
    this.part("note").hidden = data.note === null;
    this.part("note").textContent = data.note ?? "";
  }

  part(id) { return document.getElementById(id); }

  nameOf(segment)
  {
    return segment < this.model.minimum ? `${segment}: body` : `${segment}`;
  }

  show(selected)
  {
    const bodies = Array.from({length: this.model.minimum}, (_, s) => s);
    this.part("tree").replaceChildren(...bodies.map(s => this.branch(s, selected)));
    this.part("details").replaceChildren(...this.details(selected));
  }

  branch(segment, selected)
  {
    const swatch = element("span", {className: "swatch"});
    swatch.style.background = `rgb(${this.model.colors[segment].join()})`;
    const button = element("button", {type: "button", onclick: () => this.onSelect(segment)},
                           swatch, this.nameOf(segment));
    button.setAttribute("aria-pressed", segment === selected);
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
    const protrusion = this.model.protrusions.get(selected);
    if (protrusion)
      rows.push(...this.rowsOf(protrusion));
    const table = element("table", {}, ...rows.map(([name, value]) => element(
      "tr", {}, element("th", {textContent: name}), element("td", {textContent: value}))));
    return [element("h2", {textContent: `Segment ${this.nameOf(selected)}`}), table,
            ...(protrusion ? this.histogramsOf(protrusion) : [])];
  }

  rowsOf(protrusion)
  {
    const hasSlot = protrusion.border_slot !== null;
    const rows = [["sticks out of segment", this.model.ancestors[protrusion.parent]], ["tip at face", protrusion.tip],
                  [hasSlot ? "prominence of the border" : "value of the cut", format(protrusion.value)],
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
