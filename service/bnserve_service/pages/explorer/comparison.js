// What a waveform is compared with: the post-Newtonian baseline, or another waveform that was kept as B.

import { baseline, baselineTerms } from "../physics/baseline.js";
import { differenceOf } from "../physics/difference.js";
import { describe } from "./models.js";
import { evaluate } from "./questions.js";

const COUNTS = 1e-6; // of the largest weight: where a difference is worth showing

/** What else is drawn (`other`), and how `found` differs from it; both null where nothing is to be compared. */
export async function compare(state, found, curves, signal) {
  const curve = curves.find((one) => one.key === state.noise) || curves[0];
  if (state.against === "none") return { other: null, difference: null };
  if (state.against === "pinned") {
    const model = await describe(state.pinned.model);
    const other = await evaluate(state.pinned, model, { window: state.window, frequencies: found.frequencies, signal });
    return { other, difference: told(curve, found, other.phases, "b", "B") };
  }
  const expected = baseline(found.binary, found.frequencies, await baselineTerms()), c = Math.cos(found.binary.inclination);
  const other = found.precesses ? null : { baseline: expected, seen: { plus: (1 + c * c) / 2, cross: Math.abs(c) } };
  return { other, difference: told(curve, found, expected, "pn", "the post-Newtonian baseline") };
}

function told(curve, { frequencies, phases }, expected, colour, name) {
  const found = differenceOf(curve, frequencies, phases, expected);
  if (!found) return null;
  const most = Math.max(...found.weights);
  return { ...found, colour, name, noise: curve.name, counts: found.weights.map((weight) => weight > COUNTS * most) };
}
