// The values under the pointer: a line through them, and a small table beside it.

import { make } from "../common/dom.js";
import { number } from "../common/numbers.js";

/** Show values of a plot where the pointer is, or the finger. */
export function hover(plot) {
  const rule = make("div", { class: "rule", hidden: true }), card = make("div", { class: "values", hidden: true });
  plot.holder.append(rule, card);
  const hide = () => { rule.hidden = card.hidden = true; };
  plot.moved = hide;
  plot.canvas.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") hide(); }); // a finger covers them
  plot.canvas.addEventListener("pointermove", (event) => show(event.offsetX));
  plot.canvas.addEventListener("pointerdown", (event) => show(event.offsetX));

  function show(pixel) {
    const { box, spec } = plot;
    if (!box || pixel < box.left || pixel > box.right) { hide(); return; }
    const x = plot.x.inverse(pixel);
    const rows = spec.series.filter((one) => one.x.length).map((one) => {
      const i = nearest(one.x, x, plot.x);
      return Number.isFinite(one.y[i]) && Math.abs(plot.x.at(one.x[i]) - pixel) < 12 ? [one, one.x[i], one.y[i]] : null;
    }).filter(Boolean);
    if (!rows.length) { hide(); return; }
    rule.style.left = `${pixel}px`;
    card.replaceChildren(
      make("div", { class: "where", text: `${number(rows[0][1] * (spec.x.factor || 1))} ${spec.x.unit}` }),
      ...rows.map(([one, , y]) => make("div", {},
        make("i", { class: `swatch c-${one.colour}` }),
        make("span", { text: one.name }), make("b", { text: `${number(y)}${spec.y.unit ? ` ${spec.y.unit}` : ""}` }))),
    );
    rule.hidden = card.hidden = false;
    const room = plot.holder.clientWidth, width = card.offsetWidth;
    card.style.left = `${pixel + 14 + width > room ? Math.max(0, pixel - 14 - width) : pixel + 14}px`;
  }
}

/** The index of the value that is nearest on the screen, of values in order, rising or falling. */
function nearest(values, x, axis) {
  const rising = values[values.length - 1] >= values[0];
  let low = 0, high = values.length - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (values[middle] <= x === rising) low = middle; else high = middle;
  }
  return Math.abs(axis.at(values[low]) - axis.at(x)) <= Math.abs(axis.at(values[high]) - axis.at(x)) ? low : high;
}
