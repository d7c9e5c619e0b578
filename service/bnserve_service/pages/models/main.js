// The models that are served: ranges, accuracy, provenance, labels and digests; one at a time, named behind the #.

import { byId, make, terms } from "../common/dom.js";
import { explain } from "../common/login.js";
import { number } from "../common/numbers.js";
import { describe, loadModels } from "../explorer/models.js";
import { accuracyCards } from "./accuracy.js";

let models = [];

const labelsOf = (model, version) => Object.entries(model.labels).filter(([, to]) => to === version).map(([label]) => label);

function list(chosen) {
  byId("list").replaceChildren(...models.flatMap((model) => [
    make("b", { text: model.name }),
    ...[...model.versions].reverse().map((version) => {
      const key = `${model.name}@${version}`, labels = labelsOf(model, version).join(", ");
      return make("a", { href: `#${key}`, "aria-current": key === chosen ? "page" : null }, `${model.name} ${version} `,
        make("small", { text: labels }));
    }),
  ]));
}

/** A range of a parameter. */
function range({ name, unit, minimum, maximum }) {
  const ends = minimum === null && maximum === null ? "any" : maximum === null ? `from ${number(minimum)}`
    : `${number(minimum ?? -Infinity)} to ${number(maximum)}`;
  return make("tr", {}, make("td", {}, make("code", { text: name })), 
    make("td", { class: "n", text: unit === "1" || ends === "any" ? ends : `${ends} ${unit.replace("Msun", "M☉")}` }));
}

function facts(model) {
  const [low, high] = model.frequency_band, masses = model.frequency_band_masses;
  return terms([
    ["digest", make("code", { text: model.digest })],
    ["labels", labelsOf(model, model.version).join(", ") || "none"],
    ["modes", model.modes.map((mode) => `(${mode.join(", ")})`).join(" ")],
    ["band", `${number(low)} to ${number(high)} Hz${masses ? ` at ${masses.map((mass) => number(mass)).join(" to ")} M☉` : ""}`],
    ["band in M f", model.mf_band.map((mf) => number(mf, 3)).join(" to ")],
    ["please cite", model.citation || "–"],
  ]);
}

function provenance({ provenance: known }) {
  const generator = known.generator || {};
  const rows = [
    ["generator", [generator.name, generator.version].filter(Boolean).join(" ") || "–"],
    ["waveforms", known.waveforms ? `${known.waveforms.toLocaleString("en")}, ${known.failed_waveforms ?? 0} of which failed` : "–"],
    ["data set", known.dataset_digest ? make("code", { text: known.dataset_digest }) : "–"],
    ["trained with", `bnserve ${known.bnserve ?? "–"}, Python ${known.python ?? "–"}`],
    ["commit", known.commit ? make("code", { text: known.commit }) : "–"],
    ["packages", Object.entries(known.packages || {}).map(([name, version]) => `${name} ${version}`).join(", ") || "–"],
    ["took", known.seconds ? `${known.seconds} s` : "–"],
  ];
  return make("section", { class: "card" }, make("h2", { text: "Provenance" }), make("dl", {}, ...terms(rows)),
    make("details", {}, make("summary", { text: "The whole configuration" }),
      make("pre", { tabindex: "0", text: JSON.stringify(known.configuration ?? known, null, 2) })));
}

function show(model) {
  byId("model").replaceChildren(
    make("div", { class: "titled" }, make("h1", { text: `${model.name} ${model.version}` }),
      ...labelsOf(model, model.version).map((label) => make("span", { class: "tag", text: label })),
      make("a", { class: "button", href: `.#model=${model.name}@${model.version}`, text: "Open in the explorer" })),
    make("div", { class: "pair" },
      make("section", { class: "card" }, make("h2", { text: "What it is" }), make("dl", {}, ...facts(model))),
      make("section", { class: "card" }, make("h2", { text: "Ranges" }), make("table", {}, ...model.parameters.map(range)))),
  );
  byId("model").append(...accuracyCards(model), provenance(model));
}

async function choose() {
  const wanted = decodeURIComponent(location.hash.slice(1));
  const known = models.flatMap((model) => model.versions.map((version) => `${model.name}@${version}`));
  const first = models.find((model) => model.name === "default") || models[0];
  const key = known.includes(wanted) ? wanted : `${first.name}@${first.version}`;
  list(key);
  show(await describe(key));
  document.documentElement.dataset.drawn = key;
}

async function start() {
  try {
    models = await loadModels();
    if (!models.length) throw new Error("No model is served yet. Try again in a moment.");
    byId("login").hidden = true;
    byId("content").hidden = false;
    await choose();
  } catch (error) { byId("content").hidden = true; explain(byId("login"), error, start); }
}

window.addEventListener("hashchange", () => choose().catch((error) => explain(byId("login"), error, start)));
start();
