// The explorer: what is shown is one state, which controls change, the address keeps, and the pictures are drawn from.

import { byId, make } from "../common/dom.js";
import { explain } from "../common/login.js";
import { noiseCurves } from "../physics/noise.js";
import { fromAddress, toAddress } from "./address.js";
import { PARAMETERS, PRESETS } from "./binary.js";
import { makeCode, tellCode } from "./code.js";
import { compare } from "./comparison.js";
import { fillControls, fillModes, makeControls, markErrors } from "./controls.js";
import { tellFacts } from "./facts.js";
import { listen } from "./listening.js";
import { describe, loadModels, options, resolve } from "./models.js";
import { tellPinned } from "./pinned.js";
import { drawAll, makePictures } from "./pictures.js";
import { evaluate, frequenciesOf, waveformOf } from "./questions.js";
import { saveCsv, savePng } from "./saving.js";

let state = null, models = [], curves = [], shownModel = null, underWay = false, again = false, later = 0;

/** Draw what the state says; while an answer is under way, only the last change counts. */
async function update() {
  const page = document.documentElement.dataset; // for whoever waits for the pictures: drawn is what was asked for
  page.wanted = toAddress(state);
  clearTimeout(later);
  later = setTimeout(() => history.replaceState(null, "", `#${toAddress(state)}`), 250);
  if (underWay) { again = true; return; }
  underWay = true;
  do {
    again = false;
    const asked = structuredClone(state);
    try {
      const model = await describe(asked.model);
      shownModel = model;
      waveformOf(asked, model); // what cannot be asked for is said at once
      tellCode(asked, model);
      const found = await evaluate(asked, model, { window: asked.window, frequencies: frequenciesOf(model, asked.binary) });
      const { other, difference } = await compare(asked, found, curves);
      drawAll(asked, found, other, difference, curves);
      tellFacts(found, difference);
      clear();
    } catch (error) { fail(error); }
    page.drawn = toAddress(asked);
  } while (again);
  underWay = false;
}

function clear() {
  markErrors([]);
  byId("pictures").classList.remove("stale");
  byId("why").textContent = "";
}

function fail(error) {
  if (error.status === 401) { ended(error); return; }
  if (error.retryAfter) setTimeout(update, 1000 * error.retryAfter); // too many at once: the last of them comes later
  const errors = error.errors || [];
  markErrors(errors);
  byId("pictures").classList.add("stale");
  byId("why").textContent = inWords(error, errors.filter((one) => one.parameter in PARAMETERS));
  byId("status").textContent = "Not drawn: see the message.";
}

/** The server's sentence, or for a binary that a model does not know one without rows and options of Python. */
function inWords(error, errors) {
  if (error.code !== "out-of-domain" || !errors.length) return error.message;
  const each = errors.map(({ parameter, value, reason }) => `${PARAMETERS[parameter].symbol} = ${value} is ${reason}`);
  return `This model was not trained on such a binary: ${each.join("; ")}. Change it, or choose another model.`;
}

function ended(error) {
  byId("explorer").hidden = true;
  explain(byId("login"), error, start);
}

async function fill() {
  const model = await describe(state.model);
  byId("model").replaceChildren(...options(models, state.model));
  fillControls(state.binary, model);
  fillModes(model, state.modes, (modes) => { state.modes = modes; update(); });
  for (const name of ["show", "window", "against", "quantity", "noise"])
    for (const input of document.querySelectorAll(`[name="${name}"]`))
      if (input.type === "radio") input.checked = input.value === state[name]; else input.value = state[name];
  byId("about").textContent = `${model.modes.length} mode${model.modes.length > 1 ? "s" : ""}, ` +
    `${model.digest.slice(0, 19)}…`;
  tellPinned(state, models, refresh);
}

async function refresh() {
  await fill();
  await update();
}

function choose(change) {
  Object.assign(state, change);
  return refresh().catch(fail);
}

async function changeModel(key) {
  const known = (await describe(key)).modes.map((mode) => mode.join(""));
  const modes = state.modes?.filter((mode) => known.includes(mode));
  return choose({ model: key, modes: modes?.length ? modes : null });
}

function wire() {
  makeControls(byId("controls"), (name, value) => { state.binary[name] = value; update(); });
  byId("form").addEventListener("submit", (event) => event.preventDefault());
  byId("model").addEventListener("change", (event) => changeModel(event.target.value).catch(fail));
  byId("presets").replaceChildren(...Object.values(PRESETS).map(({ title, binary, noise }) => make("button", {
    type: "button", class: "quiet", text: title, onclick: () => choose({ binary: { ...binary }, noise: noise || state.noise }),
  })));
  for (const name of ["show", "window", "against", "quantity", "noise"])
    for (const input of document.querySelectorAll(`[name="${name}"]`))
      input.addEventListener("change", () => choose({ [name]: input.value }));
  byId("keep").addEventListener("click", () => {
    const { model, binary, modes } = structuredClone(state);
    choose({ pinned: { model, binary, modes }, against: "pinned" });
  });
  for (const button of document.querySelectorAll("[data-csv]")) button.addEventListener("click", () => saveCsv(button.dataset.csv));
  for (const button of document.querySelectorAll("[data-png]")) button.addEventListener("click", () => savePng(button.dataset.png));
  byId("listen").addEventListener("click", hear);
  for (const tab of document.querySelectorAll("#picture-tabs [role=tab]")) tab.addEventListener("click", () => showPicture(tab));
  window.addEventListener("hashchange", () => {
    if (location.hash.slice(1) === toAddress(state)) return;
    state = restored(state.model);
    refresh().catch(fail);
  });
  makeCode(() => ({ state, model: shownModel }), fail);
}

async function hear() {
  const button = byId("listen");
  button.textContent = "Stop";
  try { await listen(structuredClone(state), await describe(state.model)); } catch (error) { fail(error); }
  button.textContent = "Listen";
}

/** On small screens one picture is seen, the one whose tab was chosen. */
function showPicture(chosen) {
  for (const tab of document.querySelectorAll("#picture-tabs [role=tab]")) {
    const is = tab === chosen;
    tab.setAttribute("aria-selected", String(is));
    byId(tab.getAttribute("aria-controls")).classList.toggle("current", is);
  }
}

/** The state of the address, with models that are served. */
function restored(model) {
  const found = fromAddress(location.hash, model);
  for (const one of [found, found.pinned]) if (one) one.model = resolve(models, one.model);
  return found;
}

async function start() {
  try {
    models = await loadModels();
    if (!models.length) throw new Error("No model is served yet. Try again in a moment.");
    curves = await noiseCurves();
    byId("login").hidden = true;
    byId("explorer").hidden = false;
    state ||= restored("default");
    await refresh();
  } catch (error) { ended(error); }
}

makePictures();
wire();
start();
