// What is shown, as text behind the # of the address: to be kept, sent, and gone back to.

import { PARAMETERS, usual } from "./binary.js";

const CHOICES = {
  show: ["plus", "cross"], window: ["0.02", "0.05", "0.2", "1"], against: ["baseline", "pinned", "none"],
  quantity: ["phase", "amplitude"],
};

/** What is shown when the address says nothing. */
export const beginning = (model) => ({
  model, binary: usual(), modes: null, show: "plus", window: "0.05", against: "baseline", quantity: "phase", noise: "aligo",
  pinned: null,
});

/** The state as text; what is as in the beginning is left out. */
export function toAddress(state) {
  const words = new URLSearchParams();
  writeWaveform(words, "", state);
  for (const name of [...Object.keys(CHOICES), "noise"]) if (state[name] !== beginning()[name]) words.set(name, state[name]);
  if (state.pinned) writeWaveform(words, "b.", state.pinned);
  return words.toString();
}

/** The state that a text describes. What it does not know is left as in the beginning. */
export function fromAddress(text, model) {
  const words = new URLSearchParams(text.replace(/^#/, "")), state = beginning(model);
  Object.assign(state, readWaveform(words, "", model));
  for (const [name, known] of Object.entries(CHOICES)) if (known.includes(words.get(name))) state[name] = words.get(name);
  if (words.get("noise")) state.noise = words.get("noise");
  if (words.has("b.model")) state.pinned = readWaveform(words, "b.", model);
  if (state.against === "pinned" && !state.pinned) state.against = "baseline";
  return state;
}

function writeWaveform(words, prefix, { model, binary, modes }) {
  words.set(`${prefix}model`, model);
  for (const [name, value] of Object.entries(usual()))
    if (binary[name] !== value) words.set(prefix + name, String(binary[name]));
  if (modes) words.set(`${prefix}modes`, modes.join("_"));
}

function readWaveform(words, prefix, model) {
  const binary = usual();
  for (const name of Object.keys(PARAMETERS)) {
    const value = words.get(prefix + name);
    if (value !== null && value.trim() !== "" && Number.isFinite(+value)) binary[name] = +value;
  }
  const modes = (words.get(`${prefix}modes`) || "").split("_").filter((mode) => /^\d\d$/.test(mode));
  return { model: words.get(`${prefix}model`) || model, binary, modes: words.has(`${prefix}modes`) ? modes : null };
}
