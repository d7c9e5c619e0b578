// The question for a token, which explains itself, and what is said when a server cannot be asked.

import { byId, make } from "./dom.js";
import { token } from "./session.js";

/** Show why a page has nothing to show: the form for a token (401), or the error in words. `again` starts over. */
export function explain(place, error, again) {
  place.hidden = false;
  if (error.status === 401) { place.replaceChildren(form(error, again)); byId("token").focus(); return; }
  place.replaceChildren(
    make("p", { role: "alert", class: "alert", text: error.message }),
    make("p", {}, make("button", { type: "button", class: "quiet", text: "Try again", onclick: () => again() })),
  );
}

function form(error, again) {
  const field = make("input", {
    type: "password", id: "token", autocomplete: "off", spellcheck: "false", "aria-describedby": "token-why",
  });
  const send = (event) => {
    event.preventDefault();
    token.value = field.value.trim();
    again();
  };
  return make("form", { class: "card login", onsubmit: send },
    make("h2", { text: "This server asks for a token" }),
    make("p", { id: "token-why", text: "It knows its users by a text that its operators hand out (they make one with " +
      "“bnserve tokens new”). Ask them for yours. It is sent to this server alone, and kept in this tab until you close it." }),
    token.value ? make("p", { role: "alert", class: "alert", text: `With the token of this tab: ${error.message}` }) : null,
    make("label", { for: "token", text: "Token" }),
    make("div", { class: "row" }, field, make("button", { type: "submit", text: "Continue" })),
  );
}
