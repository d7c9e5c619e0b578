// The waveform that is kept as B: which it is, by another model, and back again.

import { byId, make } from "../common/dom.js";
import { number } from "../common/numbers.js";
import { PARAMETERS, usual } from "./binary.js";
import { options } from "./models.js";

/** Say what B is, with what can be done with it; `changed` is called after each change of the state. */
export function tellPinned(state, models, changed) {
  const place = byId("pinned"), { pinned } = state;
  byId("against-pinned").disabled = !pinned;
  place.hidden = !pinned;
  if (!pinned) { place.replaceChildren(); return; }
  const select = make("select", { "aria-label": "Model of B" }, ...options(models, pinned.model));
  select.addEventListener("change", () => { pinned.model = select.value; pinned.modes = null; changed(); });
  const swap = () => {
    const { model, binary, modes } = state;
    Object.assign(state, pinned);
    state.pinned = { model, binary, modes };
    changed();
  };
  const forget = () => { state.pinned = null; state.against = "baseline"; changed(); };
  place.replaceChildren(
    make("div", { class: "row" }, make("b", { class: "c-b", text: "B" }), select),
    make("p", { class: "soft small", text: differing(state.binary, pinned.binary) }),
    make("div", { class: "row" },
      make("button", { type: "button", class: "quiet", text: "Swap with A", onclick: swap }),
      make("button", { type: "button", class: "quiet", text: "Forget B", onclick: forget })),
  );
}

function differing(a, b) {
  const names = Object.keys(usual()).filter((name) => a[name] !== b[name]);
  if (!names.length) return "The same binary as A.";
  return `Other than A: ${names.map((name) => `${PARAMETERS[name].symbol} = ${number(b[name])} ${PARAMETERS[name].unit}`.trim()).join(", ")}.`;
}
