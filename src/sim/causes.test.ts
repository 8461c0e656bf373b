import { expect, test } from "vitest";
import { issue } from "../kernel/plan/issue.ts";
import { axial, radius } from "../kernel/units.ts";
import { withoutConsequences, type ProofIssue } from "./causes.ts";
import { stockIssues } from "./issues.ts";

const place = { area: 1, x: 40, z: -5 };
const rapid = issue("rapidInStock", "error", place),
  gouge = issue("gouge", "error", place);
const loose = issue("cutOnLoosePiece", "error", { ...place, block: 7 });
const holder = issue("holderContact", "error", { x: 40, z: -5 });
const overruns = issue("threadOverruns", "error", { ...place, meets: "shaft", axis: "Z", end: -4, to: -6 });
const nothing = issue("nothingCut", "warning", {}),
  air = issue("airPasses", "info", { count: 2 });
const left = issue("materialLeft", "warning", { ...place, reason: "mainEdge" });
const at = (found: ProofIssue["issue"], operation: number, step: number | null = null): ProofIssue => ({
  issue: found,
  step,
  block: 9,
  operation,
});
const codesWithoutConsequences = (all: readonly ProofIssue[]) => withoutConsequences(all).map((p) => p.issue.code);

test.each<[string, ProofIssue[], string[]]>([
  ["a rapid into the part is told once", [at(gouge, 0, 4), at(rapid, 0, 4)], ["rapidInStock"]],
  ["a gouge of another move stays", [at(gouge, 0, 5), at(rapid, 0, 4)], ["gouge", "rapidInStock"]],
  [
    "an overrun says why its thread damages",
    [at(overruns, 0, 3), at(gouge, 0, 5), at(rapid, 0, 6), at(holder, 0, 7)],
    ["threadOverruns"],
  ],
  ["of another operation it says nothing", [at(overruns, 0, 3), at(gouge, 1, 9)], ["threadOverruns", "gouge"]],
  ["on a loose piece nothing can be cut", [at(loose, 0, 3), at(nothing, 0), at(air, 0)], ["cutOnLoosePiece"]],
  ["beside it, another operation cuts nothing", [at(loose, 0, 3), at(nothing, 1)], ["cutOnLoosePiece", "nothingCut"]],
  ["residual material beside passes in the air is reported", [at(air, 0), at(left, 0)], ["airPasses", "materialLeft"]],
])("%s", (_, all, expected) => {
  expect(codesWithoutConsequences(all)).toEqual(expected);
});

test("an operation with a plan error does not report the stock issues it causes", () => {
  const all = [at(nothing, 0), at(air, 0), at(left, 0), at(rapid, 0), at(nothing, 1), at(left, 1), at(left, 2)];
  expect(
    withoutConsequences(all, { failed: new Set([0, 2]), questioned: new Set() }).map(({ issue, operation }) => [
      operation,
      issue.code,
    ]),
  ).toEqual([
    [0, "rapidInStock"],
    [1, "nothingCut"],
  ]);
});

test("a questioned dimension explains the tool and stock issues of its operation, but not damage", () => {
  const all = [at(nothing, 0), at(holder, 0), at(left, 0), at(gouge, 0), at(holder, 1)];
  const found = withoutConsequences(all, { failed: new Set(), questioned: new Set([0]) });
  expect(found.map(({ issue, operation }) => [operation, issue.code])).toEqual([
    [0, "gouge"],
    [1, "holderContact"],
  ]);
});

test.each([
  [true, []],
  [false, ["nothingCut"]],
])("the stock knows which operation failed: %s", (hasFailed, expected) => {
  const none = {
    airPasses: 0,
    crest: null,
    thread: null,
    deepest: null,
    thickest: null,
    behindLimits: [],
    startInMaterial: null,
  };
  const stays = {
    area: 2,
    thickness: 1,
    reason: "mainEdge",
    ring: [],
    place: { z: axial(-5), r: radius(20) },
    operation: 0,
  };
  const empty = { stated: [], uncheckedFrom: null, remarks: [], loose: [], unheld: null };
  const proof = { operations: [{ ...none, cut: 0, hasFailed, isQuestioned: false }], residual: [stays], ...empty };
  const found = stockIssues({ findings: [], proof } as unknown as Parameters<typeof stockIssues>[0]);
  expect(found.map((p) => p.issue.code)).toEqual(expected);
});
