// What is asked about one waveform, and its answers as the pictures need them.

import { ask } from "../common/session.js";
import { planStrain, strainOf } from "../physics/strain.js";
import { IN_PLANE, PARAMETERS, derived, precesses } from "./binary.js";
import { bandOf, modeKey } from "./models.js";

const POINTS = 1000, POINTS_PRECESSING = 6000;
const LOWEST = 5; // Hz; where the pictures begin, or with the band where that is lower
const EDGE = 1 - 1e-9;

/** A field without a number, or a choice that cannot be asked for. */
export class Unasked extends Error {
  constructor(message, errors) { super(message); this.errors = errors; }
}

/** The question without its grid: what is said of the binary, the modes and the reference. */
export function waveformOf({ binary, modes }, model) {
  const empty = Object.keys(PARAMETERS).filter((name) => !Number.isFinite(binary[name]));
  if (empty.length)
    throw new Unasked(`${PARAMETERS[empty[0]].symbol} has no number. Give one, or choose an example.`,
      empty.map((parameter) => ({ parameter, reason: "Give a number." })));
  if (modes && !modes.length) throw new Unasked("No mode is chosen. Choose one at least.", []);
  const { reference_frequency, ...parameters } = binary;
  if (!precesses(binary)) for (const name of IN_PLANE) delete parameters[name];
  const question = { parameters, alignment: "merger", reference_frequency };
  if (modes && modes.length < model.modes.length) question.modes = modes.map((mode) => [+mode[0], +mode[1]]);
  return question;
}

/** Where the answers of a model and one of its versions are. */
export const pathOf = ({ name, version }) =>
  `v1/models/${encodeURIComponent(name)}/versions/${encodeURIComponent(version)}/waveforms`;

/** Frequencies (Hz), evenly spaced in their logarithm, that show a binary. */
export function frequenciesOf(model, binary) {
  const [low, top] = bandOf(model, binary.total_mass), count = precesses(binary) ? POINTS_PRECESSING : POINTS;
  const from = Math.log(Math.min(LOWEST, low)), to = Math.log(top * EDGE);
  return Array.from({ length: count }, (_, i) => Math.exp(from + ((to - from) * i) / (count - 1)));
}

/** Everything about one waveform. `frequencies` are those of the pictures over frequency, `window` seconds of h(t). */
export async function evaluate(waveform, model, { window, frequencies, signal }) {
  const question = waveformOf(waveform, model), { binary } = waveform, path = pathOf(model);
  const post = (body) => ask(path, { body, binary: true, signal });
  const top = bandOf(model, binary.total_mass)[1] * EDGE;
  const plan = planStrain(+window * (binary.total_mass / 2.8), binary.total_mass, derived(binary).chirpMass, top,
    model.limits.max_frequencies);
  const aligned = { ...question, parameters: { ...question.parameters, time_shift: 0 }, modes: [[2, 2]] };
  for (const name of IN_PLANE) delete aligned.parameters[name];
  const inPlane = precesses(binary);
  const answers = await Promise.all([
    post({ ...question, grid: { frequencies }, output: inPlane ? "polarizations" : "modes" }),
    post({ ...aligned, grid: { frequencies }, output: "amplitude_phase" }),
    post({ ...question, grid: plan.grid, dtype: "complex64" }),
  ]);
  const [spectrum, phases, time] = answers.map((answer) => answer.content);
  const estimate = spectrum.estimated_mismatch ?? phases.estimated_mismatch;
  return {
    binary, model, frequencies, precesses: inPlane,
    spectrum: inPlane ? polarisations(spectrum) : summed(spectrum, question.modes || model.modes),
    phases: { amplitude: [...phases.amplitude.data], phase: [...phases.phase.data] },
    strain: strainOf(plan, time.h_plus.data, time.h_cross.data),
    estimatedMismatch: estimate ? estimate.data[0] : null,
    milliseconds: Math.max(...answers.map((answer) => answer.milliseconds)),
    asked: 2 * frequencies.length + Math.round((plan.grid.f_max - plan.grid.f_min) / plan.grid.delta_f) + 1,
  };
}

const size = (parts, i) => Math.hypot(parts[2 * i], parts[2 * i + 1]);

function polarisations({ h_plus, h_cross }) {
  const of = ({ data }) => Float64Array.from({ length: data.length / 2 }, (_, i) => size(data, i));
  return { total: { plus: of(h_plus), cross: of(h_cross) }, modes: [] };
}

/** |h| of the sum over modes and of each of them, in both polarisations. */
function summed(answer, chosen) {
  const total = {}, modes = chosen.map((mode) => ({ mode }));
  for (const [name, factor] of [["plus", "plus_"], ["cross", "cross_"]]) {
    let re, im;
    for (const one of modes) {
      const { data } = answer[`h_${modeKey(one.mode)}`], by = answer[factor + modeKey(one.mode)].data, count = data.length / 2;
      const [c, d] = by.length === 2 ? by : [by[0], 0];
      re ||= new Float64Array(count); im ||= new Float64Array(count);
      one[name] = new Float64Array(count);
      for (let i = 0; i < count; i++) {
        const a = data[2 * i], b = data[2 * i + 1];
        re[i] += a * c - b * d; im[i] += a * d + b * c;
        one[name][i] = Math.hypot(c, d) * Math.hypot(a, b);
      }
    }
    total[name] = Float64Array.from(re, (part, i) => Math.hypot(part, im[i]));
  }
  return { total, modes };
}
