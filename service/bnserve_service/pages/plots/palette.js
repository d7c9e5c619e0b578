// The colours of the style sheet, as canvases need them: resolved for the theme of the moment.

let known = {};
const probe = document.createElement("span");
window.addEventListener("theme", () => (known = {}));

/** The colour called `--name` in the style sheet. */
export function colour(name) {
  if (!known[name]) {
    if (!probe.isConnected) { probe.hidden = true; document.body.append(probe); }
    probe.style.color = `var(--${name})`;
    known[name] = getComputedStyle(probe).color;
  }
  return known[name];
}

const MODES = { "2,2": "m22", "2,1": "m21", "3,3": "m33", "4,4": "m44", "3,2": "m32", "3,1": "m31", "4,3": "m43" };

/** The name of the colour of a mode; those without one of their own share the last. */
export const modeColour = ([l, m]) => MODES[`${l},${m}`] || "m43";
