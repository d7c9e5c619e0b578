// h(t) around the merger, from h(f) on a uniform grid: which grid to ask for, and its transform.
//
// As bnserve_protocol's predict_time_domain, but for how the signal begins: there every mode fades in at the same moment,
// long before the window that is drawn; here all of them do between two frequencies that belong to earlier moments.

import { inverseTransform } from "./fft.js";

const SOLAR_MASS_SECONDS = 4.925491025543576e-6;
const AFTER = 0.005 / 2.8; // seconds drawn after the merger, for each solar mass
const FADE = 0.7; // of the lowest frequency: there the spectrum begins
const TOP = 0.15; // part of the band below its end over which the spectrum fades out
const MOST_FREQUENCIES = 2 ** 18; // of one question: 4 MiB

/** Frequency (Hz) of the (2, 2) mode so many seconds before the merger, by the quadrupole formula. */
export function frequencyAt(secondsBefore, chirpMass) {
  return (5 / (256 * secondsBefore)) ** 0.375 * (chirpMass * SOLAR_MASS_SECONDS) ** -0.625 / Math.PI;
}

/** What to ask for so that the last `window` seconds of a binary can be drawn: a uniform grid of at most `most` frequencies,
 * and how to transform it. */
export function planStrain(window, totalMass, chirpMass, top, most = MOST_FREQUENCIES, modeRoom = 64) {
  const lowest = Math.min(0.5 * frequencyAt(1.5 * window, chirpMass), 0.25 * top);
  const least = modeRoom * window; // modes of higher m begin earlier, and must not wrap around into the window
  const rate = 2 ** Math.ceil(Math.log2(3 * top));
  let length = 2 ** Math.ceil(Math.log2(least * rate));
  while ((length / rate) * top > Math.min(most, MOST_FREQUENCIES)) length /= 2;
  const step = rate / length;
  const first = Math.max(1, Math.ceil((FADE * lowest) / step)), last = Math.floor(top / step);
  return {
    grid: { f_min: first * step, f_max: last * step, delta_f: step },
    first, last, rate, length, window, lowest, top, after: AFTER * totalMass,
  };
}

/** Times (s) and both polarisations, from complex h_plus and h_cross whose parts take turns. */
export function strainOf(plan, plus, cross) {
  const { first, last, length, rate, lowest, top } = plan;
  const re = new Float64Array(length), im = new Float64Array(length);
  const step = rate / length, count = Math.min(last - first + 1, plus.length / 2);
  for (let i = 0; i < count; i++) {
    const f = (first + i) * step;
    const weight = step * smoothly((f - FADE * lowest) / ((1 - FADE) * lowest)) * smoothly((top - f) / (TOP * top));
    const a = weight * plus[2 * i], b = weight * plus[2 * i + 1], c = weight * cross[2 * i], d = weight * cross[2 * i + 1];
    const k = first + i; // both are real in time: h_plus is the real part of the transform, h_cross the imaginary one
    re[k] = a - d; im[k] = b + c;
    re[length - k] = a + d; im[length - k] = c - b;
  }
  inverseTransform(re, im);
  const before = Math.round(plan.window * rate), after = Math.round(plan.after * rate);
  const times = [], hPlus = [], hCross = [];
  for (let j = -before; j <= after; j++) {
    const at = (j + length) % length;
    times.push(j / rate); hPlus.push(re[at]); hCross.push(im[at]);
  }
  return { times, plus: hPlus, cross: hCross, rate };
}

function smoothly(position) {
  const x = Math.min(1, Math.max(0, position));
  return x ** 4 * (35 + x * (-84 + x * (70 - 20 * x)));
}
