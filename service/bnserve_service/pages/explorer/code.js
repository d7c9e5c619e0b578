// The panel with the code: its tabs, copying, and h(f) as a file.

import { byId, make } from "../common/dom.js";
import { ask } from "../common/session.js";
import { LANGUAGES, questionOf, snippet } from "./snippets.js";
import { pathOf } from "./questions.js";
import { save } from "./saving.js";

let language = "python", said = 0;

/** Make the panel; `current()` gives `{state, model}`. */
export function makeCode(current, failed) {
  byId("languages").replaceChildren(...Object.entries(LANGUAGES).map(([key, name]) => make("button", {
    type: "button", role: "tab", id: `tab-${key}`, "aria-controls": "code", "aria-selected": String(key === language),
    tabindex: key === language ? "0" : "-1", text: name, onclick: () => choose(key, current),
  })));
  byId("languages").addEventListener("keydown", (event) => {
    const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key], keys = Object.keys(LANGUAGES);
    if (!step) return;
    choose(keys[(keys.indexOf(language) + step + keys.length) % keys.length], current);
    byId(`tab-${language}`).focus();
  });
  byId("copy").addEventListener("click", () => copy(byId("code").textContent));
  byId("save-waveform").addEventListener("click", () => saveWaveform(current()).catch(failed));
}

function choose(key, current) {
  language = key;
  for (const tab of byId("languages").children) {
    const chosen = tab.id === `tab-${key}`;
    tab.setAttribute("aria-selected", String(chosen));
    tab.tabIndex = chosen ? 0 : -1;
  }
  const { state, model } = current();
  tellCode(state, model);
}

/** Write the code of what is shown. */
export function tellCode(state, model) {
  byId("code").textContent = snippet(language, state, model);
  byId("code").setAttribute("aria-labelledby", `tab-${language}`);
}

async function copy(text) {
  byId("copied").textContent = "";
  let done = true;
  try {
    await navigator.clipboard.writeText(text); // needs https, or a server on this machine
  } catch {
    const range = document.createRange();
    range.selectNodeContents(byId("code"));
    getSelection().removeAllRanges();
    getSelection().addRange(range);
    done = document.execCommand("copy");
  }
  byId("copied").textContent = done ? "Copied." : "It is selected: copy it with your keyboard.";
  clearTimeout(said);
  said = setTimeout(() => (byId("copied").textContent = ""), 3000);
}

async function saveWaveform({ state, model }) {
  const { content } = await ask(pathOf(model), { body: questionOf(state, model), binary: true });
  const { f_min, delta_f } = questionOf(state, model).grid, [plus, cross] = [content.h_plus.data, content.h_cross.data];
  const lines = ["frequency_Hz,h_plus_re,h_plus_im,h_cross_re,h_cross_im"];
  for (let i = 0; i < plus.length / 2; i++)
    lines.push([f_min + delta_f * i, plus[2 * i], plus[2 * i + 1], cross[2 * i], cross[2 * i + 1]].join(","));
  save(`waveform-${model.name}-${model.version}.csv`, `${lines.join("\n")}\n`, "text/csv");
}
