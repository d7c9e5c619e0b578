// The interface, drawn from openapi.json: every path with an anchor, its words, a curl, and a form to try it.

import { byId, make, marked } from "../common/dom.js";
import { addressOf } from "../common/session.js";
import { curlOf, trial } from "./trial.js";

const FIRST = "waveforms";

const idOf = (method, path) => `${method}-${path.replace(/[^a-z0-9]+/gi, "-").replace(/^-|-$/g, "")}`;
const mediaOf = (content) => Object.keys(content || {}).join(", ");

function table(head, rows) {
  return make("div", { class: "scroll" }, make("table", {}, make("tr", {}, ...head.map((text) => make("th", { text }))),
    ...rows.map((cells) => make("tr", {}, ...cells.map((cell) => make("td", {}, cell instanceof Node ? cell : String(cell ?? "")))))));
}

function operation(path, method, body) {
  const id = idOf(method, path), inputs = body.parameters || [];
  const inside = make("div", { class: "inside" });
  const [first, ...rest] = (body.description || "").split("\n\n");
  inside.append(...rest.map((text) => marked(text)));
  if (inputs.length)
    inside.append(table(["parameter", "in", "meaning"], inputs.map((one) => [make("code", { text: one.name }), one.in, one.description])));
  if (body.requestBody)
    inside.append(marked(`Body: ${body.requestBody.description || ""} ${mediaOf(body.requestBody.content)}`));
  inside.append(table(["status", "meaning", "form"], Object.entries(body.responses).map(([status, answer]) =>
    [make("code", { text: status }), answer.description, mediaOf(answer.content)])));
  inside.append(make("h3", { text: "From the shell" }), make("pre", { tabindex: "0", text: curlOf(addressOf(), path, method, body) }),
    ...trial(path, method, body));
  return folded(id, `${method.toUpperCase()} ${path}`, inside,
    make("span", { class: "verb", text: method.toUpperCase() }), make("code", { text: path }),
    make("span", { class: "soft", text: first || body.summary || "" }));
}

/** What unfolds, with a link to it beside its head. */
function folded(id, name, inside, ...head) {
  return make("div", { class: "linked" }, make("details", { class: "operation", id }, make("summary", {}, ...head), inside),
    make("a", { class: "anchor", href: `#${id}`, "aria-label": `Link to ${name}`, text: "#" }));
}

function schema(name, found) {
  const text = make("pre", { tabindex: "0", text: JSON.stringify(found, null, 2) });
  return folded(`schema-${name}`, name, make("div", { class: "inside" }, text),
    make("code", { text: name }), make("span", { class: "soft", text: (found.description || "").split("\n")[0] }));
}

/** Open what the address names, and go there. */
function open() {
  const named = location.hash ? byId(decodeURIComponent(location.hash.slice(1))) : null;
  if (named) { named.open = true; named.scrollIntoView(); }
}

async function start() {
  const api = await (await fetch("openapi.json")).json(), byTag = {};
  byId("title").textContent = `The interface of bnserve ${api.info.version}`;
  byId("intro").replaceChildren(...api.info.description.trim().split("\n\n").map((text) => marked(text)),
    make("p", {}, make("a", { href: "openapi.json", text: "openapi.json" }), " is what this page is drawn from."));
  for (const [path, methods] of Object.entries(api.paths))
    for (const [method, body] of Object.entries(methods)) (byTag[body.tags?.[0] || "other"] ||= []).push([path, method, body]);
  const tags = [FIRST, ...Object.keys(byTag).filter((tag) => tag !== FIRST)].filter((tag) => byTag[tag]);
  byId("paths").replaceChildren(...tags.flatMap((tag) =>
    [make("h2", { class: "tag-title", text: tag }), ...byTag[tag].map((one) => operation(...one))]));
  byId("list").replaceChildren(...tags.flatMap((tag) => [make("b", { text: tag }), ...byTag[tag].map(([path, method]) =>
    make("a", { href: `#${idOf(method, path)}` }, make("span", { class: "verb", text: method.toUpperCase() }), path.replace("/v1/models/", "…/")))]));
  byId("schemas").replaceChildren(...Object.entries(api.components.schemas).map(([name, found]) => schema(name, found)));
  document.documentElement.dataset.drawn = String(Object.keys(api.paths).length);
  open();
}

window.addEventListener("hashchange", open);
start().catch(() => byId("intro").replaceChildren(make("p", { role: "alert", class: "alert", text: "openapi.json could not be read: reload this page in a moment." })));
