// Asking the server: with the visitor's token, and with its errors as words.

import { decode } from "./msgpack.js";

const KEPT = "bnserve-token";
const MSGPACK = "application/msgpack";

/** What the server refuses: `detail` in words, `errors` with the parameters that are wrong. */
export class Problem extends Error {
  constructor(status, body) {
    super(body.detail || body.title || `The server answered ${status}.`);
    this.status = status;
    this.code = body.code || "";
    this.errors = body.errors || [];
    this.retryAfter = body.retry_after;
  }
}

/** Kept for this tab alone, and forgotten when it closes. */
export const token = {
  get value() { return sessionStorage.getItem(KEPT) || ""; },
  set value(text) { if (text) sessionStorage.setItem(KEPT, text); else sessionStorage.removeItem(KEPT); },
};

/** The address of a path of this server, wherever a proxy has put it. */
export const addressOf = (path = ".") => new URL(path, document.baseURI).href.replace(/[#?].*$/, "");

/** Fetch a path. A `body` is posted as JSON; `binary` asks for MessagePack. Returns what was answered, and in which time. */
export async function ask(path, { body, binary = false, text = false, method, signal } = {}) {
  const headers = { accept: text ? "text/plain, application/problem+json" : binary ? MSGPACK : "application/json" };
  if (token.value) headers.authorization = `Bearer ${token.value}`;
  if (body !== undefined) headers["content-type"] = "application/json";
  const started = performance.now();
  let answer;
  try {
    answer = await fetch(path, {
      method: method || (body === undefined ? "GET" : "POST"), headers, signal,
      body: body === undefined ? undefined : JSON.stringify(body),
    });
  } catch (error) {
    if (error.name === "AbortError") throw error;
    throw new Error("The server does not answer. Is it running, and is the network there?");
  }
  if (!answer.ok) throw await problemOf(answer);
  const media = answer.headers.get("content-type") || "";
  const content = text ? await answer.text()
    : media.startsWith(MSGPACK) ? decode(await answer.arrayBuffer()) : await answer.json();
  return { content, milliseconds: performance.now() - started };
}

async function problemOf(answer) {
  let body = {};
  try { body = await answer.json(); } catch { /* a proxy's page, perhaps */ }
  return new Problem(answer.status, body);
}
