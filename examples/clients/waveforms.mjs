// Two binaries from a running server, in JavaScript:
//     npm install @msgpack/msgpack
//     node waveforms.mjs http://127.0.0.1:8000
import { createHash } from "node:crypto";
import { decode, encode } from "@msgpack/msgpack";

const server = process.argv[2] ?? "http://127.0.0.1:8000";
const question = {
  parameters: {
    mass_ratio: 1.2, lambda_1: 400, lambda_2: [600, 700], chi_1: 0.01, chi_2: 0,
    distance_mpc: 40, inclination: 2.5, total_mass: 2.76, // solar masses, in the detector frame
  },
  grid: { f_min: 20, f_max: 2048, delta_f: 0.25 }, // Hz
};

const response = await fetch(`${server}/v1/models/default/waveforms`, {
  method: "POST",
  headers: { "content-type": "application/msgpack", accept: "application/msgpack, application/problem+json" },
  body: encode(question),
});
const body = new Uint8Array(await response.arrayBuffer());
if (!response.ok) throw new Error(JSON.parse(new TextDecoder().decode(body)).detail);
const digest = createHash("sha256").update(body).digest("base64");
if (response.headers.get("content-digest") !== `sha-256=:${digest}:`) throw new Error("damaged on its way: ask again");
const answer = decode(body);

// An array is {type: "<c16", shape: [N, M], data: bytes}: little endian, row by row, real and imaginary parts in turn.
const { shape, data } = answer.h_plus;
const view = new DataView(data.buffer, data.byteOffset, data.byteLength);
const [rows, columns] = shape;
for (let row = 0; row < rows; row++) {
  const at = 16 * (row * columns + columns - 1000); // at the 1000th frequency from the end
  console.log(row, view.getFloat64(at, true), view.getFloat64(at + 8, true));
}
