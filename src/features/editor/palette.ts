import { firstValues } from "../../cycles/first-values.ts";
import type { Cycle } from "../../cycles/define.ts";
import type { EditorTexts } from "../../i18n/en/workplace/editor.ts";
import { ncLabels } from "../../i18n/nc-labels.ts";
import { ncLanguageOf, type Language } from "../../i18n/languages.ts";
import type { Statement, Words } from "../../nc/statement.ts";
import { noWords } from "../../program/values/typed-value.ts";
import type { BlockKind } from "../../app/fields/blocks/block-kind.ts";

type Group = keyof EditorTexts["groups"];

/** A block that can be put in: its kind, and the statement that it begins as. */
export interface Offered {
  readonly group: Group;
  readonly kind: BlockKind;
  /** Null where the kind alone does not say it: which cycle is chosen next. */
  readonly make: ((language: Language) => Statement) | null;
}

const at = (x: number, z: number): Words["axes"] => [
  { axis: "X", value: x, incremental: false },
  { axis: "Z", value: z, incremental: false },
];
const offer = (group: Group, kind: BlockKind, statement: Statement): Offered => ({
  group,
  kind,
  make: () => statement,
});
const polar = { polarRadius: { value: 10, incremental: false }, polarAngle: { value: 0, incremental: false } };

/** A cycle of the catalogue with the values of its printed example and labels in a language. */
export function cycleStatement(cycle: Cycle, language: Language): Statement {
  const labels = ncLabels(ncLanguageOf(language));
  const values = firstValues(cycle);
  return {
    kind: "cycle",
    cycle: cycle.number,
    name: labels.cycleName(cycle.number),
    parameters: Object.entries(cycle.params).map(([q, p]) => ({
      q,
      value: values[q] ?? p.example,
      label: labels.label(p.text),
    })),
  };
}

/** Every kind of block, in the order in which they are offered. */
export const palette: readonly Offered[] = [
  offer("path", "L", { kind: "path", path: "L", words: { ...noWords, axes: at(50, 2), feed: "max" } }),
  offer("path", "C", { kind: "path", path: "C", words: { ...noWords, axes: at(50, -10), turn: "cw" } }),
  offer("path", "CC", { kind: "path", path: "CC", words: { ...noWords, axes: at(0, 0) } }),
  offer("path", "CR", { kind: "path", path: "CR", words: { ...noWords, axes: at(50, -10), radius: 10, turn: "cw" } }),
  offer("path", "CT", { kind: "path", path: "CT", words: { ...noWords, axes: at(50, -10) } }),
  offer("path", "LP", { kind: "path", path: "LP", words: { ...noWords, ...polar } }),
  offer("path", "CP", { kind: "path", path: "CP", words: { ...noWords, polarAngle: polar.polarAngle, turn: "cw" } }),
  offer("path", "CTP", { kind: "path", path: "CTP", words: { ...noWords, ...polar } }),
  offer("path", "RND", { kind: "path", path: "RND", words: { ...noWords, radius: 1 } }),
  offer("path", "chamfer", { kind: "chamfer", length: 1, words: noWords }),
  offer("path", "approach", {
    kind: "approach",
    departing: false,
    form: "LT",
    words: {
      ...noWords,
      axes: [
        { axis: "X", value: 0, incremental: false },
        { axis: "Y", value: 0, incremental: false },
      ],
      length: 15,
      compensation: "RR",
      feed: { value: 100, unit: "F" },
    },
  }),
  offer("path", "departure", { kind: "approach", departing: true, form: "LT", words: { ...noWords, length: 15 } }),
  { group: "cycles", kind: "cycle", make: null },
  offer("cycles", "cycleCall", { kind: "cycleCall", how: "", words: noWords }),
  {
    group: "contour",
    kind: "contour",
    make: (language) => ({
      kind: "cycleLine",
      cycle: 14,
      line: 1,
      text: `${ncLabels(ncLanguageOf(language)).contour.label}2`,
    }),
  },
  offer("contour", "selectContour", { kind: "selectContour", file: "CONTOUR.H" }),
  offer("contour", "undercut", {
    kind: "undercut",
    form: "TYPE_E",
    words: [
      { name: "R", value: 1 },
      { name: "DEPTH", value: 2 },
      { name: "BREADTH", value: 15 },
    ],
  }),
  offer("contour", "groove", {
    kind: "groove",
    form: "RADIAL",
    words: [
      { name: "DEPTH", value: 2 },
      { name: "BREADTH", value: 5 },
    ],
  }),
  offer("technology", "toolCall", {
    kind: "toolCall",
    tool: 1,
    axis: null,
    speed: null,
    feed: null,
    deltaLength: null,
    deltaRadius: null,
    extra: [],
  }),
  offer("technology", "spin", { kind: "spin", constantSurface: true, cuttingSpeed: 180, speed: null, limit: 2500 }),
  offer("technology", "mode", { kind: "mode", mode: "TURN", kinematics: null }),
  offer("technology", "turnCorrection", {
    kind: "turnCorrection",
    system: "TCS",
    plane: "Z/X",
    words: [
      { name: "DZL", value: 0 },
      { name: "DXL", value: 0 },
    ],
  }),
  offer("technology", "turnBlank", { kind: "turnBlank", blank: { label: 1 } }),
  offer("technology", "functions", { kind: "functions", words: { ...noWords, functions: [136] } }),
  offer("technology", "toolDefinition", { kind: "toolDefinition", tool: 1, length: 0, radius: 0 }),
  offer("order", "label", { kind: "label", label: 1 }),
  offer("order", "call", { kind: "call", label: 1, repeat: null }),
  offer("order", "assign", { kind: "assign", fn: null, target: "Q1", formula: { kind: "value", value: 0 } }),
  offer("order", "stop", { kind: "stop", words: noWords }),
  offer("notes", "structure", { kind: "structure", text: "" }),
  offer("notes", "comment", { kind: "comment", text: " " }),
  offer("frame", "begin", { kind: "begin", name: "PROGRAM", unit: "MM" }),
  offer("frame", "blankCylinder", {
    kind: "blankCylinder",
    axis: "Z",
    outside: { measure: "D", value: 80 },
    length: 100,
    distance: 1,
    inside: null,
  }),
  offer("frame", "blankRotation", {
    kind: "blankRotation",
    axis: "Z",
    measure: "D",
    outline: { label: 1 },
    inner: null,
  }),
  offer("frame", "blankBox", {
    kind: "blankBox",
    corner: 1,
    axis: "Z",
    axes: [
      { axis: "X", value: 0, incremental: false },
      { axis: "Y", value: 0, incremental: false },
      {
        axis: "Z",
        value: -20,
        incremental: false,
      },
    ],
  }),
  offer("frame", "end", { kind: "end", name: "PROGRAM", unit: "MM" }),
];
