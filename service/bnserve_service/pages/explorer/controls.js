// Sliders with numbers beside them, chips for modes, and errors at the field they belong to.

import { byId, make } from "../common/dom.js";
import { GROUPS, PARAMETERS } from "./binary.js";
import { modeKey } from "./models.js";
import { modeColour } from "../plots/palette.js";

const rows = {};

/** Make the controls of all parameters; `changed(name, value)` is called with NaN for an emptied field. */
export function makeControls(place, changed) {
  place.replaceChildren(...GROUPS.map(({ title, names, folded, words }) => {
    const content = [words ? make("p", { class: "soft small", text: words }) : null, ...names.map((name) => row(name, changed))];
    return folded
      ? make("details", { class: "group", id: "precession" }, make("summary", { text: title }), ...content)
      : make("fieldset", { class: "group" }, make("legend", { text: title }), ...content);
  }));
}

function row(name, changed) {
  const { symbol, words, unit, log } = PARAMETERS[name];
  const number = make("input", {
    type: "number", id: `n-${name}`, name, step: "any", inputmode: "decimal", "aria-describedby": `e-${name}`, required: true,
  });
  const range = make("input", { type: "range", id: `r-${name}`, step: "any", "aria-label": `${symbol}, ${words}: slider` });
  const error = make("p", { class: "field-error", id: `e-${name}`, hidden: true });
  const bend = log ? Math.log : (value) => value, straight = log ? Math.exp : (value) => value;
  number.addEventListener("input", () => {
    const value = number.value.trim() === "" ? NaN : +number.value;
    if (Number.isFinite(value)) range.value = bend(value);
    changed(name, value);
  });
  range.addEventListener("input", () => {
    const value = rounded(straight(+range.value), name);
    number.value = value;
    changed(name, value);
  });
  rows[name] = { number, range, error, bend };
  return make("div", { class: "control" },
    make("label", { for: `n-${name}` }, make("b", { text: symbol }), ` ${words}`),
    make("span", { class: "field" }, number, make("span", { class: "unit", text: unit })), range, error);
}

function rounded(value, name) {
  const { low, high } = rows[name];
  if (value >= high) return high;
  return value <= low ? low : +value.toPrecision(Math.abs(value) < 1 ? 3 : 4);
}

/** Put a binary and the ranges of a model into the controls. */
export function fillControls(binary, model) {
  const known = Object.fromEntries(model.parameters.map((entry) => [entry.name, entry]));
  for (const [name, { number, range, bend }] of Object.entries(rows)) {
    const { ends, log } = PARAMETERS[name], entry = known[name] || {};
    const stated = entry.minimum > 0 || !log ? entry.minimum : null;
    const low = stated ?? ends[0], high = entry.maximum ?? ends[1];
    Object.assign(rows[name], { low, high });
    range.min = bend(low); range.max = bend(high);
    range.value = bend(binary[name]);
    if (document.activeElement !== number || +number.value !== binary[name])
      number.value = Number.isFinite(binary[name]) ? binary[name] : "";
  }
}

/** Say at the fields what is wrong with them, and that nothing is with the others. */
export function markErrors(errors) {
  for (const [name, { number, error }] of Object.entries(rows)) {
    const found = errors.find((one) => one.parameter === name);
    error.hidden = !found;
    error.textContent = found ? sentence(found.reason) : "";
    if (found) number.setAttribute("aria-invalid", "true"); else number.removeAttribute("aria-invalid");
    if (found) number.closest("details")?.setAttribute("open", "");
  }
}

const sentence = (text) => `${text[0].toUpperCase()}${text.slice(1)}${/[.!]$/.test(text) ? "" : "."}`;

/** The chips of a model's modes; `chosen` is null for all. */
export function fillModes(model, chosen, changed) {
  const place = byId("modes");
  byId("modes-group").hidden = model.modes.length < 2;
  place.replaceChildren(...model.modes.map((mode) => {
    const key = modeKey(mode);
    const box = make("input", { type: "checkbox", value: key, checked: !chosen || chosen.includes(key) });
    box.addEventListener("change", () => {
      const on = [...place.querySelectorAll("input:checked")].map((one) => one.value);
      changed(on.length === model.modes.length ? null : on);
    });
    return make("label", { class: `chip c-${modeColour(mode)}` }, box, make("span", { text: `(${mode.join(", ")})` }));
  }));
}
