// The state of the service, every two seconds while somebody looks.

import { byId, make, terms } from "../common/dom.js";
import { explain } from "../common/login.js";
import { bytes, number, seconds } from "../common/numbers.js";
import { ask } from "../common/session.js";
import { Plot } from "../plots/plot.js";
import { buckets, by, quantile, read, sum } from "./prometheus.js";
import { fillTables } from "./tables.js";

const EVERY = 2000, KEPT = 150; // milliseconds, and how many looks are drawn
const REQUESTS = "bnserve_request_duration_seconds";
const history = [];
const charts = {};

async function look() {
  const { content } = await ask("metrics", { text: true });
  const samples = read(content), at = Date.now() / 1000, last = history[history.length - 1];
  const now = {
    at, samples, latency: buckets(samples, REQUESTS), errors: by(samples, "bnserve_errors_total", "code"),
    requests: sum(samples, "bnserve_requests_total"), rows: sum(samples, "bnserve_rows_total"), cpu: sum(samples, "process_cpu_seconds_total"),
    queue: sum(samples, "bnserve_queue_samples") / (sum(samples, "bnserve_queue_capacity_samples") || 1),
  };
  if (last) {
    const rate = (name) => Math.max(0, now[name] - last[name]) / (at - last.at);
    Object.assign(now, { perSecond: rate("requests"), rowsPerSecond: rate("rows"), load: rate("cpu") });
    now.errorsPerSecond = Math.max(0, total(now.errors) - total(last.errors)) / (at - last.at);
    for (const [name, part] of [["p50", 0.5], ["p99", 0.99]]) now[name] = quantile(part, now.latency, last.latency);
  }
  history.push(now);
  if (history.length > KEPT) history.shift();
  return now;
}

const total = (map) => [...map.values()].reduce((a, b) => a + b, 0);

function tile(term, value, kind) {
  return make("div", { class: kind }, make("dt", { text: term }), make("dd", { text: value }));
}

function tiles(now, ready) {
  const { samples } = now, up = now.at - sum(samples, "process_start_time_seconds");
  const all = quantile(0.5, now.latency), tail = quantile(0.99, now.latency);
  byId("tiles").replaceChildren(
    tile("Ready", ready ? "yes" : "no", ready ? "good" : "bad"), tile("Up for", seconds(up)),
    tile("Requests / s", number(now.perSecond ?? NaN, 3)), tile("Waveforms / s", number(now.rowsPerSecond ?? NaN, 3)),
    tile("Latency, median", seconds(all)), tile("Latency, 99 %", seconds(tail)),
    tile("Queue", `${number(100 * now.queue, 2)} %`), tile("Requests waiting", number(sum(samples, "bnserve_queue_jobs"))),
    tile("Processor", now.load === undefined ? "–" : `${number(100 * now.load, 2)} %`), tile("Memory", bytes(sum(samples, "process_resident_memory_bytes"))),
    tile("Worker processes", number(sum(samples, "bnserve_workers"))),
    tile("Errors", number(total(now.errors)), total(now.errors) ? "" : "good"),
  );
}

function chart(id, lines, label, unit, least) {
  const holder = byId(id).parentElement, latest = history[history.length - 1].at;
  charts[id] ||= new Plot(holder);
  const x = history.map(({ at }) => at - latest);
  const series = lines.map(([name, colour, value]) => ({ name, colour, x, y: history.map((one) => value(one) ?? NaN), width: 2 }));
  const high = Math.max(least, ...series.flatMap((one) => one.y.filter(Number.isFinite)));
  charts[id].draw({ x: { low: Math.min(-30, x[0]), high: 0, label: "seconds ago", unit: "s" }, y: { low: 0, high: 1.1 * high, label, unit }, series });
  holder.parentElement.querySelector(".legend").replaceChildren(...series.map((one) => make("span", {},
    make("i", { class: `swatch c-${one.colour}` }), one.name)));
}

function draw(now, ready) {
  tiles(now, ready);
  chart("requests", [["requests", "a", (one) => one.perSecond], ["waveforms", "m21", (one) => one.rowsPerSecond]], "per second", "/s", 1);
  chart("latency", [["99 %", "b", (one) => 1e3 * one.p99], ["median", "a", (one) => 1e3 * one.p50]], "milliseconds", "ms", 1);
  chart("queue", [["work waiting or running", "m44", (one) => 100 * one.queue]], "% of what may wait", "%", 1);
  chart("errors", [["errors", "bad", (one) => one.errorsPerSecond]], "per second", "/s", 1);
  fillTables(now.samples, now.at);
  byId("told").textContent = `As of ${new Date(now.at * 1000).toLocaleTimeString("en-GB")}, every ${EVERY / 1000} seconds while this page is in sight.`;
  byId("trouble").textContent = ready ? "" : "The server says that it is not ready: it loads models, or is stopping.";
  document.documentElement.dataset.drawn = String(history.length);
}

/** What the server says of its readiness; that it is not is no error here. */
async function isReady() {
  try { return Boolean((await ask("v2/health/ready")).content.ready); } catch (error) { if (error.status === 503) return false; throw error; }
}

async function again() {
  if (!document.hidden) {
    try { draw(await look(), await isReady()); } catch (error) {
      if (error.status === 401 || error.status === 403) { refused(error); return; }
      byId("trouble").textContent = `${error.message} What is shown is from before.`;
    }
  }
  setTimeout(again, EVERY);
}

function refused(error) {
  byId("content").hidden = true;
  const words = {
    403: "What a service does concerns everybody who uses it: its token needs the scope “metrics” or “admin”. Enter one that has it.",
    404: "This server keeps its metrics on a port or a socket of their own (metrics_port, metrics_uds), which this page does not reach. " +
      "Its operators open them there.",
  };
  if (error.status === 403) error = Object.assign(new Error(words[403]), { status: 401 });
  if (error.status === 404) error = new Error(words[404]);
  explain(byId("login"), error, start);
}

async function start() {
  try {
    const { models, limits, software, processor, digest } = (await ask("v1/manifest")).content;
    draw(await look(), await isReady());
    byId("login").hidden = true;
    byId("content").hidden = false;
    byId("manifest").replaceChildren(...terms([
      ["models", models.map((model) => `${model.name} ${model.version}`).join(", ")],
      ["software", Object.entries(software).map(([name, version]) => `${name} ${version}`).join(", ")],
      ["processor", typeof processor === "string" ? processor : JSON.stringify(processor)],
      ["rows in a request", limits.max_rows.toLocaleString("en")], ["frequencies", limits.max_frequencies.toLocaleString("en")],
      ["manifest", make("code", { text: digest })],
    ]));
    setTimeout(again, EVERY);
  } catch (error) { refused(error); }
}

start();
