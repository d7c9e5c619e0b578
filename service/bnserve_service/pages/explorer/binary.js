// A binary: its parameters as controls have them, its derived numbers, and those to begin with.

/** Every parameter: symbol, words, unit, the slider's ends where the model states none, and whether it is logarithmic. */
export const PARAMETERS = {
  total_mass: { symbol: "M", words: "total mass, detector", unit: "M☉", ends: [0.2, 100], log: true },
  mass_ratio: { symbol: "q", words: "mass ratio", unit: "", ends: [1, 3] },
  lambda_1: { symbol: "Λ₁", words: "tides, heavier star", unit: "", ends: [0, 5000] },
  lambda_2: { symbol: "Λ₂", words: "tides, lighter star", unit: "", ends: [0, 5000] },
  chi_1: { symbol: "χ₁", words: "spin, heavier star", unit: "", ends: [-0.5, 0.5] },
  chi_2: { symbol: "χ₂", words: "spin, lighter star", unit: "", ends: [-0.5, 0.5] },
  distance_mpc: { symbol: "D", words: "luminosity distance", unit: "Mpc", ends: [1, 20000], log: true },
  inclination: { symbol: "ι", words: "inclination", unit: "rad", ends: [0, Math.PI] },
  reference_phase: { symbol: "φ", words: "phase", unit: "rad", ends: [0, 4 * Math.PI] },
  time_shift: { symbol: "Δt", words: "earlier by", unit: "s", ends: [-0.01, 0.01] },
  chi_1x: { symbol: "χ₁x", words: "heavier star, along x", unit: "", ends: [-0.5, 0.5] },
  chi_1y: { symbol: "χ₁y", words: "heavier star, along y", unit: "", ends: [-0.5, 0.5] },
  chi_2x: { symbol: "χ₂x", words: "lighter star, along x", unit: "", ends: [-0.5, 0.5] },
  chi_2y: { symbol: "χ₂y", words: "lighter star, along y", unit: "", ends: [-0.5, 0.5] },
  reference_frequency: { symbol: "fᵣ", words: "reference frequency", unit: "Hz", ends: [5, 100], log: true },
};

/** What stands together. */
export const GROUPS = [
  { title: "The stars", names: ["total_mass", "mass_ratio", "lambda_1", "lambda_2", "chi_1", "chi_2"] },
  { title: "Where it is, and how it is seen", names: ["distance_mpc", "inclination", "reference_phase", "time_shift"] },
  {
    title: "Precession", names: ["chi_1x", "chi_1y", "chi_2x", "chi_2y", "reference_frequency"], folded: true,
    words: "Spins in the plane of the orbit, when the (2, 2) mode passes the reference frequency, where the phase is given, too.",
  },
];

export const IN_PLANE = ["chi_1x", "chi_1y", "chi_2x", "chi_2y"];

const USUAL = {
  total_mass: 2.76, mass_ratio: 1.2, lambda_1: 400, lambda_2: 600, chi_1: 0.01, chi_2: 0, distance_mpc: 40, inclination: 2.5,
  reference_phase: 0, time_shift: 0, chi_1x: 0, chi_1y: 0, chi_2x: 0, chi_2y: 0, reference_frequency: 20,
};

export const PRESETS = {
  GW170817: { title: "GW170817-like", binary: USUAL },
  GW190425: {
    title: "GW190425-like",
    binary: { ...USUAL, total_mass: 3.5, mass_ratio: 1.3, lambda_1: 80, lambda_2: 250, distance_mpc: 159, inclination: 0.7 },
  },
  ET: {
    title: "ET at z = 1", noise: "et",
    binary: { ...USUAL, total_mass: 5.6, mass_ratio: 1.1, lambda_1: 350, lambda_2: 500, distance_mpc: 6800, inclination: 0.5 },
  },
  modes: {
    title: "Edge-on, unequal",
    binary: { ...USUAL, total_mass: 3, mass_ratio: 2.2, lambda_1: 60, lambda_2: 900, inclination: 1.35 },
  },
  precessing: {
    title: "Precessing", binary: { ...USUAL, mass_ratio: 1.6, chi_1: 0.1, chi_1x: 0.4, chi_2y: 0.2, inclination: 1.2 },
  },
};

export const usual = () => ({ ...USUAL });

export const precesses = (binary) => IN_PLANE.some((name) => binary[name] !== 0);

/** What follows from the parameters. */
export function derived({ total_mass: M, mass_ratio: q, lambda_1: a, lambda_2: b }) {
  const m1 = (M * q) / (1 + q), m2 = M - m1;
  return {
    m1, m2, chirpMass: (m1 * m2) ** 0.6 / M ** 0.2,
    lambdaTilde: ((16 / 13) * ((m1 + 12 * m2) * m1 ** 4 * a + (m2 + 12 * m1) * m2 ** 4 * b)) / M ** 5,
  };
}
