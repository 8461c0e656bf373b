import fc from "fast-check";
import { describe, expect, test } from "vitest";
import { texts } from "../src/i18n/index.ts";
import { LANGUAGES } from "../src/i18n/languages.ts";
import { lengthsIn } from "../src/i18n/lengths.ts";
import { message } from "../src/i18n/message.ts";
import type { AnyCode, AnyIssue } from "../src/i18n/message-texts.ts";
import { formatFixed, formatNumber, formatPosition, formatSigned } from "../src/i18n/number.ts";
import { sources } from "./sources.ts";

type DataOf<C extends AnyCode> = Extract<AnyIssue, { code: C }>["data"];

/** One sample of every code; the compiler requires one for a new code. */
const SAMPLES: { readonly [C in AnyCode]: DataOf<C> } = {
  missing: {},
  pitchZero: {},
  depthOfOtherProfile: { depth: 1.113, pitch: 1.814, factor: 0.613, angle: 55, right: 0.64, nearest: 1.162 },
  toothAssumed: { height: 2.5 },
  threadSurfaceSpeed: { cuttingSpeed: 150, slow: 1200, fast: 2500 },
  threadOverruns: { meets: "shaft", area: 1.5, x: 18.77, z: -27.4, axis: "Z", end: -25, to: -27 },
  crestMissing: { missing: 0.6, diameter: 20 },
  pitchNotListed: { element: 4, pitch: 1.5875, below: 1.5, above: 1.75, words: "DEPTH BREADTH" },
  depthFromPitch: { depth: 0.92, pitch: 1.5, factor: 0.613 },
  threadOverInsert: { depth: 5.25, most: 4.33 },
  threadTooSteep: { angle: 62.5, most: 60 },
  threadMeets: { place: "behind", over: 20.5, x: 100.5, z: -35.25, most: 8.75 },
  flankInfeedTooSteep: { angle: 45.5, most: 27.5, nearest: 27.5 },
  runOutTooLong: { size: 30.5, max: 25.1, nearest: 25.1 },
  threadTurnsBack: { axis: "X" },
  runInBlocked: { x: 60.5, z: -5.5, nearest: 7.25 },
  threadTooMany: { turns: 250000, most: 100000 },
  taperImpossible: { angle: 0.5 },
  threadFeedOverLimit: { feed: 12000, most: 10000, speed: 3000, upTo: 2500 },
  runInShort: { runIn: 2.5, needed: 7.5, speed: 2000, nearest: 7.5 },
  notANumber: { text: "abc" },
  badExpression: { text: "75/" },
  unknownParameter: { name: "Q7" },
  outOfRange: { value: 1000.5, min: 0.001, max: 999.999, nearest: 999.999 },
  notWhole: { value: 1.5, nearest: 2 },
  notAChoice: { value: 7, choices: [0, 1], nearest: 1 },
  startEqualsEnd: { other: "Q493", value: 50.5 },
  startLevelWithEnd: { axis: "X", value: 50.5 },
  diameterNegative: { value: -75.5, nearest: 75.5 },
  contourFlat: { axis: "X" },
  elementTooLong: { size: 30.5, max: 25.1 },
  cornersTooWide: { radius: 8.5, max: 6.25 },
  wallsMeet: { angle: 40.5, max: 22.6199 },
  cornerSmallerThanInsert: { radius: 0.4, insert: 0.8 },
  recessNarrowerThanTool: { width: 2.5, tool: 3.1, nearest: 68.8 },
  angleNotFollowed: { angle: 40.5, max: 32.25, edge: "secondaryEdge" },
  infeedOverCutLength: { infeed: 15.5, cutLength: 12.1, nearest: 12.1 },
  depthOverCutLength: { depth: 40.5, cutLength: 35.1 },
  offsetReduced: { offset: 0.5, kept: 0.148, nearest: 0.148, passes: 14 },
  offsetOverLimit: { offset: 2.5, max: 2.08, passes: 1, nearest: 0.148 },
  toolUnfit: { type: "THREAD", orientation: 3, types: ["ROUGH", "FINISH"], orientations: [1, 2] },
  tooManyPasses: { passes: 25000, most: 2000, nearest: 0.013 },
  toolCannotCutSideways: { type: "RECESS" },
  flanksNotChecked: {},
  toolColumn: { column: "P-ANGLE", value: 85.5, max: 84.5 },
  toolNumberTwice: { number: 7, nearest: 16 },
  toolName: { text: "Groß!", max: 32 },
  holderAxis: { text: "Y" },
  holderHead: { text: "1/2 3/4" },
  betterTool: { tool: 15, name: "FACE-DNMG-55-R08" },
  contourEndCovered: { x: 81.5, z: -5.5 },
  startInArea: { x: 60.5, z: -5.5 },
  startInMaterial: { x: 60.5, z: -5.5 },
  startBelowContour: { below: 5.25 },
  startBehindContour: { behind: 12.25, clearance: 2.5 },
  startOnWrongSide: { x: 16.5, z: 2.5 },
  startInPart: { x: 79.5, z: 2.5 },
  boreMissing: { z: -32, to: -40, need: 26 },
  insertAcrossAxis: { reach: 12.345, nearest: 20.5 },
  startInsideEnvelope: { clearance: 2.5 },
  limitOnWrongSide: { limit: 10.5, nearest: 20.5 },
  cutBehindLimit: { area: 3.97, x: 51.25, z: -7.5, finishing: true },
  nothingToCut: {},
  contourMissing: { label: "2" },
  contourTooShort: {},
  contourPoint: { element: 3 },
  cornerElementAlone: { element: 3 },
  cornerElementTooLong: { element: 3, size: 9.5, max: 4.25 },
  arcOffCircle: { element: 3, gap: 0.5 },
  arcTooSmall: { element: 3, radius: 2.5 },
  contourCrossesItself: { element: 3, other: 1 },
  undercutNeighbours: { element: 3 },
  recessWord: { element: 3, word: "BREADTH" },
  recessWordsExclusive: { element: 3, word: "ANG_WIDTH", other: "ANGLE" },
  undercutDefaults: { element: 3, words: "R0.6 DEPTH0.3" },
  centreMissing: { element: 3 },
  elementFree: { element: 3, freedom: 2 },
  elementContradicts: { element: 3, quantity: "angle", given: 45, nearest: 30.5 },
  elementUnreachable: { element: 3 },
  materialLeft: { reason: "mainEdge", area: 1.25, x: 60.5, z: -5.5 },
  gouge: { area: 1.25, x: 60.5, z: -5.5 },
  contactsUnlooked: { limit: 750 },
  rapidInStock: { area: 1.25, x: 60.5, z: -5.5 },
  holderContact: { x: 60.5, z: -5.5 },
  cutBelowContour: { block: 9, area: 1.25, x: 60.5, z: -5.5 },
  intendedCut: { blocks: [9, 14], area: 1.25, x: 60.5, z: -5.5 },
  cameLoose: { shape: "ring", area: 1.25, block: 9, x: 60.5, z: -5.5 },
  partedOff: { area: 125.5, block: 9, x: 60.5, z: -5.5 },
  cutOnLoosePiece: { area: 1.25, block: 9, x: 60.5, z: -5.5 },
  behindBlank: { motion: "rapid", x: 60.5, z: -105.5, rear: -100 },
  clampContact: { part: "jaws", by: "holder", x: 60.5, z: -75.5 },
  deeperThanInfeed: { depth: 11.8, allowed: 2.5, pass: 3 },
  nothingCut: {},
  blankLacks: { what: "FUNCTION TURNDATA BLANK LBL 20", area: 12.5 },
  blankGone: { what: "FUNCTION TURNDATA BLANK LBL 20", area: 12.5 },
  airPasses: { count: 4 },
  notUnderstood: { text: "UDC TYPE_Z" },
  wordNotUnderstood: { text: "B12" },
  wordTwice: { word: "X" },
  equalsMissing: { text: "Q493+50" },
  blankBeforeEquals: { text: "Q499 =+0" },
  lineTooLong: { most: 2000 },
  badNumber: { text: "1.2.3" },
  wordMissing: { word: "R" },
  blockNumber: { found: 9, expected: 7 },
  blockNumberMissing: { expected: 7 },
  continuationOpen: {},
  isoProgram: {},
  listWithoutTilde: { places: 3 },
  frameMissing: { which: "END PGM" },
  notSimulated: { what: "M140" },
  notProved: { what: "M91" },
  cycleNotSimulated: { cycle: 200, name: "DRILLING" },
  noCycleDefined: {},
  noToolCalled: {},
  toolUnknown: { tool: "99" },
  compensationActive: { side: "RL" },
  feedZero: { word: "FAUTO" },
  drillTooShort: { depth: 52.5, edges: 43 },
  centreMouth: { mouth: 6.7, wanted: 8.5, depth: 8.897 },
  pitchOfTap: { pitch: 1.25, tap: 1.5 },
  freeChosen: {},
  freeUnsolved: { form: "FCT" },
  feedUnlikely: { feed: 0.3, unit: "mm/min" },
  cycleNeverCalled: { cycle: 812 },
  neverReached: { by: "M30" },
  parameterForeign: { name: "Q999", cycle: 812 },
  listOfOlderSoftware: { cycle: 862, filled: ["Q510=0.8", "Q462=0"] },
  runsIntoLabel: { label: "2" },
  contourStartIncomplete: { axis: "Z" },
  approachUncompensated: { form: "APPR LT" },
  notInTurnMode: {},
  labelMissing: { label: "2" },
  labelTwice: { label: "2" },
  labelNotClosed: { label: "2" },
  contourNotNamed: { cycle: 820 },
  contourInFile: { file: "PART.H" },
  feedMissing: {},
  spindleMissing: {},
  spindleStopped: { how: "stopped", block: 12 },
  toolLimit: { tool: 8, column: "DMIN", value: 20, limit: 24, x: 20, z: -1 },
  straightBlade: {},
  bladeSupport: { text: "ROUND" },
  pointDiffers: { length: 4, byAngle: 2.5, angle: 118 },
  pointBeyondDepth: { point: 2.5, depth: 2 },
  holeMissing: { tool: 7, diameter: 6.8, z: -25.5 },
  speedUnlimited: { diameter: 1.6, block: 14 },
  speedUnlikely: { speed: 1200, most: 800, of: "material" },
  offCentre: { y: 5.5 },
  toolIndexUnknown: { tool: "1.1", rows: ["1", "1.2"] },
  firstElement: { word: "CR" },
  controlRule: { rule: "signOfAngle", word: "IPA+90 DR-" },
  parameterUnset: { name: "Q7" },
  divisionByZero: {},
  notFinite: { text: "SQRT -1" },
  clampingUnread: { what: "FORCE 40" },
  clampingIncomplete: { words: "LENGTH, FACE" },
  clampingTwice: {},
  clampingMisses: { diameter: 60.5 },
  blankMissing: {},
  blankNotTurned: { form: "0.1" },
  blankImpossible: {},
  endInFront: { value: 55.5, nearest: -55.5 },
  diameterOutside: { value: 96.5, blank: 60.5 },
  diameterInSolid: { value: 20.5 },
  startInFront: { value: 55.5, nearest: -55.5 },
  endsExchanged: { axis: "X", start: 50.5, end: 75.5, other: "Q493" },
  blankAgainstContour: { place: "outside", contour: 75.5, blank: 60, nearest: 75.5 },
  boxTurned: { outer: 113.137, inner: 80 },
  blankTaken: { what: "FUNCTION TURNDATA BLANK LBL 20" },
  blankAdds: { what: "FUNCTION TURNDATA BLANK LBL 20", area: 12.5 },
  blankTraced: {},
  poleMissing: {},
  startUnknown: {},
  arcImpossible: {},
  radiusCompensation: { side: "RL" },
  toolRadiusTooLarge: { element: 3, radius: 10.5, nearest: 4.25 },
  pathCutsContour: { element: 2, other: 5, depth: 1.25, x: 60.5, y: 5.5, nearest: 4.25 },
  approachNeedsSide: {},
  approachSideAssumed: {},
  approachInsideCircle: { point: "PS", radius: 10.5, nearest: 4.25 },
  approachCutsContour: { point: "PS", depth: 1.25, x: 60.5, y: 5.5, freeX: -7.5, freeY: 8.25 },
  approachValueCutsContour: { point: "PN", depth: 1.25, x: 60.5, z: -5.5, word: "LEN", nearest: 12.5 },
  approachBlocked: { point: "PS", depth: 1.25, x: 60.5, y: 5.5 },
  compensationUndefined: { side: "RL", orientation: 2 },
  sideChanged: {},
  approachWithoutContour: { form: "APPR LT" },
  lengthDelta: { tool: 3 },
  toolRadiusUnknown: { tool: "1" },
  wordsRecalled: { what: "UDC TYPE_F" },
  programEndMissing: {},
  tooManyBlocks: { limit: 1000 },
  tooManyRepeated: { limit: 1000 },
  tooManyMoves: { limit: 1000 },
  contourTooLong: { limit: 500 },
  tooManyOperations: { limit: 500 },
  moreAlike: { code: "gouge", count: 37 },
  callsTooDeep: { limit: 20 },
  programsTooDeep: { limit: 19 },
  endInCalled: { word: "M30" },
  programNotOpened: { file: "DRILL.H" },
  programNotSelected: {},
  contoursJoined: { cycle: 820, joined: "( QC1 | QC2 ) \\ QC3" },
  errorRaised: { error: 1037 },
};
const found = (code: AnyCode): AnyIssue => ({ code, severity: "error", data: SAMPLES[code] }) as AnyIssue;
const codes = Object.keys(SAMPLES) as AnyCode[];

