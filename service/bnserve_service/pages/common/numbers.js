// Numbers as people read them.

const SUPERSCRIPTS = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

export const superscript = (power) => [...String(power)].map((digit) => SUPERSCRIPTS[digit]).join("");

/** 1.23 × 10⁻²³, or 0.0123, to so many digits. */
export function number(value, digits = 4) {
  return Number.isFinite(value) ? plain(value, digits).replace("-", "−") : "–";
}

function plain(value, digits) {
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size >= 1e-3 && size < 1e6) return String(+value.toPrecision(digits));
  const [mantissa, power] = value.toExponential(digits - 1).split("e");
  return `${+mantissa} × 10${superscript(+power)}`;
}

/** A time in the unit that a reader would choose. */
export function seconds(value) {
  const size = Math.abs(value);
  for (const [unit, length, from] of [["h", 3600, 7200], ["min", 60, 300], ["s", 1, 1], ["ms", 1e-3, 1e-3]])
    if (size >= from) return `${+(value / length).toPrecision(3)} ${unit}`;
  return `${+(value * 1e6).toPrecision(2)} µs`;
}

/** 12,345,678 bytes as 12.3 MB. */
export function bytes(value) {
  for (const [unit, size] of [["GB", 1e9], ["MB", 1e6], ["kB", 1e3]])
    if (value >= size) return `${(value / size).toPrecision(3)} ${unit}`;
  return `${value} B`;
}
