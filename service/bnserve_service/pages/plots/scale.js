// An axis: where values are, and which of them are written beside it.

import { superscript } from "../common/numbers.js";

/** An axis from `low` to `high` on pixels `from` to `to`. */
export function scale({ low, high, log = false }, from, to) {
  const bend = log ? Math.log10 : (value) => value;
  const a = bend(low), b = bend(high);
  return {
    low, high, log,
    at: (value) => from + ((bend(value) - a) / (b - a)) * (to - from),
    inverse: (pixel) => { const value = a + ((pixel - from) / (to - from)) * (b - a); return log ? 10 ** value : value; },
    length: Math.abs(to - from),
  };
}

/** The least range that holds values, with some room; on a logarithmic axis of what is positive. */
export function rangeOf(values, { log = false, room = 0.05, decades = Infinity } = {}) {
  let low = Infinity, high = -Infinity;
  for (const value of values) {
    if (!Number.isFinite(value) || (log && value <= 0)) continue;
    if (value < low) low = value;
    if (value > high) high = value;
  }
  if (low > high) return log ? { low: 1, high: 10, log } : { low: -1, high: 1, log };
  if (!log) {
    const pad = room * (high - low || Math.abs(high) || 1);
    return { low: low - pad, high: high + pad, log };
  }
  const least = Math.max(low, high / 10 ** decades), pad = room * (Math.log10(high / least) || 1);
  return { low: least / 10 ** pad, high: high * 10 ** pad, log };
}

/** Ticks as `{value, text}`, so far apart that their texts have room, and the power of ten that texts leave out. */
export function ticks(axis, spacing) {
  return axis.log ? logarithmic(axis, spacing) : linear(axis, spacing);
}

function linear({ low, high, length }, spacing) {
  const rough = ((high - low) * spacing) / length, power = Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((times) => times * 10 ** power >= rough) * 10 ** power;
  const largest = Math.max(Math.abs(low), Math.abs(high)), size = Math.floor(Math.log10(largest));
  const left = size < -3 || size > 4 ? size : 0;
  const marks = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) {
    const value = k * step;
    marks.push({ value, text: String(+(value / 10 ** left).toPrecision(6)).replace("-", "−") });
  }
  return { marks, power: left };
}

function logarithmic({ low, high, length }, spacing) {
  const perDecade = length / Math.log10(high / low), marks = [];
  const steps = perDecade > 4.5 * spacing ? [1, 2, 5] : [1], every = Math.max(1, Math.ceil(spacing / perDecade));
  for (let power = Math.floor(Math.log10(low)); power <= Math.log10(high) + 1e-9; power++) {
    if (power % every) continue;
    for (const step of steps) {
      const value = step * 10 ** power;
      if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) marks.push({ value, text: textOf(step, power) });
    }
  }
  return { marks, power: 0 };
}

function textOf(step, power) {
  if (power >= -3 && power <= 4) return String(+(step * 10 ** power).toPrecision(2));
  return step === 1 ? `10${superscript(power)}` : `${step}·10${superscript(power)}`;
}
