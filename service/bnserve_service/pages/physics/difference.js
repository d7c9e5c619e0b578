// How two waveforms differ: what is left when one of them is moved in time and phase to fit the other best.

import { asdAt } from "./noise.js";

/** Weights |a| |b| / S df of the noise-weighted scalar product, at frequencies of which only the common ones count. */
function weightsOf(curve, f, a, b) {
  return f.map((here, i) => {
    const step = 0.5 * ((f[i + 1] ?? here) - (f[i - 1] ?? here));
    return a[i] > 0 && b[i] > 0 ? (step * a[i] * b[i]) / asdAt(curve, here) ** 2 : 0;
  });
}

const norm = (curve, f, a) => weightsOf(curve, f, a, a).reduce((sum, weight) => sum + weight, 0);

/** The best time (s): from the weighted straight line through the phases, by Newton's steps on the overlap. */
function bestTime(f, delta, weights) {
  let sum = 0, mean = 0, slope = 0;
  weights.forEach((w, i) => { sum += w; mean += w * f[i]; slope += w * delta[i]; });
  mean /= sum;
  const middle = slope / sum;
  let top = 0, spread = 0;
  weights.forEach((w, i) => { top += w * (f[i] - mean) * (delta[i] - middle); spread += w * (f[i] - mean) ** 2; });
  const start = top / spread, width = 2 * Math.PI / Math.sqrt(spread / sum);
  let best = [-1, start];
  for (let k = -200; k <= 200; k++) {
    const at = start + (k / 200) * 4 * width, found = overlap(f, delta, weights, at)[0];
    if (found > best[0]) best = [found, at];
  }
  for (let step = width / 100; step > 1e-9 * width; step /= 2)
    for (const at of [best[1] - step, best[1] + step]) {
      const found = overlap(f, delta, weights, at)[0];
      if (found > best[0]) best = [found, at];
    }
  return best[1];
}

function overlap(f, delta, weights, slope) {
  let re = 0, im = 0;
  for (let i = 0; i < f.length; i++) {
    if (!weights[i]) continue;
    const angle = delta[i] - slope * f[i];
    re += weights[i] * Math.cos(angle); im += weights[i] * Math.sin(angle);
  }
  return [Math.hypot(re, im), Math.atan2(im, re)];
}

/** Mismatch of two waveforms `{amplitude, phase}` over time and phase, the phase difference that is left (rad), and the
 * relative difference of the amplitudes. */
export function differenceOf(curve, f, one, other) {
  const weights = weightsOf(curve, f, one.amplitude, other.amplitude);
  const delta = f.map((_, i) => one.phase[i] - other.phase[i]);
  if (!weights.some((weight) => weight > 0)) return null;
  const slope = bestTime(f, delta, weights), [found, constant] = overlap(f, delta, weights, slope);
  const norms = Math.sqrt(norm(curve, f, one.amplitude) * norm(curve, f, other.amplitude));
  const turn = 2 * Math.PI;
  const raw = f.map((here, i) => delta[i] - slope * here - constant);
  const heaviest = weights.indexOf(Math.max(...weights));
  const whole = turn * Math.round(raw[heaviest] / turn);
  return {
    weights,
    mismatch: Math.max(0, 1 - found / norms),
    phase: raw.map((left, i) => (one.amplitude[i] > 0 && other.amplitude[i] > 0 ? left - whole : NaN)),
    amplitude: f.map((_, i) => (other.amplitude[i] > 0 ? one.amplitude[i] / other.amplitude[i] - 1 : NaN)),
  };
}
