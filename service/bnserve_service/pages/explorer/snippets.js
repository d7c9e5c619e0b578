// This waveform as code: Python, bilby, the shell and JavaScript, each with exactly its numbers.

import { addressOf, token } from "../common/session.js";
import { anglesOf } from "../physics/angles.js";
import { derived } from "./binary.js";
import { pathOf, waveformOf } from "./questions.js";

/** Hz: the frequencies that the code asks for. */
export const GRID = { f_min: 20, f_max: 2048, delta_f: 0.25 };

/** The question that all of the code asks. */
export const questionOf = (state, model) => ({ ...waveformOf(state, model), grid: GRID });

export const LANGUAGES = { python: "Python", bilby: "bilby", curl: "curl", javascript: "JavaScript" };

/** The code of one language. */
export function snippet(language, state, model) {
  const question = questionOf(state, model);
  return { python, bilby, curl, javascript }[language](question, model, state);
}

const server = () => addressOf().replace(/\/$/, "");
const float = (value) => (Number.isInteger(value) ? `${value}.0` : String(value));
const modesOf = (modes, open, close) => modes.map((mode) => open + mode.join(", ") + close).join(", ");
const needsToken = (comment) => (token.value ? `${comment} the token is that of the environment variable BNSERVE_TOKEN\n` : "");

function python({ parameters, alignment, reference_frequency, modes }, model) {
  const given = Object.entries(parameters).map(([name, value]) => `    ${name}=${float(value)},`).join("\n");
  const chosen = modes ? `, modes=[${modesOf(modes, "(", ")")}]` : "";
  return `${needsToken("#")}from bnserve_client import Model
from bnserve_protocol import EvaluationOptions, ParametersWithExtrinsic, UniformGrid

model = Model.connect(
    "${server()}",
    "${model.name}",
    digest="${model.digest}",  # ${model.version}
)
binary = ParametersWithExtrinsic(
${given}
)
grid = UniformGrid(f_min=${float(GRID.f_min)}, f_max=${float(GRID.f_max)}, delta_f=${GRID.delta_f})  # Hz
options = EvaluationOptions(alignment="${alignment}", reference_frequency=${float(reference_frequency)}${chosen})
h = model.predict(grid, binary, options=options)
print(h.plus[0], h.cross[0])  # 1/Hz, at ${GRID.f_min} Hz
`;
}

function bilby({ parameters, reference_frequency, modes }, model, { binary }) {
  const { m1, m2 } = derived(binary);
  const chosen = modes ? `\n        "mode_array": [${modesOf(modes, "[", "]")}],` : "";
  const shift = parameters.time_shift ? `\n# bilby has the time apart: geocent_time is ${-parameters.time_shift} s from the merger's.` : "";
  const angles = Object.entries({ ...anglesOf(binary), phase: parameters.reference_phase / 2 });
  return `${needsToken("#")}import bilby
import bnserve_client.bilby

generator = bilby.gw.WaveformGenerator(
    duration=${1 / GRID.delta_f},
    sampling_frequency=${2 * GRID.f_max},
    frequency_domain_source_model=bnserve_client.bilby.binary_neutron_star,
    waveform_arguments={
        "bnserve_url": "${server()}",
        "bnserve_model": "${model.name}",
        "bnserve_digest": "${model.digest}",
        "reference_frequency": ${float(reference_frequency)},
        "minimum_frequency": ${float(GRID.f_min)},${chosen}
    },
)
binary = dict(
    mass_1=${m1}, mass_2=${m2},
    lambda_1=${float(parameters.lambda_1)}, lambda_2=${float(parameters.lambda_2)},
${angles.map(([name, value]) => `    ${name}=${float(value)},`).join("\n")}
    luminosity_distance=${float(parameters.distance_mpc)},
)${shift}
h = generator.frequency_domain_strain(binary)
inside = generator.frequency_array >= ${float(GRID.f_min)}
print(h["plus"][inside][0], h["cross"][inside][0])  # 1/Hz, at ${GRID.f_min} Hz
`;
}

function curl(question, model) {
  const authorization = token.value ? `\n  -H "Authorization: Bearer $BNSERVE_TOKEN" \\` : "";
  return `curl --fail-with-body -s '${server()}/${pathOf(model)}' \\${authorization}
  -H 'Content-Type: application/json' \\
  -d '${JSON.stringify(question)}'
`;
}

function javascript(question, model) {
  const authorization = token.value ? `\n    "authorization": \`Bearer \${process.env.BNSERVE_TOKEN}\`,` : "";
  return `const answer = await fetch("${server()}/${pathOf(model)}", {
  method: "POST",
  headers: {
    "content-type": "application/json",${authorization}
  },
  body: JSON.stringify(${JSON.stringify(question, null, 2).replaceAll("\n", "\n  ")}),
});
if (!answer.ok) throw new Error((await answer.json()).detail);
const { h_plus, h_cross } = await answer.json();
console.log(h_plus.re[0][0], h_plus.im[0][0], h_cross.re[0][0], h_cross.im[0][0]); // 1/Hz, at ${GRID.f_min} Hz
`;
}
