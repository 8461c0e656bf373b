import { isDeepStrictEqual } from "node:util";
import fc from "fast-check";
import { openWork } from "../../src/app/calculation/open-work.ts";
import type { Outcome } from "../../src/app/calculation/outcome.ts";
import { planner } from "../../src/app/calculation/plan.ts";
import { simulationOf } from "../../src/app/calculation/proof-delta.ts";
import { engine } from "../../src/app/calculation/engine.ts";
import type { Request } from "../../src/app/calculation/request.ts";
import { over } from "../../src/program/tools/read-tools.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";
import { report } from "../../src/report/report.ts";

/*
 * Edits of a work as a user makes them, and the law about them: what is calculated incrementally equals, to the byte,
 * what is calculated of the edited work alone.
 */

/** A work, in a state that an edit leaves. */
export interface EditedWork {
  readonly text: string;
  /** Program that the text can call. */
  readonly beside: string;
  /** Whether that program is there. */
  readonly hasBeside: boolean;
  /** Added to the nose radius of tool 1, mm. */
  readonly nose: number;
  /** A tool that is missing; 0: none. */
  readonly without: number;
  /** mm/min. */
  readonly rapid: number;
  readonly skipMarked: boolean;
}

const SUB = [
  "BEGIN PGM SUB MM",
  "Q2 = Q2 - 1",
  "LBL 1",
  "L X+Q2 Z+2 FMAX",
  "L Z-7 F0.2",
  "L IX+2 F0.3",
  "L Z+2 FMAX",
  "CALL LBL 1 REP1",
  "CYCL CALL",
  "END PGM SUB MM",
  "",
].join("\n");

/** A work with a text, before its first edit. */
export const unedited = (text: string): EditedWork => ({
  text,
  beside: SUB,
  hasBeside: true,
  nose: 0,
  without: 0,
  rapid: 10_000,
  skipMarked: false,
});

/** Kind of an edit, the place, and by how much. */
export type Edit = readonly [kind: string, which: number, by: number];

const pattern = (of: string) => new RegExp(String.raw`(?<=${of})\d+(?:\.\d+)?`, "g");
const NUMBERS = pattern("(?:Q\\d+=|[XZLD])[+-]?"),
  ELEMENTS = pattern("FL.* [XZ][+-]?");

/** Replaces what a pattern finds at one of its places. */
function replaced(
  text: string,
  places: RegExp,
  which: number,
  by: (found: string, all: readonly string[]) => string,
): string {
  const all = [...text.matchAll(places)];
  const place = all[which % Math.max(1, all.length)];
  if (!place) return text;
  const written = by(
    place[0],
    all.map(([found]) => found),
  );
  return text.slice(0, place.index) + written + text.slice(place.index + place[0].length);
}

const otherNumber = (by: number) => (found: string) => Math.abs(Number(found) + by).toFixed(3);
const otherDigit = (by: number) => (found: string) => String((Number(found) + (by < 0 ? 9 : 1)) % 10);
const otherWay = (jump: string) =>
  jump.startsWith("FN 9")
    ? jump.replace("FN 9", "FN 10").replace("EQU", "NE")
    : jump.replace("FN 10", "FN 9").replace(/NE$/, "EQU");

/** Lines that a user types, and that act on what follows. */
const TYPED = [
  "; a note",
  "L Z+3.217 F0.21",
  "L X+66 FMAX",
  "BLK FORM CYLINDER Z D77.3 L121 DIST+1",
  "CALL PGM SUB",
  "CYCL CALL",
  "CYCL DEF 812 SHOULDER, LONG. EXT. ~\n Q215=+1\nCYCL CALL",
  "CYCL DEF 811 SHOULDER, LONGITDNL. ~\n Q215=+1 ~\n Q493=+64\nCYCL CALL",
  "CALL LBL 90",
  "CALL LBL 93 REP2",
  "FN 9: IF +Q4 EQU +0 GOTO LBL 93",
  "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 IZ-2",
  "FUNCTION TURNDATA BLANK LBL 92",
  "FUNCTION TURNDATA CORR-TCS:Z/X DRS:0.3",
  "TOOL CALL 3",
  "/L X+71 Z+1 FMAX",
  "Q2 = Q2 - 1",
  "M136",
  "M30",
  "LBL 1",
  "LBL 0",
];

