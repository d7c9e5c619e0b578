// Prometheus' text format, read into numbers.

const LINE = /^([a-zA-Z_:][\w:]*)(?:\{(.*)\})? (\S+)/;
const LABEL = /([a-zA-Z_]\w*)="((?:[^"\\]|\\.)*)"/g;

/** All samples of a text, by name: `[{labels, value}]`. */
export function read(text) {
  const found = {};
  for (const line of text.split("\n")) {
    const match = line.startsWith("#") ? null : line.match(LINE);
    if (!match) continue;
    const labels = {};
    for (const [, name, value] of (match[2] || "").matchAll(LABEL)) labels[name] = value.replace(/\\(.)/g, (_, sign) => (sign === "n" ? "\n" : sign));
    (found[match[1]] ||= []).push({ labels, value: match[3] === "+Inf" ? Infinity : +match[3] });
  }
  return found;
}

/** The sum of a metric's samples of which the labels fit. */
export function sum(samples, name, fits = () => true) {
  return (samples[name] || []).reduce((total, { labels, value }) => (fits(labels) ? total + value : total), 0);
}

/** A metric by one of its labels: `Map` of text to number. */
export function by(samples, name, label) {
  const found = new Map();
  for (const { labels, value } of samples[name] || []) found.set(labels[label], (found.get(labels[label]) || 0) + value);
  return found;
}

/** Cumulative counts of a histogram by their upper ends, `Map` in rising order. */
export function buckets(samples, name, fits = () => true) {
  const found = new Map();
  for (const { labels, value } of samples[`${name}_bucket`] || [])
    if (fits(labels)) { const end = labels.le === "+Inf" ? Infinity : +labels.le; found.set(end, (found.get(end) || 0) + value); }
  return new Map([...found].sort(([a], [b]) => a - b));
}

/** The value below which a part of what was counted between two moments is; NaN where nothing was. */
export function quantile(part, now, before = new Map()) {
  const counts = [...now].map(([end, count]) => [end, count - (before.get(end) || 0)]);
  const all = counts.length ? counts[counts.length - 1][1] : 0;
  if (!(all > 0)) return NaN;
  let low = 0, below = 0;
  for (const [end, count] of counts) {
    if (count >= part * all) return end === Infinity ? low : low + (end - low) * ((part * all - below) / (count - below || 1));
    low = end; below = count;
  }
  return low;
}
