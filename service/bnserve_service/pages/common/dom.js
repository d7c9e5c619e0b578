// Elements of a page, made and found in one line each.

export const byId = (id) => document.getElementById(id);

/** An element with attributes (`class`, `text`, `on...`, anything else as it is) and children. */
export function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (value === undefined || value === null || value === false) continue;
    if (name === "text") element.textContent = value;
    else if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
    else element.setAttribute(name, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}

/** Terms and their descriptions, for a `<dl>`. */
export function terms(rows) {
  return rows.flatMap(([term, value]) => [
    make("dt", { text: term }),
    make("dd", {}, value instanceof Node ? value : String(value)),
  ]);
}

/** What is between backticks as code, the rest as text. */
export function marked(text, tag = "p") {
  return make(tag, {}, ...text.split("`").map((part, i) => (i % 2 ? make("code", { text: part }) : part)));
}
