// A binary that precesses by the angles of bilby: the inverse of what LAL makes of them (SimInspiralTransformPrecessingWvf2PE),
// as bnserve_client._lal_precession goes the other way.

import { derived } from "../explorer/binary.js";

const SOLAR_MASS_SECONDS = 4.925491025543576e-6;
const { atan2, hypot, sin, cos, cbrt, PI } = Math;

const turned = ([x, y, z], angle) => [x * cos(angle) - y * sin(angle), x * sin(angle) + y * cos(angle), z];
const polar = ([x, y, z]) => atan2(hypot(x, y), z);
const azimuth = ([x, y]) => atan2(y, x);
const positive = (angle) => ((angle % (2 * PI)) + 2 * PI) % (2 * PI);

/** A vector seen where an axis is z: turned around z until the axis is above x, and around y. */
function upright(vector, axis) {
  const [x, y, z] = turned(vector, -azimuth(axis)), c = cos(polar(axis)), s = sin(polar(axis));
  return [c * x - s * z, y, s * x + c * z];
}

/** a_1, tilt_1, a_2, tilt_2, phi_12, phi_jl and theta_jn of a binary with components, whose z is along L; radians. */
export function anglesOf(binary) {
  const { m1, m2 } = derived(binary), M = m1 + m2, phase = binary.reference_phase / 2;
  const first = [binary.chi_1x, binary.chi_1y, binary.chi_1], second = [binary.chi_2x, binary.chi_2y, binary.chi_2];
  const v = cbrt(PI * binary.reference_frequency * M * SOLAR_MASS_SECONDS);
  const orbital = ((m1 * m2) / v) * (1 + (1.5 + (m1 * m2) / M ** 2 / 6) * v ** 2); // first post-Newtonian order
  const total = first.map((part, i) => m1 ** 2 * part + m2 ** 2 * second[i] + (i === 2 ? orbital : 0));
  const seenAt = PI / 2 - phase, across = sin(binary.inclination);
  const sight = upright([across * cos(seenAt), across * sin(seenAt), cos(binary.inclination)], total);
  return {
    a_1: hypot(...first), tilt_1: polar(first), a_2: hypot(...second), tilt_2: polar(second),
    phi_12: positive(azimuth(second) - azimuth(first)),
    phi_jl: positive(PI / 2 + azimuth(upright([0, 0, 1], total)) - azimuth(sight)), theta_jn: polar(sight),
  };
}
