// Paths, errors and tokens, in tables.

import { byId, make } from "../common/dom.js";
import { bytes, number, seconds } from "../common/numbers.js";
import { buckets, by, quantile } from "./prometheus.js";

const REQUESTS = "bnserve_request_duration_seconds";

/** Fill a table: its head, and rows of cells of which all but the first are numbers. */
function fill(id, head, rows, empty) {
  const kind = (i) => (i ? "n" : null);
  byId(id).replaceChildren(
    make("tr", {}, ...head.map((text, i) => make("th", { class: kind(i), text }))),
    ...(rows.length ? rows.map((cells) => make("tr", {}, ...cells.map((text, i) => make("td", { class: kind(i), text }))))
      : [make("tr", {}, make("td", { class: "soft", colspan: head.length, text: empty }))]),
  );
}

const most = (map) => [...map].sort(([, a], [, b]) => b - a);

/** Fill the tables from the samples of `/metrics`. */
export function fillTables(samples) {
  fill("routes", ["path", "requests", "median", "99 %"], most(by(samples, "bnserve_requests_total", "route")).map(([route, count]) => {
    const of = buckets(samples, REQUESTS, (labels) => labels.route === route);
    return [route, count.toLocaleString("en"), seconds(quantile(0.5, of)), seconds(quantile(0.99, of))];
  }), "Nobody has asked anything.");
  fill("codes", ["error", "answers"], most(by(samples, "bnserve_errors_total", "code")).map(([code, count]) => [code, number(count)]), "None.");
  const used = (what) => by(samples, `bnserve_token_${what}_total`, "token");
  const [requests, rows, sent, took] = ["requests", "rows", "answer_bytes", "seconds"].map(used);
  fill("tokens", ["token", "requests", "rows", "sent", "time"], most(requests).map(([name, count]) => [
    name, count.toLocaleString("en"), (rows.get(name) || 0).toLocaleString("en"), bytes(sent.get(name) || 0), seconds(took.get(name) || 0),
  ]), "This server asks for no token, or nobody has used one.");
}
