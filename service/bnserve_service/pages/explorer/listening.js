// The chirp as sound. Neutron stars merge in the middle of what people hear; heavier ones are played faster.

import { ask } from "../common/session.js";
import { planStrain, strainOf } from "../physics/strain.js";
import { derived } from "./binary.js";
import { bandOf } from "./models.js";
import { pathOf, waveformOf } from "./questions.js";

const LENGTH = 2.5; // seconds to listen to
const LOUD = 0.7;
let playing = null;

/** How many times faster than it is a signal is played. */
export const speedOf = ({ total_mass: M }) => Math.max(1, M / 4);

/** Play the last seconds before the merger; resolves when it ended. A second call ends it. */
export async function listen(state, model) {
  if (playing) { playing.stop(); return; }
  const context = new AudioContext(), { binary } = state, top = bandOf(model, binary.total_mass)[1] * (1 - 1e-9);
  const speed = speedOf(binary);
  const plan = planStrain(LENGTH * speed, binary.total_mass, derived(binary).chirpMass, top,
    model.limits.max_frequencies, 12);
  const question = { ...waveformOf(state, model), grid: plan.grid, dtype: "complex64" };
  const { content } = await ask(pathOf(model), { body: question, binary: true });
  const strain = strainOf(plan, content.h_plus.data, content.h_cross.data)[state.show];
  const rate = Math.min(96000, Math.max(8000, strain.length ? plan.rate * speed : 8000));
  const sound = context.createBuffer(1, strain.length, rate), largest = Math.max(1e-300, strain.reduce((a, h) => Math.max(a, Math.abs(h)), 0));
  sound.copyToChannel(Float32Array.from(strain, (h, i) => LOUD * (h / largest) * Math.min(1, i / (0.2 * rate))), 0);
  const source = new AudioBufferSourceNode(context, { buffer: sound });
  source.connect(context.destination);
  playing = source;
  await context.resume();
  await new Promise((ended) => { source.onended = ended; source.start(); });
  playing = null;
  await context.close();
}
