// The four pictures, drawn from what was answered about one waveform, and about what it is compared with.

import { byId, make } from "../common/dom.js";
import { number, seconds } from "../common/numbers.js";
import { asdAt, signalToNoise } from "../physics/noise.js";
import { trackOf } from "../physics/track.js";
import { modeColour } from "../plots/palette.js";
import { Plot } from "../plots/plot.js";
import { rangeOf } from "../plots/scale.js";

const NOISE = { aligo: ["n1", null], et: ["n2", [6, 4]], ce: ["n3", [2, 3]] };
const DASHED = [6, 4];
const TAGS = [60, 7, 13, 24, 45, 85, 160]; // Hz; where the modes have their names, so that none hides another
const SIGNS = { plus: "h₊", cross: "h×" };
const plots = {};

/** Find the canvases. */
export function makePictures() {
  for (const name of ["strain", "spectrum", "track", "difference"])
    plots[name] = new Plot(byId(`${name}-picture`).querySelector(".plot"));
}

/** What each picture shows, for files. */
export const shown = (name) => plots[name];

function legend(name, series) {
  const told = series.filter((one) => one.name);
  byId(`${name}-picture`).querySelector(".legend").replaceChildren(...told.map((one) => make("span", {},
    make("i", { class: `swatch c-${one.colour}${one.dash ? (one.dash[0] < 4 ? " dotted" : " dashed") : ""}` }), one.legend || one.name)));
}

function describe(name, text) {
  byId(`${name}-picture`).querySelector("canvas").setAttribute("aria-label", text);
}

export function drawAll(state, found, other, difference, curves) {
  drawStrain(state, found, other);
  drawSpectrum(state, found, other, curves);
  drawTrack(found, other);
  drawDifference(state, found, difference);
}

function drawStrain({ show }, { strain, binary }, other) {
  const back = show === "plus" ? "cross" : "plus";
  const series = [
    { name: SIGNS[back], colour: "pale", x: strain.times, y: strain[back], width: 1.2 },
    { name: SIGNS[show], colour: "a", x: strain.times, y: strain[show], width: 1.8 },
  ];
  if (other?.strain) series.splice(1, 0, {
    name: `${SIGNS[show]} of B`, colour: "b", x: other.strain.times, y: other.strain[show], width: 1.6, dash: DASHED,
  });
  const largest = Math.max(...series.flatMap((one) => one.y.map(Math.abs))) || 1;
  plots.strain.draw({
    x: { low: strain.times[0], high: strain.times[strain.times.length - 1], label: "time from the merger (s)", unit: "s" },
    y: { low: -1.08 * largest, high: 1.08 * largest, label: "strain h", unit: "" }, series,
    marks: [{ at: 0, text: "merger", side: "left" }],
  });
  legend("strain", [...series].reverse());
  describe("strain", `Strain against time: the last ${seconds(-strain.times[0])} before the merger, at most ` +
    `${number(largest, 3)}, of a binary of ${number(binary.total_mass, 4)} solar masses at ${number(binary.distance_mpc, 4)} Mpc.`);
}

