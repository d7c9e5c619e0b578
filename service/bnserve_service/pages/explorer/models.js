// The models that are served: which there are, and what one says of itself.

import { make } from "../common/dom.js";
import { ask } from "../common/session.js";

const described = new Map();

/** Ask for all of them. A model is called `name@version`. */
export async function loadModels() {
  const { models } = (await ask("v1/models")).content;
  described.clear();
  for (const model of models) described.set(keyOf(model), model);
  return models;
}

export const keyOf = (model) => `${model.name}@${model.version}`;

/** The description of `name@version`, asked for when it is not known. */
export async function describe(key) {
  const [name, version] = key.split("@");
  if (described.has(key)) return described.get(key);
  const path = `v1/models/${encodeURIComponent(name)}/versions/${encodeURIComponent(version)}`;
  const model = (await ask(path)).content;
  described.set(key, model);
  return model;
}

/** The `name@version` that a text means: a label counts, and what is not served is the default model. */
export function resolve(models, key) {
  const [name, version = "stable"] = key.split("@");
  const found = models.find((model) => model.name === name);
  if (!found) return keyOf(models.find((model) => model.name === "default") || models[0]);
  const known = found.versions.includes(version) ? version : found.labels[version];
  return `${name}@${known || found.version}`;
}

/** The choices of a select: every version of every model, those with a label first. */
export function options(models, chosen) {
  return models.map((model) => make("optgroup", { label: model.name },
    ...[...model.versions].reverse().map((version) => {
      const labels = Object.entries(model.labels).filter(([, to]) => to === version).map(([label]) => label);
      const key = `${model.name}@${version}`;
      return make("option", {
        value: key, selected: key === chosen, text: `${model.name} ${version}${labels.length ? ` (${labels.join(", ")})` : ""}`,
      });
    })));
}

export const modeKey = ([l, m]) => `${l}${m}`;

/** Hz: where the band of a model begins and ends for a total mass. */
export function bandOf(model, totalMass) {
  return model.training_band.map((f) => (f * model.reference_mass) / totalMass);
}
