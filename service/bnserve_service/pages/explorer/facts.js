// The numbers above the pictures.

import { byId, make } from "../common/dom.js";
import { number, seconds } from "../common/numbers.js";
import { derived } from "./binary.js";

/** The time (s) that is left when the (2, 2) mode passes `f` (Hz); NaN above the band. */
function timeFrom({ frequencies, phases: { phase, amplitude } }, f) {
  const i = frequencies.findIndex((at) => at >= f);
  if (i < 1 || !(amplitude[i] > 0)) return NaN;
  return (phase[i] - phase[i - 1]) / (frequencies[i] - frequencies[i - 1]) / (2 * Math.PI);
}

/** Say what the binary and its waveform are. */
export function tellFacts(found, difference) {
  const { m1, m2, chirpMass, lambdaTilde } = derived(found.binary), left = timeFrom(found, 20);
  const rows = [
    ["Masses", `${number(m1, 4)} + ${number(m2, 4)} M☉`], ["Chirp mass", `${number(chirpMass, 5)} M☉`],
    ["Λ̃", number(lambdaTilde, 4)], ["From 20 Hz", left > 0 ? seconds(left) : "–"],
    ["Est. mismatch", found.estimatedMismatch === null ? "not stated" : number(found.estimatedMismatch, 2)],
    [difference ? `Mismatch to ${difference.name === "B" ? "B" : "PN"}` : "Mismatch", difference ? number(difference.mismatch, 3) : "–"],
  ];
  byId("facts").replaceChildren(...rows.map(([term, value]) => make("div", {}, make("dt", { text: term }), make("dd", { text: value }))));
  byId("status").textContent = `${found.asked.toLocaleString("en")} frequencies, ${found.milliseconds.toFixed(0)} ms`;
}