/** Blocks with all their lines. */
const blocksOf = (text: string): string[] => text.split(/(?<!~[ \t]*)\n/);

/** Changes the blocks; the frame of the program stays. */
function inBlocks(text: string, which: number, change: (all: string[], at: number) => void): string {
  const all = blocksOf(text);
  change(all, 2 + (which % Math.max(1, all.length - 4)));
  return all.join("\n");
}
/** Changes the lines, which may tear a cycle apart as half-typed text does. */
function inLines(text: string, which: number, change: (all: string[], at: number) => void): string {
  const all = text.split("\n");
  change(all, 2 + (which % Math.max(1, all.length - 4)));
  return all.join("\n");
}

const KINDS: Readonly<Record<string, (work: EditedWork, which: number, by: number) => Partial<EditedWork>>> = {
  number: ({ text }, which, by) => ({ text: replaced(text, NUMBERS, which, otherNumber(by)) }),
  element: ({ text }, which, by) => ({ text: replaced(text, ELEMENTS, which, otherNumber(by / 4)) }),
  digit: ({ text }, which, by) => ({ text: replaced(text, /(?<=\D)\d/g, which, otherDigit(by)) }),
  label: ({ text }, which, by) => ({
    text: replaced(
      text,
      /(?<=LBL )[1-9]\d*/g,
      which,
      (found, all) => all[Math.floor(Math.abs(by) * 97) % all.length] ?? found,
    ),
  }),
  way: ({ text }, which) => ({ text: replaced(text, /FN 9: IF \S+ EQU|FN 10: IF \S+ NE/g, which, otherWay) }),
  type: ({ text }, which, by) => ({
    text: inBlocks(text, which, (all, at) => {
      all.splice(at, 0, TYPED[Math.floor(Math.abs(by) * 97) % TYPED.length] ?? "");
    }),
  }),
  retype: ({ text }, which, by) => ({
    text: inBlocks(text, which, (all, at) => {
      all[at] = TYPED[Math.floor(Math.abs(by) * 97) % TYPED.length] ?? "";
    }),
  }),
  repeat: ({ text }, which, by) => ({
    text: inBlocks(text, which, (all, at) => {
      all.splice(at, 0, all[2 + (Math.floor(Math.abs(by) * 97) % Math.max(1, all.length - 4))] ?? "");
    }),
  }),
  move: ({ text }, which, by) => ({
    text: inBlocks(text, which, (all, at) => {
      const [taken = ""] = all.splice(at, 1);
      all.splice(2 + (Math.floor(Math.abs(by) * 97) % Math.max(1, all.length - 4)), 0, taken);
    }),
  }),
  drop: ({ text }, which) => ({ text: inBlocks(text, which, (all, at) => void all.splice(at, 1)) }),
  dropLine: ({ text }, which) => ({ text: inLines(text, which, (all, at) => void all.splice(at, 1)) }),
  mark: ({ text }, which) => ({
    text: inBlocks(text, which, (all, at) => {
      const block = all[at] ?? "";
      all[at] = block.startsWith("/") ? block.slice(1) : `/${block}`;
    }),
  }),
  end: ({ text }, _, by) => ({
    text: text.replace(/(?=\d* ?END PGM)/, `L X+${(Math.abs(by) * 20).toFixed(3)} Z-1.3 F0.2\n`),
  }),
  tool: (_, __, by) => ({ nose: Math.abs(by) / 9 }),
  without: ({ without }, which) => ({ without: without === 0 ? 1 + (which % 9) : 0 }),
  rapid: (_, which) => ({ rapid: 1000 + which }),
  skip: ({ skipMarked }) => ({ skipMarked: !skipMarked }),
  beside: ({ beside }, which, by) => ({ beside: replaced(beside, NUMBERS, which, otherNumber(by)) }),
  call: ({ beside }, which, by) => ({
    beside: inBlocks(beside, which, (all, at) => {
      all.splice(at, 0, TYPED[Math.floor(Math.abs(by) * 97) % TYPED.length] ?? "");
    }),
  }),
  lose: ({ hasBeside }) => ({ hasBeside: !hasBeside }),
};

