// Pictures and their numbers as files.

import { byId } from "../common/dom.js";
import { colour } from "../plots/palette.js";
import { shown } from "./pictures.js";

/** Hand a file to the visitor. */
export function save(name, content, media) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(content instanceof Blob ? content : new Blob([content], { type: media }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}

/** What a picture shows as text: a column for what is across, one for each line; other places across follow with their own. */
export function csvOf({ series, x }) {
  const groups = new Map();
  for (const one of series) groups.set(one.x, [...(groups.get(one.x) || []), one]);
  const columns = [...groups].flatMap(([places, lines]) => [
    [x.label, places], ...lines.map((one) => [one.name, one.y]),
  ]);
  const length = Math.max(...columns.map(([, values]) => values.length));
  const lines = [columns.map(([name]) => `"${name}"`).join(",")];
  for (let i = 0; i < length; i++)
    lines.push(columns.map(([, values]) => (Number.isFinite(values[i]) ? values[i] : "")).join(","));
  return `${lines.join("\n")}\n`;
}

export const saveCsv = (name) => save(`bnserve-${name}.csv`, csvOf(shown(name).spec), "text/csv");

/** A picture with its title and its legend, as a PNG. */
export function savePng(name) {
  const { canvas, spec } = shown(name), ratio = window.devicePixelRatio || 1, head = 44 * ratio;
  const whole = document.createElement("canvas");
  whole.width = canvas.width; whole.height = canvas.height + head;
  const context = whole.getContext("2d");
  context.fillStyle = colour("card");
  context.fillRect(0, 0, whole.width, whole.height);
  context.drawImage(canvas, 0, head);
  context.scale(ratio, ratio);
  context.fillStyle = colour("ink");
  context.font = "600 15px system-ui, sans-serif";
  context.fillText(byId(`${name}-picture`).querySelector("h2").textContent, 8, 18);
  context.font = "12px system-ui, sans-serif";
  let left = 8;
  for (const one of spec.series) {
    context.fillStyle = colour(one.colour);
    context.fillText(one.legend || one.name, left, 36);
    left += context.measureText(one.legend || one.name).width + 14;
  }
  whole.toBlob((blob) => save(`bnserve-${name}.png`, blob));
}
