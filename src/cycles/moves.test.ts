import { expect, test } from "vitest";
import { contourFrom, type ContourElement } from "../kernel/contour/contour.ts";
import type { Move } from "../kernel/plan/move.ts";
import type { Pt } from "../kernel/geometry/point.ts";
import type { TipOrientation } from "../kernel/plan/tool.ts";
import { axial, diameter, toDiameter, toRadius } from "../kernel/units.ts";
import { shippedTools } from "../program/tools/shipped-tools.ts";
import { cycleByNumber } from "./index.ts";

/**
 * One line a case, in a file of a family: `812 from 75/2 | T1 Q463=3`: the cycle, the start point X/Z, then what
 * differs from the example of its list: tool, values, and for free contours the elements in order (`75/-20 50/-20 RND2
 * …`). Under it the moves: r rapid, f feed, a arc, d dwell (behind it the turns of the spindle), each with its end
 * point X/Z; a number in brackets is the step of the manual that begins there.
 */
const at = (x: string, z: string): Pt => ({ z: axial(Number(z)), r: toRadius(diameter(Number(x))) });
const PRINTED = "75/-20 50/-20 RND2 20/-25 RND2 20/0";

function elements(words: readonly string[]): ContourElement[] {
  return words.map((w): ContourElement => {
    const [x, z] = w.split("/");
    const [, ax = "", az = "", radius, turn] = /^CR(.+?)\/(.+?)\/([\d.]+)\/(cw|ccw)$/.exec(w) ?? [];
    if (radius) return { kind: "radius", to: at(ax, az), radius: Number(radius), turn: turn === "cw" ? "cw" : "ccw" };
    if (w.startsWith("RND")) return { kind: "round", size: Number(w.slice(3)) };
    if (w.startsWith("CHF")) return { kind: "chamfer", size: Number(w.slice(3)) };
    return { kind: "line", to: at(x ?? "", z ?? "") };
  });
}

const number = (n: number) => String(Number(n.toFixed(3)) || 0);
const LETTER = { rapid: "r", feed: "f", arc: "a", thread: "t" };

function listing(moves: readonly Move[]): string {
  let step = "";
  return moves
    .map((m) => {
      const now = `${m.run === "finish" ? "F" : m.phase === "smooth" ? "S" : ""}${m.step}`;
      const mark = now === step ? "" : `[${now}] `;
      step = now;
      if (m.kind === "feed" && m.dwell !== undefined) return `${mark}d${m.dwell}`;
      return `${mark}${LETTER[m.kind]}${number(toDiameter(m.to.r))}/${number(m.to.z)}`;
    })
    .join(" ");
}

/** The moves of one line. */
function planned(line: string): string {
  const [head = "", tail = ""] = line.split("|");
  const [, cycleNumber = "", x = "", z = ""] = /^(\d+) from (\S+?)\/(\S+)/.exec(head.trim()) ?? [];
  const cycle = cycleByNumber(Number(cycleNumber));
  if (!cycle) throw new Error(`no cycle in: ${line}`);
  const words = tail.trim().split(/\s+/).filter(Boolean);
  const values = Object.fromEntries(Object.entries(cycle.params).map(([q, p]) => [q, p.example]));
  let tool = shippedTools.find((t) => t.T === cycle.setup.tool);
  const contour: string[] = [];
  for (const w of words) {
    if (/^TO\d$/.test(w) && tool) tool = { ...tool, TO: Number(w.slice(2)) as TipOrientation };
    else if (/^T\d+$/.test(w)) tool = shippedTools.find((t) => t.T === Number(w.slice(1)));
    else if (w.startsWith("Q")) values[w.split("=")[0] ?? ""] = Number(w.split("=")[1]);
    else contour.push(w);
  }
  if (!tool) throw new Error(`no tool in: ${line}`);
  const start = at(x, z);
  const given = {
    contour:
      cycle.contour === "free"
        ? contourFrom(elements(contour.length > 0 ? contour : PRINTED.split(" "))).segments
        : null,
    start,
  };
  const plan = cycle.plan(values as never, { tool, start, feedUnit: "mm/rev", autoFeed: null, stock: null }, given);
  const issues = plan.issues.map((i) => `${i.severity} ${i.code}${i.at ? ` ${i.at}` : ""}`);
  return [`${plan.passes} x ${number(plan.infeed)}`, listing(plan.moves), ...issues.map((i) => `! ${i}`)]
    .filter(Boolean)
    .join("\n");
}

const files = import.meta.glob<string>("./*.cases.txt", { query: "?raw", import: "default", eager: true });

test.each(Object.entries(files))("moves of the one-line cases in %s", async (path, cases) => {
  const lines = cases.split("\n").filter((l) => /^\d+ from/.test(l));
  const text = lines.map((l) => `${l}\n${planned(l)}\n`).join("\n");
  await expect(text).toMatchFileSnapshot(path);
  expect(lines.length).toBeGreaterThan(5);
});
