// The post-Newtonian baseline of the (2, 2) mode, which the models add to: bnserve_surrogate.baseline, whose docstrings
// name the sources. The point-mass terms are that module's own numbers (pages/data/baseline.json); a test compares the sum.

const { log, sqrt, exp, cos, cbrt, PI, max, min } = Math;
let loaded = null;

/** The numbers that come with the server. */
export async function baselineTerms() {
  loaded ||= await (await fetch("pages/data/baseline.json")).json();
  return loaded;
}

const series = (nu, numbers) => [].concat(numbers).reduceRight((sum, number) => sum * nu + number, 0);

/** Coefficients [l][k] of (log v)^l v^(k - 5) in the phase Psi, without the factor 3 / (128 nu). */
function phaseCoefficients({ mass_ratio: q, chi_1, chi_2, lambda_1, lambda_2 }, terms) {
  const out = [0, 1, 2].map(() => new Array(16).fill(0)), x1 = q / (1 + q), nu = x1 * (1 - x1);
  const place = { "1PN": 2, "1_5PN": 3, "2PN": 4, "2_5PN": 5, "3PN": 6, "3_5PN": 7, "4PN": 8, "4_5PN": 9, "5PN": 10, "5_5PN": 11 };
  out[0][0] = 1;
  for (const [name, numbers] of Object.entries(terms)) {
    const [, order, rest] = name.match(/^PHASE_(\d(?:_5)?PN)(.*)$/);
    out[{ "": 0, _LOG: 1, _LOG_SQUARED: 2 }[rest]][place[order]] += series(nu, numbers) / (order === "5PN" ? 1 - 3 * nu : 1);
  }
  for (const [x, chi, lambda] of [[x1, chi_1, lambda_1], [1 - x1, chi_2, lambda_2]]) {
    addSpin(out, x, chi, quadrupole(lambda));
    addTides(out[0], x, lambda);
  }
  const product = nu * chi_1 * chi_2;
  out[0][4] -= (395 / 4) * product;
  out[0][6] += product * (32675 / 112 + (5575 / 18) * nu);
  out[0][7] -= PI * (800 * product + 7.5 * (x1 * chi_1 - (1 - x1) * chi_2) ** 2);
  return out;
}

function addSpin(out, x, chi, quadrupole) {
  const nu = x * (1 - x), spin = x * chi, square = spin * spin;
  out[0][3] += spin * (25 + (38 / 3) * x);
  out[1][5] -= 3 * spin * (13915 / 84 - (10 / 3) * nu + x * (12760 / 81 + (170 / 9) * nu));
  out[0][6] += PI * spin * (1490 / 3 + 260 * x);
  const total = -8980424995 / 762048 + nu * (6586595 / 756 - (305 / 36) * nu);
  const difference = 170978035 / 48384 - nu * (2876425 / 672 + (4735 / 144) * nu);
  out[0][7] += spin * (total * x + difference * (2 * x - 1));
  out[0][4] -= square * (50 * quadrupole + 5 / 8);
  out[0][6] += square * (quadrupole * (47035 / 84 + x * (2935 / 6 - 120 * x))
    - (410825 / 672 + x * (1085 / 12 - (1255 / 36) * x)));
  out[0][7] -= 400 * PI * square * quadrupole;
}

function addTides(out, x, lambda) {
  const scale = -24 * x ** 4 * lambda;
  out[10] += scale * (12 - 11 * x);
  out[12] += ((scale * 5) / 672) * (3179 - x * (919 + x * (2286 - 260 * x)));
  out[13] -= PI * scale * (12 - 11 * x);
  const high = 158378220 - x * (20427120 - 4572288 * x);
  out[14] += ((scale * 5) / 27433728) * (387973870 - x * (43246839 + x * (174965616 + x * high)));
  out[15] -= ((PI * scale) / 672) * (27719 - x * (22415 - x * (7598 - 10520 * x)));
}

function quadrupole(lambda) {
  const y = log(max(lambda, 1));
  return lambda > 1 ? exp(0.194 + y * (0.0936 + y * (0.0474 + y * (-4.21e-3 + y * 1.23e-4)))) : 1;
}

/** Coefficients of v^(k - 7/2) in the amplitude, without its factor. */
function amplitudeCoefficients({ mass_ratio: q, chi_1, chi_2 }) {
  const nu = q / (1 + q) ** 2, delta = (q - 1) / (q + 1), s = 0.5 * (chi_1 + chi_2), a = 0.5 * delta * (chi_1 - chi_2);
  const square = 0.25 * (chi_1 - chi_2) ** 2;
  return [
    1, 0, -323 / 224 + (451 / 168) * nu, (27 / 8) * a + (27 / 8 - (11 / 6) * nu) * s,
    -27312085 / 8128512 + nu * (-1975055 / 338688 + (105271 / 24192) * nu) + (-49 / 32 + 6 * nu) * square
      - (49 / 16) * a * s + (-49 / 32 + nu / 8) * s * s,
    (-85 / 64) * PI * (1 - 4 * nu) + (285197 / 16128 - (1579 / 4032) * nu) * a
      + (285197 / 16128 - nu * (15317 / 672 + (2227 / 1008) * nu)) * s,
    -177520268561 / 8583708672 + nu * (545384828789 / 5007163392 - (205 / 48) * PI ** 2)
      + nu ** 2 * (-3248849057 / 178827264 + (34473079 / 6386688) * nu)
      + PI * ((31 / 12) * a + (31 / 12 - (7 / 3) * nu) * s)
      + (-875047 / 64512 + nu * (129367 / 2304 + (491 / 84) * nu)) * square
      + (-875047 / 32256 + (107291 / 2688) * nu) * a * s + (-875047 / 64512 + nu * (8517 / 224 - (51329 / 4032) * nu)) * s * s,
    PI * (3814429 / 1161216 - nu * (393581 / 24192 - (193621 / 24192) * nu)),
  ];
}

/** Amplitude (1/Hz, face-on) and phase (rad, increasing) of a binary at frequencies (Hz). */
export function baseline(binary, frequencies, data) {
  const seconds = binary.total_mass * data.solar_mass_seconds, q = binary.mass_ratio, nu = q / (1 + q) ** 2;
  const [from, to, frozen] = data.freezing;
  const phases = phaseCoefficients(binary, data.terms), sizes = amplitudeCoefficients(binary);
  const scale = (nu * seconds ** 2) / (binary.distance_mpc * data.megaparsec_seconds);
  const amplitude = [], phase = [];
  for (const f of frequencies) {
    const mf = f * seconds, v = cbrt(PI * mf), l = log(v);
    const psi = phases[0].map((_, k) => (phases[0][k] + l * (phases[1][k] + l * phases[2][k])) * v ** (k - 5));
    phase.push((-3 / (128 * nu)) * psi.reduce((sum, term) => sum + term, 0));
    const size = sqrt((5 * PI) / 24 / nu) * sizes.reduce((sum, number, k) => sum + number * v ** (k - 3.5), 0);
    const share = 0.5 * (1 - cos(PI * min(1, max(0, (mf - from) / (to - from)))));
    amplitude.push(scale * ((1 - share) * size + share * frozen));
  }
  return { amplitude, phase };
}
