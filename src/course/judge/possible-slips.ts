import { SAME } from "../../kernel/tolerance.ts";
import { cycleByNumber } from "../../cycles/index.ts";
import type { Param } from "../../cycles/params.ts";
import { isPosition } from "../../cycles/completions.ts";
import { parse } from "../../nc/parse.ts";
import { blockNumbers, type Block } from "../../nc/program.ts";
import type { Slip, SlipValue } from "./judgement.ts";
import { reversedContours } from "./reversed-contour.ts";
import type { SlipTrial } from "./tool-slips.ts";

const NUMBER = String.raw`([+-]?\d+(?:\.\d+)?|[+-]?\.\d+)`;
const rounded = (value: number): number => Math.round(value * 1000) / 1000;
const written = (value: number): string => `${value < 0 ? "-" : "+"}${Math.abs(rounded(value))}`;

/** What a number in a block measures: a diameter, a Z, or the size of an element of the contour. */
type Measure = "diameter" | "z" | "size";

/** A number in the text of a block, with its place. */
export interface Literal extends Omit<SlipValue, "better"> {
  readonly index: number;
  readonly measure: Measure;
  /** The end of the contour that a value of a cycle belongs to; null in a path. */
  readonly place: Param["place"] | null;
}

/** The measure of a value of a cycle; null for those that no drawing gives. */
function measureOf(param: Param | undefined): Measure | null {
  if (!param || param.incremental) return null;
  if (param.kind === "diameter") return "diameter";
  if (param.kind === "axial") return "z";
  return param.drawn && param.kind !== "choice" && !isPosition(param) ? "size" : null;
}

/** The dimensions in a block that a slip can change: those of a cycle, or X and Z of a path. */
function literalsOf({ statement: s, raw }: Block, index: number, block: number): readonly Literal[] {
  if (s.kind === "cycle") {
    const params: Readonly<Partial<Record<string, Param>>> = cycleByNumber(s.cycle)?.params ?? {};
    return s.parameters.flatMap(({ q, value }): Literal[] => {
      const param = params[q],
        measure = measureOf(param);
      if (!param || measure === null || typeof value !== "number") return [];
      return [{ index, block, q, value, measure, place: param.place }];
    });
  }
  if (s.kind !== "path") return [];
  const said = raw.replace(/;.*$/s, "");
  return (["X", "Z"] as const).flatMap((q): Literal[] => {
    const found = new RegExp(String.raw`(?<![A-Z])${q}[ \t]*${NUMBER}(?![\d.])`, "i").exec(said);
    const measure = q === "X" ? "diameter" : "z";
    return found ? [{ index, block, q, value: Number(found[1]), measure, place: null }] : [];
  });
}

/** The text of a block with another number. */
function withValue(raw: string, q: string, value: number): string {
  const pattern = q.startsWith("Q")
    ? new RegExp(String.raw`((?:^|\s)${q}[ \t]*=?[ \t]*)${NUMBER}`, "i")
    : new RegExp(String.raw`((?<![A-Z])${q}[ \t]*)${NUMBER}`, "i");
  return raw.replace(pattern, (_, front: string) => front + written(value));
}

export interface Change {
  readonly literal: Literal;
  readonly to: number;
}
export interface PossibleSlip extends SlipTrial {
  /** Empty for a slip that is no value. */
  readonly changes: readonly Change[];
}

/** A slip in the order or the number of blocks: `at` are indexes of the blocks concerned. */
const inBlocks = (
  kind: Slip["kind"],
  raws: readonly string[],
  numbers: readonly (number | null)[],
  at: readonly number[],
  value = 0,
): PossibleSlip => ({
  slip: {
    kind,
    values: at
      .map((index) => ({ block: numbers[index] ?? 0, q: "", value, better: value }))
      .toSorted((one, other) => one.block - other.block),
  },
  changes: [],
  text: raws.join(""),
});

/** Two lines one after the other, the second one first. */
function exchangedBlocks(blocks: readonly Block[], numbers: readonly (number | null)[]): PossibleSlip[] {
  const isPath = (index: number) => blocks[index]?.statement.kind === "path";
  return blocks.flatMap((_, i) => {
    if (!isPath(i) || !isPath(i + 1)) return [];
    const raws = blocks.map(({ raw }, k) => (k === i ? blocks[i + 1]?.raw : k === i + 1 ? blocks[i]?.raw : raw) ?? "");
    return [inBlocks("order", raws, numbers, [i, i + 1])];
  });
}

/** Blocks between a definition and its call, at most. */
const TO_CALL = 4;

/** Indexes of the cycle definitions that no call follows before the next definition. */
const uncalledIndexes = (blocks: readonly Block[]): number[] =>
  blocks.flatMap(({ statement: s }, i) => {
    if (s.kind !== "cycle" || !cycleByNumber(s.cycle)) return [];
    const next = blocks.findIndex(
      ({ statement }, k) => k > i && (statement.kind === "cycle" || statement.kind === "end"),
    );
    const until = blocks.slice(i + 1, next < 0 ? blocks.length : next);
    return until.some(({ statement, raw }) => statement.kind === "cycleCall" || /\bM(?:89|99)\b/i.test(raw)) ? [] : [i];
  });

