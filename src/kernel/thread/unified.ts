import { INCH, rounded } from "../units.ts";
import { TRIANGLE } from "./metric.ts";
import type { SizeLimits, NamedThread, ThreadSide } from "./named-thread.ts";
import { isPlausible, type ThreadStandard } from "./standard.ts";
import { inchesIn, inchText, type TypedName } from "./typed-name.ts";

/** Diameter of number 0, and the step from one number to the next, inches. */
const [NUMBER_ZERO, NUMBER_STEP] = [0.06, 0.013];
const ofNumber = (n: number) => NUMBER_ZERO + NUMBER_STEP * n;

type Series = "UNC" | "UNF" | "UNEF" | "UN";

/** Size, and threads per inch of UNC, UNF and UNEF (ASME B1.1); 0 where the series has none. */
const SIZES: readonly (readonly [size: string, coarse: number, fine: number, extraFine: number])[] = [
  ["#0", 0, 80, 0],
  ["#1", 64, 72, 0],
  ["#2", 56, 64, 0],
  ["#3", 48, 56, 0],
  ["#4", 40, 48, 0],
  ["#5", 40, 44, 0],
  ["#6", 32, 40, 0],
  ["#8", 32, 36, 0],
  ["#10", 24, 32, 0],
  ["#12", 24, 28, 32],
  ["1/4", 20, 28, 32],
  ["5/16", 18, 24, 32],
  ["3/8", 16, 24, 32],
  ["7/16", 14, 20, 28],
  ["1/2", 13, 20, 28],
  ["9/16", 12, 18, 24],
  ["5/8", 11, 18, 24],
  ["11/16", 0, 0, 24],
  ["3/4", 10, 16, 20],
  ["13/16", 0, 0, 20],
  ["7/8", 9, 14, 20],
  ["15/16", 0, 0, 20],
  ["1", 8, 12, 20],
  ["1 1/16", 0, 0, 18],
  ["1 1/8", 7, 12, 18],
  ["1 3/16", 0, 0, 18],
  ["1 1/4", 7, 12, 18],
  ["1 5/16", 0, 0, 18],
  ["1 3/8", 6, 12, 18],
  ["1 7/16", 0, 0, 18],
  ["1 1/2", 6, 12, 18],
  ["1 9/16", 0, 0, 18],
  ["1 5/8", 0, 0, 18],
  ["1 11/16", 0, 0, 18],
  ["1 3/4", 5, 0, 0],
  ["2", 4.5, 0, 0],
  ["2 1/4", 4.5, 0, 0],
  ["2 1/2", 4, 0, 0],
  ["2 3/4", 4, 0, 0],
  ["3", 4, 0, 0],
  ["3 1/4", 4, 0, 0],
  ["3 1/2", 4, 0, 0],
  ["3 3/4", 4, 0, 0],
  ["4", 4, 0, 0],
];
const SERIES: readonly Series[] = ["UNC", "UNF", "UNEF"];
const inSeries = (row: (typeof SIZES)[number]) =>
  SERIES.flatMap((series, i) => ((row[i + 1] as number) > 0 ? [{ series, perInch: row[i + 1] as number }] : []));

/** Finest thread, per inch; from 24 on a bare whole number is a number size: no inch size has so fine a thread. */
const [FINEST, FINE] = [80, 24];

