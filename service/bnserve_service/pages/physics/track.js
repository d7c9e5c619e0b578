// When the signal passes which frequency: the derivative of the phase of the (2, 2) mode.

/** Seconds until the merger and frequencies (Hz), up to the merger: where the frequency does not grow any more, it ends. */
export function trackOf(frequencies, { amplitude, phase }, least) {
  const points = [];
  for (let i = 1; i < frequencies.length - 1; i++) {
    if (!(amplitude[i + 1] > 0)) break;
    // In the logarithm of f, in which the points are evenly spaced, the central difference is of second order.
    const slope = (phase[i + 1] - phase[i - 1]) / Math.log(frequencies[i + 1] / frequencies[i - 1]) / frequencies[i];
    const left = slope / (2 * Math.PI);
    const last = points[points.length - 1];
    if (left < least || (last && left >= last[0])) { if (points.length) break; continue; }
    points.push([left, frequencies[i]]);
  }
  return points;
}