/** Values change most. "again" changes the last place once more; "undo" and "redo" return to earlier states. */
const OFTEN = ["number", "number", "digit", "digit", "again", "again", "again", "undo", "undo", "redo", "type", "type"];

export const edits: fc.Arbitrary<Edit> = fc.tuple(
  fc.constantFrom(...OFTEN, ...Object.keys(KINDS)),
  fc.nat(9973),
  fc.integer({ min: -4000, max: 4000 }).map((n) => n / 913),
);

/** The states of a work, edit by edit; the first is the unedited one. */
function* statesOf(first: EditedWork, changes: readonly Edit[]): Generator<EditedWork> {
  const states = [first];
  let [at, last]: [number, Edit] = [0, ["number", 0, 1]];
  yield first;
  for (const change of changes) {
    const [kind, which, by] = change;
    if (kind === "undo" || kind === "redo") {
      at = kind === "undo" ? Math.max(0, at - 1 - (which % 3)) : Math.min(states.length - 1, at + 1);
    } else {
      last = kind === "again" ? [last[0], last[1], by] : change;
      const now = states[at] as EditedWork;
      states.splice(at + 1);
      states.push({ ...now, ...KINDS[last[0]]?.(now, last[1], last[2]) });
      at += 1;
    }
    yield states[at] as EditedWork;
  }
}

const NO_TIME = { parse: 0, plan: 0, simulate: 0 };
const reportOf = ({ run, simulation }: Outcome): string =>
  JSON.stringify(report({ file: "WORK.H", run, simulation, milliseconds: NO_TIME }, "en"));

function requestOf(
  { text, beside, hasBeside, nose, without, rapid, skipMarked }: EditedWork,
  version: number,
): Request {
  const tools = shippedTools
    .filter(({ T }) => T !== without)
    .map((tool) => (tool.T === 1 && "RS" in tool ? { ...tool, RS: (tool.RS + nose) as typeof tool.RS } : { ...tool }));
  const table = over({ tools, mills: [] }, { tools: [], refused: new Map() });
  const files = hasBeside ? [{ name: "SUB.H", text: beside }] : [];
  return { version, text, name: "WORK.H", files, skipMarked, table, rapid, control: "TNC 640" };
}

/**
 * Calculates a work after each edit as the page and its worker do, and alone. Returns the first difference: the number
 * of the edit, and the texts of both reports; null where there is none.
 */
export function brokenByEdit(
  first: EditedWork,
  changes: readonly Edit[],
): { readonly edit: number; readonly text: string; readonly kept: string; readonly alone: string } | null {
  const [page, worker] = [planner(), openWork()];
  let answered: Outcome | null = null;
  let version = 0;
  for (const state of statesOf(first, changes)) {
    version += 1;
    const request = requestOf(state, version);
    // The page plans in slices; some are dropped, since the next key comes first.
    let steps = changes[version - 1]?.[1] ?? 0;
    const sliced = page.part(request, () => (steps -= 7) > 0);
    const planned = sliced ?? page(request);
    const proof = worker.proved(request, answered?.version ?? null);
    const kept: Outcome = { ...planned, simulation: simulationOf(proof, planned.run, answered) };
    const alone = engine.update(request);
    answered = kept;
    const newest = worker.newest();
    const [made, fresh] = [reportOf(kept), reportOf(alone)];
    const isSame =
      made === fresh &&
      isDeepStrictEqual(kept.run, alone.run) &&
      isDeepStrictEqual(newest?.run, alone.run) &&
      isDeepStrictEqual(kept.simulation, alone.simulation);
    if (!isSame) return { edit: version - 1, text: state.text, kept: made, alone: fresh };
  }
  return null;
}
