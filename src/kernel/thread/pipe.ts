import { INCH, rounded } from "../units.ts";
import type { NamedThread, ThreadSide } from "./named-thread.ts";
import type { ThreadStandard } from "./standard.ts";
import { inchesIn, inchText, type TypedName } from "./typed-name.ts";
import { WHITWORTH } from "./profiles.ts";

/** Size in inches, major diameter, threads per inch (ISO 228-1; of those ISO 7-1 has the ones with a gauge length). */
const SIZES: readonly (readonly [inches: string, diameter: number, perInch: keyof typeof BY_PITCH])[] = [
  ["1/16", 7.723, 28],
  ["1/8", 9.728, 28],
  ["1/4", 13.157, 19],
  ["3/8", 16.662, 19],
  ["1/2", 20.955, 14],
  ["5/8", 22.911, 14],
  ["3/4", 26.441, 14],
  ["7/8", 30.201, 14],
  ["1", 33.249, 11],
  ["1 1/8", 37.897, 11],
  ["1 1/4", 41.91, 11],
  ["1 1/2", 47.803, 11],
  ["1 3/4", 53.746, 11],
  ["2", 59.614, 11],
  ["2 1/4", 65.71, 11],
  ["2 1/2", 75.184, 11],
  ["2 3/4", 81.534, 11],
  ["3", 87.884, 11],
  ["3 1/2", 100.33, 11],
  ["4", 113.03, 11],
  ["4 1/2", 125.73, 11],
  ["5", 138.43, 11],
  ["5 1/2", 151.13, 11],
  ["6", 163.83, 11],
];

/** Pitch and depth as the standard rounds them, and tolerances of the pitch, minor and major diameter (ISO 228-1), mm. */
const BY_PITCH = {
  28: { pitch: 0.907, depth: 0.581, T: 0.107, minor: 0.282, major: 0.214 },
  19: { pitch: 1.337, depth: 0.856, T: 0.125, minor: 0.445, major: 0.25 },
  14: { pitch: 1.814, depth: 1.162, T: 0.142, minor: 0.541, major: 0.284 },
  11: { pitch: 2.309, depth: 1.479, T: 0.18, minor: 0.64, major: 0.36 },
} as const;
/** Larger than G 2, the pitch tolerance is wider, mm. */
const [LARGE, WIDE] = [60, 0.217] as const;

/** Gauge length and useful thread length outside, mm (ISO 7-1). */
const TAPER: Readonly<Record<string, readonly [gauge: number, useful: number]>> = {
  "1/16": [4, 6.5],
  "1/8": [4, 6.5],
  "1/4": [6, 9.7],
  "3/8": [6.4, 10.1],
  "1/2": [8.2, 13.2],
  "3/4": [9.5, 14.5],
  "1": [10.4, 16.8],
  "1 1/4": [12.7, 19.1],
  "1 1/2": [12.7, 19.1],
  "2": [15.9, 23.4],
  "2 1/2": [17.5, 26.7],
  "3": [20.6, 29.8],
  "4": [25.4, 35.8],
  "5": [28.6, 40.1],
  "6": [28.6, 40.1],
};
/** Change of the diameter per length of a taper pipe thread. */
export const TAPER_1_16 = 1 / 16;

/** The size of a table for typed inches. */
function sizeOf(text: string): (typeof SIZES)[number] | undefined {
  const label = inchText(inchesIn(text));
  return SIZES.find(([inches]) => inches === label);
}

function basicOf([, diameter, perInch]: (typeof SIZES)[number]) {
  const { depth } = BY_PITCH[perInch];
  const pitch = rounded(diameter - depth);
  return { major: diameter, pitch, minor: rounded(pitch - depth) };
}

const factsOf = (size: (typeof SIZES)[number], typed: TypedName) => {
  const { pitch } = BY_PITCH[size[2]];
  return {
    listed: true,
    nominal: size[1],
    pitch,
    perInch: size[2],
    starts: 1,
    leftHand: typed.leftHand,
    angle: WHITWORTH.angle,
  } satisfies Partial<NamedThread>;
};

/** G 1/2, G1/2A, BSPP 1/2, 1/2 BSP; the letter behind is the class. */
const PARALLEL = /^(?:(?:g|bspp?|bspf|pf) ?([\d ./-]+?)|([\d ./-]+?) ?(?:g|bspp?|bspf))(?:[ -]?([ab]))?$/;

/** Parallel pipe threads that do not seal. */
export const pipe: ThreadStandard = {
  id: "pipe",
  documents: "ISO 228-1",
  evidence: "L",
  names: SIZES.map(([inches]) => `G${inches}`),
  read(typed) {
    const m = PARALLEL.exec(typed.size);
    const size = m && sizeOf(m[1] ?? m[2] ?? "");
    if (!m || !size || typed.outside || typed.inside) return null;
    const [inches, diameter, perInch] = size;
    const { T: usual, minor, major } = BY_PITCH[perInch];
    const T = diameter > LARGE ? WIDE : usual;
    const onMajor = diameter > LARGE ? WIDE + WIDE : major;
    const basic = basicOf(size);
    const name = m[3] === "b" ? "B" : "A";
    const wide = name === "B" ? T + T : T;
    return {
      ...factsOf(size, typed),
      standard: "pipe",
      name: `G${inches}`,
      taper: 0,
      outside: {
        crest: basic.major,
        pitch: basic.pitch,
        root: basic.minor,
        tolerance: {
          name,
          crest: [rounded(basic.major - onMajor), basic.major],
          pitch: [rounded(basic.pitch - wide), basic.pitch],
        },
      },
      inside: {
        crest: basic.minor,
        pitch: basic.pitch,
        root: basic.major,
        tolerance: {
          // The standard has one class inside, without a letter.
          name: "",
          crest: [basic.minor, rounded(basic.minor + minor)],
          pitch: [basic.pitch, rounded(basic.pitch + T)],
        },
      },
      side: m[3] === undefined ? null : "outside",
    };
  },
};

