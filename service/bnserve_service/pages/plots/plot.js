// A picture on a canvas: axes with ticks and units, lines, and values where the pointer is.

import { colour } from "./palette.js";
import { superscript } from "../common/numbers.js";
import { hover } from "./hover.js";
import { scale, ticks } from "./scale.js";

const FONT = "12px system-ui, sans-serif";
const LEFT = 50, RIGHT = 12, TOP = 26, BOTTOM = 36;

/** A picture in `holder`, a positioned element with a canvas. */
export class Plot {
  constructor(holder) {
    this.holder = holder;
    this.canvas = holder.querySelector("canvas");
    this.spec = null;
    new ResizeObserver(() => this.redraw()).observe(holder);
    window.addEventListener("theme", () => this.redraw());
    hover(this);
  }

  /** Draw `{x: {low, high, log, label, reversed}, y: {...}, series: [{name, colour, x, y, width, dash, tag}], marks}`. */
  draw(spec) {
    this.spec = spec;
    this.redraw();
  }

  redraw() {
    const width = this.canvas.clientWidth, height = this.canvas.clientHeight;
    if (!this.spec || width < 80 || height < 80) return;
    const ratio = window.devicePixelRatio || 1;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const context = this.canvas.getContext("2d");
    context.scale(ratio, ratio);
    context.font = FONT;
    this.box = { left: LEFT, right: width - RIGHT, top: TOP, bottom: height - BOTTOM };
    const { left, right, top, bottom } = this.box, { x, y } = this.spec;
    this.x = x.reversed ? scale(x, right, left) : scale(x, left, right);
    this.y = scale(y, bottom, top);
    axes(context, this);
    context.save();
    context.beginPath();
    context.rect(left, top, right - left, bottom - top);
    context.clip();
    for (const one of this.spec.series) line(context, this, one);
    for (const mark of this.spec.marks || []) upright(context, this, mark);
    context.restore();
    this.moved?.();
  }
}

function axes(context, { box: { left, right, top, bottom }, spec, x, y }) {
  context.fillStyle = colour("plot");
  context.fillRect(left, top, right - left, bottom - top);
  context.lineWidth = 1;
  context.strokeStyle = colour("line");
  context.fillStyle = colour("soft");
  const across = ticks(x, 64), up = ticks(y, 34);
  context.textAlign = "center";
  for (const { value, text } of across.marks) {
    const at = Math.round(x.at(value)) + 0.5;
    stroke(context, at, top, at, bottom);
    context.fillText(text, Math.min(at, right - context.measureText(text).width / 2 + RIGHT - 2), bottom + 15);
  }
  context.textAlign = "right";
  for (const { value, text } of up.marks) {
    const at = Math.round(y.at(value)) + 0.5;
    stroke(context, left, at, right, at);
    context.fillText(text, left - 6, at + 4);
  }
  context.textAlign = "right";
  context.fillText(labelOf(spec.x.label, across.power), right, bottom + 31);
  context.textAlign = "left";
  context.fillText(labelOf(spec.y.label, up.power), 6, 14);
}

const labelOf = (label, power) => (power ? label.replace(/( \(|$)/, ` × 10${superscript(-power)}$1`) : label);

function stroke(context, x1, y1, x2, y2) {
  context.beginPath();
  context.moveTo(x1, y1);
  context.lineTo(x2, y2);
  context.stroke();
}

function line(context, { x, y, spec }, one) {
  context.strokeStyle = colour(one.colour);
  context.lineWidth = one.width ?? 2;
  context.lineJoin = "round";
  context.setLineDash(one.dash || []);
  context.beginPath();
  let drawing = false;
  for (let i = 0; i < one.x.length; i++) {
    const there = Number.isFinite(one.y[i]) && (!spec.y.log || one.y[i] > 0) && (!spec.x.log || one.x[i] > 0);
    if (there) context[drawing ? "lineTo" : "moveTo"](x.at(one.x[i]), Math.max(-1e4, Math.min(1e4, y.at(one.y[i]))));
    drawing = there;
  }
  context.stroke();
  context.setLineDash([]);
  if (one.tag) tagged(context, { x, y }, one);
}

/** The name of a line beside it, where `tag` says, or the first place after it where the line can be seen. */
function tagged(context, { x, y }, { name, x: places, y: values, tag }) {
  const i = places.findIndex((place, k) => place >= tag && values[k] > y.low && values[k] < y.high);
  if (i < 0) return;
  context.textAlign = "left";
  context.lineWidth = 4;
  const ink = context.strokeStyle;
  context.strokeStyle = colour("plot");
  context.strokeText(name, x.at(places[i]), y.at(values[i]) - 5);
  context.fillStyle = ink;
  context.fillText(name, x.at(places[i]), y.at(values[i]) - 5);
}

function upright(context, { x, box: { top, bottom, right } }, { at, text, side = "right" }) {
  const place = Math.round(x.at(at)) + 0.5;
  context.strokeStyle = context.fillStyle = colour("mark");
  context.lineWidth = 1;
  context.setLineDash([4, 3]);
  stroke(context, place, top, place, bottom);
  context.setLineDash([]);
  const left = side === "left" || place + context.measureText(text).width + 8 > right;
  context.textAlign = left ? "right" : "left";
  context.fillText(text, place + (left ? -5 : 5), top + 13);
}
