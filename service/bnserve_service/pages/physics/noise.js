// Detectors' noise, and what a signal is worth in it.

let loaded = null;

/** The curves that come with the server: `{key, name, source, frequencies, asd}`, asd in 1/sqrt(Hz). */
export async function noiseCurves() {
  loaded ||= (await (await fetch("pages/data/noise.json")).json()).curves;
  return loaded;
}

/** The amplitude spectral density at f (Hz), linear between the logarithms; infinite outside. */
export function asdAt(curve, f) {
  const { frequencies: x, asd: y } = curve;
  if (!(f >= x[0] && f <= x[x.length - 1])) return Infinity;
  let low = 0, high = x.length - 1;
  while (high - low > 1) { const middle = (low + high) >> 1; if (x[middle] <= f) low = middle; else high = middle; }
  const part = Math.log(f / x[low]) / Math.log(x[high] / x[low]);
  return Math.exp((1 - part) * Math.log(y[low]) + part * Math.log(y[high]));
}

/** The optimal signal-to-noise ratio of |h| (1/Hz) at frequencies (Hz) in one detector that sees h as it is. */
export function signalToNoise(curve, frequencies, size) {
  let sum = 0, previous = 0;
  for (let i = 0; i < frequencies.length; i++) {
    const here = 4 * (size[i] / asdAt(curve, frequencies[i])) ** 2;
    if (i) sum += 0.5 * (here + previous) * (frequencies[i] - frequencies[i - 1]);
    previous = here;
  }
  return Math.sqrt(sum);
}
