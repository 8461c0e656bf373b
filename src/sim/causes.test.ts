import { expect, test } from "vitest";
import { issue } from "../kernel/issue.ts";
import { causesAlone, type ProofIssue } from "./causes.ts";

const place = { area: 1, x: 40, z: -5 };
const rapid = issue("rapidInStock", "error", place), gouge = issue("gouge", "error", place);
const loose = issue("cutOnLoosePiece", "error", { ...place, block: 7 });
const holder = issue("holderContact", "error", { x: 40, z: -5 });
const overruns = issue("threadOverruns", "error", { ...place, meets: "shaft", axis: "Z", end: -4, to: -6 });
const nothing = issue("nothingCut", "warning", {}), air = issue("airPasses", "info", { count: 2 });
const left = issue("materialLeft", "warning", { ...place, reason: "mainEdge" });
const at = (found: ProofIssue["issue"], operation: number, step: number | null = null): ProofIssue => ({
  issue: found,
  step,
  block: 9,
  operation,
});
const told = (all: readonly ProofIssue[]) => causesAlone(all).map((p) => p.issue.code);

test.each<[string, ProofIssue[], string[]]>([
  ["a rapid into the part is told once", [at(gouge, 0, 4), at(rapid, 0, 4)], ["rapidInStock"]],
  ["a gouge of another move stays", [at(gouge, 0, 5), at(rapid, 0, 4)], ["gouge", "rapidInStock"]],
  ["an overrun says why its thread damages", [at(overruns, 0, 3), at(gouge, 0, 5), at(rapid, 0, 6), at(holder, 0, 7)], ["threadOverruns"]],
  ["of another operation it says nothing", [at(overruns, 0, 3), at(gouge, 1, 9)], ["threadOverruns", "gouge"]],
  ["on a loose piece nothing can be cut", [at(loose, 0, 3), at(nothing, 0), at(air, 0)], ["cutOnLoosePiece"]],
  ["beside it, another operation cuts nothing", [at(loose, 0, 3), at(nothing, 1)], ["cutOnLoosePiece", "nothingCut"]],
  ["residual material beside passes in the air is reported", [at(air, 0), at(left, 0)], ["airPasses", "materialLeft"]],
])("%s", (_, all, expected) => {
  expect(told(all)).toEqual(expected);
});
