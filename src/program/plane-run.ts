import { cornerBlock, pole } from "./path-block.ts";
import type { Statement, Words } from "../nc/statement.ts";
import type { Machine } from "./machine.ts";
import { closeMill, millApproach, millCorner, millPath } from "./mill-run.ts";
import { addCorner } from "./plane-guide.ts";
import { closeTurn, guidedPath, isGuided, turnApproach } from "./turn-run.ts";

/** Carries out every contour that waits for its end. */
export function closePlanes(machine: Machine): void {
  closeMill(machine);
  closeTurn(machine);
}

/** Runs what happens in a working plane: milling, and in turning all that is compensated. False: the block is not of this kind. */
export function planeStatement(machine: Machine, s: Statement, index: number): boolean {
  switch (s.kind) {
    case "toolDefinition": return toolDefinition(machine, s, index);
    case "toolCall": return toolCall(machine, s, index);
    case "blankBox": return blankTop(machine, s, index);
    case "mode":
      closePlanes(machine);
      machine.last = null;
      return false;
    case "cycleCall":
      closePlanes(machine);
      return false;
    case "path": case "chamfer": case "approach": return machine.turning ? turning(machine, s, index) : milling(machine, s, index);
    default: return false;
  }
}

type Motion = Extract<Statement, { kind: "path" | "chamfer" | "approach" }>;

/** The size of a rounding or chamfer in mm. */
function sizeOf(machine: Machine, value: Words["radius"] | null, index: number): number | null {
  const n = value === undefined || value === null ? null : machine.number(value, index);
  return n === null ? null : machine.length(n);
}

const cornerOf = (s: Motion) =>
  s.kind === "chamfer" ? { kind: "chamfer" as const, size: s.length } : s.kind === "path" && s.path === "RND" ? { kind: "round" as const, size: s.words.radius } : null;

function milling(machine: Machine, s: Motion, index: number): boolean {
  if (machine.mill.otherAxis) {
    machine.leaveUnproved(s.kind === "path" ? s.path : s.kind === "chamfer" ? "CHF" : s.form, index);
    return true;
  }
  const corner = cornerOf(s);
  if (corner) {
    const size = sizeOf(machine, corner.size, index);
    millCorner(machine, size === null ? null : { kind: corner.kind, size }, s.words.feed, index);
  } else if (s.kind === "approach") millApproach(machine, s, index);
  else if (s.kind === "path" && s.path === "CC") pole(machine, s.words, index);
  else if (s.kind === "path" && s.path !== "RND" && s.path !== "CC") millPath(machine, { path: s.path, words: s.words }, index);
  return true;
}

function turning(machine: Machine, s: Motion, index: number): boolean {
  if (s.kind === "approach") {
    turnApproach(machine, s, index);
    return true;
  }
  const corner = cornerOf(s);
  if (corner && machine.guide.chain) {
    const size = sizeOf(machine, corner.size, index);
    const own = typeof s.words.feed === "object" ? machine.number(s.words.feed.value, index) : null;
    const last = machine.guide.chain.items.at(-1);
    const feed = own === null ? (last?.feed ?? null) : machine.feedOf(own);
    if (size !== null && !addCorner(machine.guide, { element: { kind: corner.kind, size }, feed, index })) cornerBlock(machine, { kind: corner.kind, size }, s.words.feed, index);
    return true;
  }
  if (s.kind !== "path" || s.path === "CC" || s.path === "RND" || !isGuided(machine, s.words)) return false;
  guidedPath(machine, { path: s.path, words: s.words }, index);
  return true;
}

/** TOOL DEF with L and R, as older programs define their tools. */
function toolDefinition(machine: Machine, s: Extract<Statement, { kind: "toolDefinition" }>, index: number): boolean {
  const n = s.radius === null ? null : machine.number(s.radius, index);
  if (n !== null) machine.mill.defined.set(s.tool, machine.length(n));
  return true;
}

function toolCall(machine: Machine, s: Extract<Statement, { kind: "toolCall" }>, index: number): boolean {
  closePlanes(machine);
  const { mill } = machine;
  if (s.axis !== null) mill.otherAxis = s.axis !== "Z";
  const wanted = typeof s.tool === "object" && s.tool !== null ? machine.number(s.tool, index) : s.tool;
  if (wanted === null) return false;
  const row = machine.shop.mills?.find((m) => m.T === wanted || m.NAME === wanted);
  const radius = mill.defined.get(wanted) ?? (row ? row.R + (row.DR ?? 0) : null);
  const delta = s.deltaRadius === null ? 0 : (machine.number(s.deltaRadius, index) ?? 0);
  mill.tool = String(wanted);
  mill.radius = radius === null ? null : Math.max(0, radius + machine.length(delta));
  return false;
}

function blankTop(machine: Machine, s: Extract<Statement, { kind: "blankBox" }>, index: number): boolean {
  const word = s.corner === 2 ? s.axes.find((w) => w.axis === "Z") : undefined;
  const n = word && machine.number(word.value, index);
  if (n !== undefined && n !== null) machine.mill.top = machine.length(n);
  return false;
}