/** Series before or behind, size, threads per inch: 1/4-20 UNC, UNC 1/4, #10-32, No. 10 UNF, 1 1/2-12 UN. */
const NAME =
  /^(un[cfsrej]*)? ?(#|no\.? ?|nr\.? ?|n° ?)?(\d+ \d+\/\d+|\d+-\d+\/\d+|\d+\/\d+|\d+\.\d+|\.\d+|\d+)(?:[-x ](\d+(?:\.\d+)?))? ?(un[cfsrej]*)?$/;

/** Pitch tolerance of class 2A, inches (ASME B1.1, 5.8.1): with the length of engagement. */
const pitch2A = (d: number, p: number, engagement: number) =>
  0.0015 * Math.cbrt(d) + 0.0015 * Math.sqrt(engagement) + 0.015 * p ** (2 / 3);
/** Share of that tolerance in each class, and of the major tolerance. */
const OF_2A = { "1A": 1.5, "2A": 1, "3A": 0.75, "1B": 1.95, "2B": 1.3, "3B": 0.975 } as const;
type UnifiedClass = keyof typeof OF_2A;

/** Tolerance of the minor diameter of an internal thread of classes 1B and 2B, inches. */
function minorTolerance(d: number, p: number): number {
  const usual = 0.25 * p - 0.4 * p * p;
  if (d >= 0.25) return p > 0.25 ? 0.15 * p : usual;
  return Math.min(0.394 * p, Math.max(usual, 0.05 * p ** (2 / 3) + (0.03 * p) / d - 0.002));
}

/** Four decimals of an inch, as the tables. */
const tenths = (inches: number) => Math.round(inches * 1e4) / 1e4;
const mm = (inches: number) => rounded(inches * INCH);

/** Sizes from number 6 on state the minor diameter of internal threads to a thousandth. */
const THOUSANDTHS = 0.138;

/** Basic sizes and limits; outside, the standard rounds allowance and tolerance before it subtracts them. */
function sideOf(name: UnifiedClass, d: number, p: number, engagement: number): ThreadSide {
  const tolerance = pitch2A(d, p, engagement);
  const [flank, minor] = [d - 0.75 * TRIANGLE * p, d - 1.25 * TRIANGLE * p];
  const [major, pitch] = [tenths(d), tenths(flank)];
  const onPitch = tolerance * OF_2A[name];
  if (name.endsWith("B")) {
    const places = d >= THOUSANDTHS ? (n: number) => Math.round(n * 1e3) / 1e3 : tenths;
    return {
      crest: mm(minor),
      pitch: mm(pitch),
      root: mm(d),
      tolerance: {
        name,
        crest: [mm(places(minor)), mm(places(minor + minorTolerance(d, p)))],
        pitch: [mm(pitch), mm(tenths(flank + onPitch))],
      },
    };
  }
  const allowance = name === "3A" ? 0 : tenths(0.3 * tolerance);
  const onMajor = tenths((name === "1A" ? 0.09 : 0.06) * p ** (2 / 3));
  const limits = (size: number, by: number): SizeLimits => [mm(size - allowance - by), mm(size - allowance)];
  return {
    crest: mm(d),
    pitch: mm(pitch),
    // Rounded root of the UNR profile, 11/16 H below the crest.
    root: mm(d - 1.375 * TRIANGLE * p),
    tolerance: { name, crest: limits(major, onMajor), pitch: limits(pitch, tenths(onPitch)) },
  };
}

const isClass = (name: string | undefined): name is UnifiedClass => name !== undefined && name in OF_2A;

function unifiedThread(
  d: number,
  label: string,
  perInch: number,
  series: Series,
  typed: TypedName,
): NamedThread | null {
  const p = 1 / perInch;
  const row = SIZES.find(([size]) => size === label);
  const fitting = row ? inSeries(row).find((each) => each.perInch === perInch) : undefined;
  if ((typed.outside && !isClass(typed.outside)) || (typed.inside && !isClass(typed.inside))) return null;
  // Engagement of one diameter in the coarse and fine series, of nine pitches in the others.
  const engagement = (fitting?.series ?? series) === "UNC" || fitting?.series === "UNF" ? d : 9 * p;
  return {
    standard: "unified",
    name: `${label}-${perInch} ${fitting?.series ?? "UN"}`,
    listed: fitting !== undefined,
    nominal: mm(d),
    pitch: INCH / perInch,
    perInch,
    starts: 1,
    leftHand: typed.leftHand,
    angle: 60,
    taper: 0,
    outside: sideOf(isClass(typed.outside) ? typed.outside : "2A", d, p, engagement),
    inside: sideOf(isClass(typed.inside) ? typed.inside : "2B", d, p, engagement),
    side: typed.outside ? "outside" : typed.inside ? "inside" : null,
  };
}

/** Unified threads: UNC, UNF, UNEF and any other diameter and pitch as UN. */
export const unified: ThreadStandard = {
  id: "unified",
  documents: "ASME B1.1",
  evidence: "K1",
  names: SERIES.flatMap((_, i) =>
    SIZES.flatMap((row) => {
      const perInch = row[i + 1] as number;
      return perInch > 0 ? [`${row[0]}-${perInch} ${SERIES[i]}`] : [];
    }),
  ),
  read(typed) {
    const m = NAME.exec(typed.size);
    if (!m) return null;
    const [, before, mark, text = "", threads, behind] = m;
    const said = (before ?? behind)?.toUpperCase().replace("R", "");
    const isBareNumber = mark === undefined && /^\d+$/.test(text) && Number(threads) >= FINE;
    const number = mark !== undefined || isBareNumber ? Number(text) : null;
    if (number !== null && !(Number.isInteger(number) && number <= 12)) return null;
    const d = number === null ? inchesIn(text) : ofNumber(number);
    const label = number === null ? inchText(d) : `#${number}`;
    const series = SERIES.find((each) => each === said) ?? "UN";
    const row = SIZES.find(([size]) => size === label);
    const perInch =
      threads === undefined ? row && inSeries(row).find((each) => each.series === series)?.perInch : Number(threads);
    if (said === undefined && threads === undefined) return null;
    if (!perInch || perInch > FINEST || !isPlausible(INCH * d, INCH / perInch)) return null;
    return unifiedThread(d, label, perInch, series, typed);
  },
};