/** R 1/2, Rc 1/2, Rp 1/2, BSPT 1/2. */
const SEALING = /^(?:(r|rc|rp|bspt|pt) ?([\d ./-]+)|([\d ./-]+?) ?(bspt))$/;

/** Pipe threads that seal: taper outside (R), taper or parallel inside (Rc, Rp). */
export const taperPipe: ThreadStandard = {
  id: "taperPipe",
  documents: "ISO 7-1 (EN 10226)",
  evidence: "K1",
  names: ["R", "Rc", "Rp"].flatMap((symbol) => Object.keys(TAPER).map((inches) => `${symbol}${inches}`)),
  read(typed) {
    const m = SEALING.exec(typed.size);
    const size = m && sizeOf(m[2] ?? m[3] ?? "");
    const taper = size && TAPER[size[0]];
    if (!m || !size || !taper || typed.outside || typed.inside) return null;
    const basic = basicOf(size);
    const [length, useful] = taper;
    const symbol = m[1] === "rc" ? "Rc" : m[1] === "rp" ? "Rp" : "R";
    const isParallel = symbol === "Rp";
    return {
      ...factsOf(size, typed),
      standard: "taperPipe",
      name: `${symbol}${size[0]}`,
      taper: isParallel ? 0 : TAPER_1_16,
      ...(!isParallel && { gauge: { length, useful, usefulInside: useful } }),
      outside: isParallel ? null : { crest: basic.major, pitch: basic.pitch, root: basic.minor },
      inside: { crest: basic.minor, pitch: basic.pitch, root: basic.major },
      side: symbol === "R" ? (m[1] === "r" ? "outside" : null) : "inside",
    };
  },
};

/** Size in inches, outside diameter of the pipe, threads per inch, hand-tight engagement L1 (ASME B1.20.1), inches. */
const NPT: readonly (readonly [inches: string, D: number, perInch: number, L1: number])[] = [
  ["1/16", 0.3125, 27, 0.16],
  ["1/8", 0.405, 27, 0.1615],
  ["1/4", 0.54, 18, 0.2278],
  ["3/8", 0.675, 18, 0.24],
  ["1/2", 0.84, 14, 0.32],
  ["3/4", 1.05, 14, 0.339],
  ["1", 1.315, 11.5, 0.4],
  ["1 1/4", 1.66, 11.5, 0.42],
  ["1 1/2", 1.9, 11.5, 0.42],
  ["2", 2.375, 11.5, 0.436],
  ["2 1/2", 2.875, 8, 0.682],
  ["3", 3.5, 8, 0.766],
  ["3 1/2", 4, 8, 0.821],
  ["4", 4.5, 8, 0.844],
  ["5", 5.563, 8, 0.937],
  ["6", 6.625, 8, 0.958],
];
/** Height of the truncated profile in pitches. */
const NPT_HEIGHT = 0.8;
/** Threads of wrench make-up behind the hand-tight engagement of an internal thread. */
const MAKE_UP = 3;
const NPT_NAME =
  /^(?:npt ?([\d ./]+|\d+-\d+\/\d+)(?:-(\d+(?:\.\d+)?))?|([\d ./]+|\d+-\d+\/\d+)(?:-(\d+(?:\.\d+)?))? ?npt)$/;
const mm = (inches: number) => rounded(inches * INCH);

/** American taper pipe thread, 60°. NPTF has other truncations, which we could not compare: it is not read. */
export const npt: ThreadStandard = {
  id: "npt",
  documents: "ASME B1.20.1",
  evidence: "K1",
  names: NPT.map(([inches, , perInch]) => `${inches}-${perInch} NPT`),
  read(typed) {
    const m = NPT_NAME.exec(typed.size);
    const label = m && inchText(inchesIn(m[1] ?? m[3] ?? ""));
    const row = NPT.find(([inches]) => inches === label);
    const said = m?.[2] ?? m?.[4];
    if (!m || !row || typed.outside || typed.inside || (said !== undefined && Number(said) !== row[2])) return null;
    const [inches, D, perInch, L1] = row;
    const p = 1 / perInch;
    const small = D - (0.05 * D + 1.1) * p;
    const gauge = small + L1 * TAPER_1_16;
    const h = NPT_HEIGHT * p;
    const side = (crest: number, root: number): ThreadSide => ({ crest: mm(crest), pitch: mm(gauge), root: mm(root) });
    return {
      standard: "npt",
      name: `${inches}-${perInch} NPT`,
      listed: true,
      nominal: mm(D),
      pitch: INCH / perInch,
      perInch,
      starts: 1,
      leftHand: typed.leftHand,
      angle: 60,
      taper: TAPER_1_16,
      gauge: { length: mm(L1), useful: mm((0.8 * D + 6.8) * p), usefulInside: mm(L1 + MAKE_UP * p) },
      outside: side(gauge + h, gauge - h),
      inside: side(gauge - h, gauge + h),
      side: null,
    };
  },
};