function drawSpectrum({ show, noise }, found, other, curves) {
  const { frequencies: f, spectrum } = found;
  const effective = (size, at = f) => Array.from(size, (value, i) => 2 * Math.sqrt(at[i]) * value);
  const series = curves.map((curve) => {
    const snr = signalToNoise(curve, f, spectrum.total[show]);
    const y = f.map((at) => asdAt(curve, at));
    return {
      name: curve.name, legend: `${curve.name}: SNR ${number(snr, 3)}`, colour: (NOISE[curve.key] || ["soft"])[0],
      dash: NOISE[curve.key]?.[1], x: f,
      y: y.map((value) => (Number.isFinite(value) ? value : NaN)), width: curve.key === noise ? 2.2 : 1.3,
    };
  });
  const lines = spectrum.modes.length
    ? [...spectrum.modes].reverse().map((one) => ({
      name: `(${one.mode.join(", ")})`, colour: modeColour(one.mode), x: f, y: effective(one[show]), width: 1.6,
      tag: (TAGS[spectrum.modes.indexOf(one)] * f[0]) / 4,
    }))
    : [{ name: `|${SIGNS[show]}|`, colour: "a", x: f, y: effective(spectrum.total[show]), width: 1.4 }];
  if (lines.length) lines[lines.length - 1].width = spectrum.modes.length ? 2.6 : 1.4;
  const all = [...series, ...lines];
  if (other?.spectrum) all.push({
    name: "B", colour: "b", x: other.frequencies, y: effective(other.spectrum.total[show], other.frequencies), width: 1.6, dash: DASHED,
  });
  if (other?.baseline) all.push({
    name: "post-Newtonian", colour: "pn", x: f, y: effective(other.baseline.amplitude.map((size, i) => size * other.seen[show])),
    width: 1.5, dash: DASHED,
  });
  const values = [...series.flatMap((one) => one.y), ...lines.flatMap((one) => one.y)];
  plots.spectrum.draw({
    x: { ...rangeOf(f, { log: true, room: 0 }), label: "frequency (Hz)", unit: "Hz" },
    y: { ...rangeOf(values, { log: true, decades: 5.5 }), label: `2√f |${SIGNS[show]}|, noise (Hz^-½)`.replace("Hz^-½", "1/√Hz"), unit: "/√Hz" },
    series: all,
  });
  legend("spectrum", [...(spectrum.modes.length ? [] : lines), ...series, ...all.slice(series.length + lines.length)]);
  describe("spectrum", `Spectrum against noise: ${series.map((one) => one.legend).join(", ")}.`);
}

function drawTrack(found, other) {
  const least = 1e-3 * (found.binary.total_mass / 2.8);
  const of = (one, name, colour, dash) => {
    const points = trackOf(one.frequencies, one.phases, least);
    return { name, colour, dash, x: points.map(([t]) => t), y: points.map(([, at]) => at), width: 2.4 };
  };
  const series = [of(found, found.precesses ? "(2, 2), aligned spins alone" : "(2, 2)", "a")];
  if (other?.spectrum) series.push(of(other, "B", "b", DASHED));
  plots.track.draw({
    x: { ...rangeOf([...series.flatMap((one) => one.x), least], { log: true, room: 0.01 }), reversed: true, label: "time until the merger (s)", unit: "s" },
    y: { ...rangeOf(series.flatMap((one) => one.y), { log: true }), label: "frequency of (2, 2) (Hz)", unit: "Hz" }, series,
  });
  legend("track", series);
  const [x, y] = [series[0].x, series[0].y];
  describe("track", x.length ? `Frequency against time: from ${number(y[0], 3)} Hz, ${seconds(x[0])} before the merger, to ` +
    `${number(y[y.length - 1], 3)} Hz.` : "Frequency against time: nothing to show.");
}

function drawDifference({ quantity }, { frequencies: f }, difference) {
  const panel = byId("difference-picture");
  panel.querySelector(".none").hidden = Boolean(difference);
  panel.querySelector(".plot").hidden = !difference;
  legend("difference", []);
  if (!difference) return;
  const { colour, name } = difference, isPhase = quantity === "phase";
  const y = isPhase ? difference.phase : difference.amplitude.map((part) => 100 * part);
  const inside = y.filter((_, i) => difference.counts[i]);
  const series = [{ name: isPhase ? "phase" : "amplitude", colour, x: f, y, width: 2 }];
  plots.difference.draw({
    x: { ...rangeOf(f, { log: true, room: 0 }), label: "frequency (Hz)", unit: "Hz" },
    y: { ...rangeOf([...inside, 0], { room: 0.12 }), label: isPhase ? "phase difference (rad)" : "amplitude difference (%)", unit: isPhase ? "rad" : "%" },
    series,
  });
  legend("difference", [{ ...series[0], name: `A less ${name}; mismatch ${number(difference.mismatch, 3)}` }]);
  describe("difference", `Difference of the (2, 2) mode to ${name}: mismatch ${number(difference.mismatch, 3)}.`);
}
