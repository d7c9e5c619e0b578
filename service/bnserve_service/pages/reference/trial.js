// One path of the interface, asked from the page and from the shell.

import { make } from "../common/dom.js";
import { token } from "../common/session.js";

const JSON_TYPE = "application/json";
const EXAMPLES = { name: "default", version: "stable", sha256: "0".repeat(64) };
const MOST = 20000; // characters of an answer that are shown

const isBinary = (body) => body.requestBody && !body.requestBody.content[JSON_TYPE];
const exampleOf = (body) => body.requestBody?.content[JSON_TYPE]?.example;
const filled = (path, values) => path.replace(/\{(\w+)\}/g, (_, name) => encodeURIComponent(values[name] || EXAMPLES[name] || name));

/** The same question with curl. */
export function curlOf(address, path, method, body) {
  const lines = [`curl -s${method === "head" ? " --head" : method === "get" ? "" : ` -X ${method.toUpperCase()}`} '${address.replace(/\/$/, "")}${filled(path, {})}'`];
  if (token.value) lines.push(`-H "Authorization: Bearer $BNSERVE_TOKEN"`);
  if (isBinary(body)) lines.push(`-H 'Content-Type: ${Object.keys(body.requestBody.content)[0]}'`, "--data-binary @FILE");
  else if (body.requestBody) lines.push(`-H 'Content-Type: ${JSON_TYPE}'`, `-d '${JSON.stringify(exampleOf(body) ?? {})}'`);
  return lines.join(" \\\n  ");
}

/** The form that asks from here, or nothing where a file is to be sent. */
export function trial(path, method, body) {
  if (isBinary(body)) return [make("p", { class: "soft", text: "What is uploaded is a file: ask from the shell." })];
  const fields = (body.parameters || []).filter((one) => one.in === "path").map((one) =>
    make("input", { name: one.name, value: EXAMPLES[one.name] || "", spellcheck: "false" }));
  const content = body.requestBody ? make("textarea", { "aria-label": "Body", spellcheck: "false" }) : null;
  if (content) content.value = JSON.stringify(exampleOf(body) ?? {}, null, 2);
  const answer = make("pre", { tabindex: "0", hidden: true }), told = make("p", { role: "status", class: "soft" });
  const send = async (event) => {
    event.preventDefault();
    const values = Object.fromEntries(fields.map((field) => [field.name, field.value]));
    await show(filled(path, values).slice(1), method, content?.value, told, answer);
  };
  return [make("form", { class: "inside-form", onsubmit: send }, make("h3", { text: "Try it" }),
    make("div", { class: "fields" }, ...fields.map((field) => make("label", {}, field.name, field))), content,
    make("p", { class: "row" }, make("button", { type: "submit", text: "Send" }), told), answer)];
}

async function show(path, method, content, told, answer) {
  const headers = { accept: JSON_TYPE };
  if (content !== undefined) headers["content-type"] = JSON_TYPE;
  if (token.value) headers.authorization = `Bearer ${token.value}`;
  const started = performance.now();
  told.textContent = "Asking…";
  try {
    const got = await fetch(path, { method: method.toUpperCase(), headers, body: content });
    const text = await got.text();
    told.textContent = `${got.status} in ${(performance.now() - started).toFixed(0)} ms`;
    if (got.status === 401) told.textContent += ": this server asks for a token; the explorer takes it, for this page, too";
    answer.textContent = pretty(text);
    answer.hidden = !text;
  } catch { told.textContent = "The server does not answer."; }
}

function pretty(text) {
  let shown = text;
  try { shown = JSON.stringify(JSON.parse(text), null, 2); } catch { /* as it is */ }
  return shown.length > MOST ? `${shown.slice(0, MOST)}\n… ${shown.length - MOST} characters more` : shown;
}
