// How right a model is: the mismatch to fresh waveforms of its generator, overall, by mode, and by parameter.

import { make } from "../common/dom.js";
import { number } from "../common/numbers.js";
import { Plot } from "../plots/plot.js";
import { rangeOf } from "../plots/scale.js";

const QUANTILES = ["median", "90 %", "99 %", "max"];
const COLOURS = { median: "m21", "90 %": "a", "99 %": "m44", max: "b" };
const WHERE = { uniform: "uniform in the range", edges: "at the edges of the range" };
const ROWS = {
  mismatch: "mismatch of (2, 2)", baseline_mismatch: "mismatch of the baseline alone",
  merger_time_error_seconds: "time of the merger (s)", merger_phase_error_radians: "phase of the merger (rad)",
};

function row(words, found) {
  return make("tr", {}, make("td", { text: words }), ...QUANTILES.map((name) => make("td", { class: "n", text: number(found[name], 3) })));
}

function table(words, found) {
  const known = Object.entries(ROWS).filter(([name]) => found[name]);
  const modes = Object.entries(found.modes || {});
  return make("div", { class: "scroll", tabindex: "0", role: "region", "aria-label": words }, make("table", {},
    make("tr", {}, make("th", { text: `${found.count?.toLocaleString("en") ?? ""} waveforms, ${words}` }),
      ...QUANTILES.map((name) => make("th", { class: "n", text: name }))),
    ...known.map(([name, text]) => row(text, found[name])),
    ...modes.map(([mode, of]) => row(`error of (${mode[0]}, ${mode[1]}), of (2, 2)`, of))));
}

/** The cards of a model's accuracy; what a model does not state is left out. */
export function accuracyCards({ accuracy }) {
  const stated = Object.entries(WHERE).filter(([name]) => accuracy[name]);
  if (!stated.length) return [freely(accuracy)];
  const noise = accuracy.noise ? ` in the noise of ${accuracy.noise}` : "", mass = accuracy.total_mass ? `, at ${accuracy.total_mass} M☉` : "";
  const overall = make("section", { class: "card" }, make("h2", { text: "Accuracy" }),
    make("p", { class: "soft", text: `Against fresh waveforms of its generator${noise}${mass}.` }),
    ...stated.map(([name, words]) => table(words, accuracy[name])));
  return accuracy.by_parameter ? [overall, byParameter(accuracy.by_parameter)] : [overall];
}

/** What a model of somebody else's says, in its own form. */
function freely(accuracy) {
  const said = Object.keys(accuracy || {}).length;
  return make("section", { class: "card" }, make("h2", { text: "Accuracy" }),
    said ? make("pre", { tabindex: "0", text: JSON.stringify(accuracy, null, 2) }) : make("p", { class: "soft", text: "Not stated." }));
}

function byParameter(bins) {
  const panels = make("div", { class: "panels" });
  const values = Object.values(bins).flat().flatMap((bin) => QUANTILES.map((name) => bin[name]));
  const y = { ...rangeOf(values, { log: true }), label: "mismatch", unit: "" };
  for (const [name, of] of Object.entries(bins)) {
    const plot = make("div", { class: "plot" }, make("canvas", { role: "img", "aria-label": `Mismatch by ${name}` }));
    panels.append(make("figure", {}, make("h3", {}, make("code", { text: name })), plot));
    const series = QUANTILES.map((quantile) => ({
      name: quantile, colour: COLOURS[quantile], width: 2,
      x: of.flatMap((bin) => [bin.from, bin.to]), y: of.flatMap((bin) => [bin[quantile], bin[quantile]]),
    }));
    new Plot(plot).draw({ x: { low: of[0].from, high: of[of.length - 1].to, label: name, unit: "" }, y, series });
  }
  const legend = make("div", { class: "legend" }, ...QUANTILES.map((name) => make("span", {},
    make("i", { class: `swatch c-${COLOURS[name]}` }), name)));
  return make("section", { class: "card" }, make("h2", { text: "Mismatch by parameter" }), legend, panels);
}