/** A missing call of a defined cycle, behind one of the next positions. */
function missingCalls(blocks: readonly Block[], numbers: readonly (number | null)[]): PossibleSlip[] {
  return uncalledIndexes(blocks).flatMap((i) => {
    const s = blocks[i]?.statement;
    const behind = blocks.flatMap(({ statement }, k) =>
      k > i && k <= i + TO_CALL && statement.kind === "path" ? [k] : [],
    );
    return behind.map((at) =>
      inBlocks(
        "call",
        blocks.map(({ raw }, k) => (k === at ? `${raw}CYCL CALL\n` : raw)),
        numbers,
        [i],
        s?.kind === "cycle" ? s.cycle : 0,
      ),
    );
  });
}

/** What two values become if they were entered in each other's place. */
function exchangedValues(one: Literal, other: Literal): readonly (readonly [number, number])[] {
  const plain = [other.value, one.value] as const;
  if (one.measure === other.measure) return [plain];
  // A diameter and a Z: whoever exchanges them may keep the minus at its place.
  return other.value < 0 && one.value > 0 ? [[-other.value, -one.value], plain] : [plain];
}

/** What an end may have been meant to be: on the other side of the start, or as far from it as its value says. */
function meantEnds(start: Literal, end: Literal): readonly (readonly ["side" | "relative", number])[] {
  const far = Math.abs(end.value);
  return end.measure === "z"
    ? [
        ["side", 2 * start.value - end.value],
        ["relative", start.value - far],
      ]
    : [
        ["relative", start.value - 2 * far],
        ["relative", start.value + 2 * far],
      ];
}

/** Each slip is a program of its own, and each pair of values a slip: a longer program is no exercise. */
const MOST_BLOCKS = 500;

/** Every program that differs from a program by one slip. */
export function everySlip(text: string): readonly PossibleSlip[] {
  const program = parse(text),
    numbers = blockNumbers(program),
    { blocks } = program;
  if (blocks.length > MOST_BLOCKS) return [];
  const all = blocks.flatMap((block, i) => literalsOf(block, i, numbers[i] ?? 0));
  const positions = all.filter(({ measure }) => measure !== "size");
  const put = (kind: Slip["kind"], ...changes: readonly Change[]): PossibleSlip => ({
    slip: {
      kind,
      values: changes.map(({ literal: { block, q, value }, to }) => ({ block, q, value, better: rounded(to) })),
    },
    changes,
    text: blocks
      .map(({ raw }, i) =>
        changes.reduce((now, { literal: { index, q }, to }) => (index === i ? withValue(now, q, to) : now), raw),
      )
      .join(""),
  });
  const isSome = ({ value }: Literal) => Math.abs(value) > SAME;
  const isDiameter = ({ measure }: Literal) => measure === "diameter";
  const single = positions.filter(isSome).flatMap((literal) => [
    put("sign", { literal, to: -literal.value }),
    // Beyond the axis a value is no diameter of the part.
    ...(isDiameter(literal) && literal.value > 0
      ? [put("radius", { literal, to: 2 * literal.value }), put("doubled", { literal, to: literal.value / 2 })]
      : []),
  ]);
  // Who takes the radius for the diameter often does so for all values of a cycle.
  const inCycles = positions.filter((each) => each.q.startsWith("Q") && isDiameter(each) && isSome(each));
  const whole = [...new Set(inCycles.map(({ index }) => index))]
    .map((cycle) => inCycles.filter(({ index }) => index === cycle))
    .filter((each) => each.length > 1)
    .flatMap((each) => [
      put("radius", ...each.map((literal) => ({ literal, to: 2 * literal.value }))),
      put("doubled", ...each.map((literal) => ({ literal, to: literal.value / 2 }))),
    ]);
  // Two lines after one another that each have one coordinate.
  const isAlone = ({ index, place }: Literal) =>
    place === null && positions.filter((each) => each.index === index).length === 1;
  const isNextAlone = (one: Literal, other: Literal) =>
    other.index === one.index + 1 && one.measure !== other.measure && isAlone(one) && isAlone(other);
  const pairs = all.flatMap((one, i) =>
    all.slice(i + 1).flatMap((other) => {
      const isOneBlock = other.index === one.index || isNextAlone(one, other);
      if ((one.measure === "size") !== (other.measure === "size")) return [];
      if (!isOneBlock || Math.abs(one.value - other.value) < SAME) return [];
      // Start and end of one axis, or both axes of one end.
      if (one.place !== null && (one.measure === other.measure) === (one.place === other.place)) return [];
      const [x, z] = one.measure !== other.measure && isDiameter(other) ? [other, one] : [one, other];
      return exchangedValues(x, z).map(([toX, toZ]) =>
        put("exchanged", { literal: x, to: toX }, { literal: z, to: toZ }),
      );
    }),
  );
  const ends = positions.flatMap((start) =>
    positions.flatMap((literal) => {
      const isPair = literal.index === start.index && literal.measure === start.measure;
      if (!isPair || start.place !== "start" || literal.place !== "end") return [];
      return meantEnds(start, literal).map(([kind, to]) => put(kind, { literal, to }));
    }),
  );
  const points = all
    .filter(isSome)
    .flatMap((literal) =>
      [10, 0.1, ...(literal.measure === "size" ? [] : [0.01])].map((times) =>
        put("point", { literal, to: literal.value * times }),
      ),
    );
  const reversed = reversedContours(blocks).map((turned): PossibleSlip => ({
    slip: { kind: "reversed", values: [{ block: numbers[turned.first] ?? 0, q: "", value: 0, better: 0 }] },
    changes: [],
    text: turned.text,
  }));
  return [
    ...single,
    ...whole,
    ...pairs,
    ...ends,
    ...points,
    ...reversed,
    ...missingCalls(blocks, numbers),
    ...exchangedBlocks(blocks, numbers),
  ];
}