describe.each(LANGUAGES)("messages in %s", (language) => {
  test.each(codes)("%s is a whole sentence with its data", (code) => {
    const sentence = message(language, found(code));
    expect(sentence).toMatch(/\S.*[.。?？]$/);
    expect(sentence).not.toMatch(/undefined|NaN|\[object|null/);
    const own = Object.entries(SAMPLES[code]).filter(
      ([key, value]) =>
        ![
          "reason",
          "edge",
          "quantity",
          "place",
          "shape",
          "motion",
          "meets",
          "part",
          "by",
          "how",
          "of",
          "rule",
        ].includes(key) && typeof value !== "boolean",
    );
    const shown = own.map(([, value]) =>
      typeof value === "number" ? formatNumber(language, value, 4) : String(value),
    );
    for (const data of shown.filter((text) => !text.includes(","))) expect(sentence).toContain(data);
    if ("nearest" in SAMPLES[code])
      expect(sentence).toContain(formatNumber(language, (SAMPLES[code] as { nearest: number }).nearest, 4));
  });

  test("a diameter carries its sign, an angle its degrees", () => {
    expect(message(language, found("outOfRange"), "diameter")).toContain(`⌀${formatNumber(language, 999.999)}`);
    expect(message(language, found("outOfRange"), "angle")).toContain(`${formatNumber(language, 999.999)}°`);
    expect(message(language, found("outOfRange"), "radial")).not.toContain("⌀");
    expect(message(language, found("gouge"))).toContain(
      `X⌀${formatNumber(language, 60.5)} Z${formatNumber(language, -5.5)}`,
    );
  });

  test("a limit is not rounded past itself", () => {
    const found: AnyIssue = {
      code: "outOfRange",
      severity: "error",
      data: { value: 10, min: -9.9999, max: 9.9999, nearest: 9.9999 },
    };
    expect(message(language, found, "axial")).toContain(formatNumber(language, 9.9999, 4));
  });

  test("no sentence of an inch program speaks of millimetres", () => {
    const inch = lengthsIn(language, "inch", 25.4);
    const perRevolution: AnyIssue = { code: "feedUnlikely", severity: "warning", data: { feed: 50.8, unit: "mm/rev" } };
    for (const each of [...codes.map(found), perRevolution]) expect(message(inch, each)).not.toMatch(/\bmm\b|毫米/);
    expect(message(inch, perRevolution)).toMatch(/\b2\u00a0inch\//);
  });

  test("a long quotation is cut short", () => {
    expect(
      message(language, { code: "notANumber", severity: "error", data: { text: "x".repeat(5000) } }).length,
    ).toBeLessThan(120);
  });
});

test("the running step reads as a status line", () => {
  const { cycles } = texts("en");
  expect(cycles.roughStep(3, 6, cycles.of[812].rough[2] ?? "")).toBe("Step 3 of 6: retract by the infeed");
});

describe("numbers of a language", () => {
  test.each([
    ["en", 25.4, "25.4"],
    ["de", 25.4, "25,4"],
    ["fr", -0.5, "-0,5"],
    ["zh", 1000, "1000"],
    ["en", 0.0004, "0"],
    ["de", -0.0001, "0"],
    ["en", 100, "100"],
    ["en", NaN, "–"],
    ["fr", Infinity, "–"],
  ] as const)("%s writes %d as %s", (language, value, text) => expect(formatNumber(language, value)).toBe(text));

  test("positions keep sign and decimals, as the control shows them", () => {
    expect(formatPosition("en", 25.4)).toBe("+25.400");
    expect(formatPosition("de", -25.4)).toBe("-25,400");
    expect(formatPosition("en", -0.0001)).toBe("+0.000");
    expect(formatSigned("fr", 0.5)).toBe("+0,5");
    expect(formatSigned("en", 0)).toBe("+0");
    expect(formatFixed("de", 1.25, 1)).toMatch(/^1,[23]$/);
  });

  test("law: a written number reads back within its decimals", () => {
    fc.assert(
      fc.property(
        fc.double({ min: -1e6, max: 1e6, noNaN: true }),
        fc.constantFrom(...LANGUAGES),
        (value, language) => Math.abs(Number(formatNumber(language, value).replace(",", ".")) - value) <= 0.0005 + 1e-9,
      ),
      { numRuns: 2000 },
    );
  });
});

/** A text that is never shown would still be translated three times. */
test("every text of the screen has a name that something else in the tree says", () => {
  const isText = (path: string) => /^src\/i18n\/\w+\//.test(path);
  const all = sources("src");
  const said = new Set(
    all.filter(({ path }) => !isText(path)).flatMap(({ text }) => text.match(/[A-Za-z_]\w*/g) ?? []),
  );
  const english = all.filter(({ path }) => path.startsWith("src/i18n/en/") && !path.endsWith(".test.ts"));
  const names = english.flatMap(({ path, text }) =>
    [...text.matchAll(/^\s*([A-Za-z_]\w*):/gm)].map(([, name = ""]) => [path, name] as const),
  );
  expect(names.length).toBeGreaterThan(1000);
  expect(
    names.filter(([, name]) => !/^M\d+$/.test(name) && !said.has(name)).map(([path, name]) => `${path}: ${name}`),
  ).toEqual([]);
});
