import { INCH, rounded } from "../units.ts";
import { TRAPEZOIDAL_ANGLE } from "./profiles.ts";
import { isPlausible, type ThreadStandard } from "./standard.ts";

/** Up to diameter, mm: threads per inch (DIN 405-1). */
const PER_INCH: readonly (readonly [upTo: number, perInch: number])[] = [
  [12, 10],
  [38, 8],
  [100, 6],
  [200, 4],
];
/** Diameters of the table, mm. */
const DIAMETERS = [
  8, 9, 10, 11, 12, 14, 16, 18, 20, 22, 24, 26, 28, 30, 32, 34, 36, 38, 40, 42, 44, 46, 48, 50, 52, 55, 58, 60, 62, 65,
  68, 70, 72, 75, 78, 80, 82, 85, 88, 90, 92, 95, 98, 100, 105, 110, 115, 120, 125, 130, 135, 140, 145, 150, 155, 160,
  165, 170, 175, 180, 185, 190, 195, 200,
];
/** Depth in pitches (tag L: MANUALplus 620 p. 572), and clearance at the root of the internal thread. */
const [DEPTH, CLEARANCE] = [0.5, 0.05];
const NAME = /^rd ?(\d+(?:\.\d+)?)(?:x1\/(\d+(?:\.\d+)?)|x(\d+(?:\.\d+)?))?$/;

/** Round threads; the pitch is a fraction of an inch. */
export const round: ThreadStandard = {
  id: "round",
  documents: "DIN 405-1",
  evidence: "L",
  names: DIAMETERS.filter((d) => d >= 20 && d % 10 === 0).map((d) => `Rd${d}`),
  read(typed) {
    const m = NAME.exec(typed.size);
    if (!m || typed.outside || typed.inside) return null;
    const nominal = Number(m[1]);
    const usual = PER_INCH.find(([upTo]) => nominal <= upTo)?.[1];
    const perInch = m[2] !== undefined ? Number(m[2]) : m[3] !== undefined ? INCH / Number(m[3]) : usual;
    if (!perInch || !isPlausible(nominal, INCH / perInch)) return null;
    const pitch = INCH / perInch;
    const isUsual = usual !== undefined && Math.abs(perInch - usual) < 0.01;
    const [gap, depth] = [CLEARANCE * pitch, DEPTH * pitch];
    const major = nominal + gap + gap;
    return {
      standard: "round",
      name: m[3] === undefined || isUsual ? `Rd${nominal}×1/${rounded(perInch)}` : `Rd${nominal}×${rounded(pitch)}`,
      listed: isUsual && DIAMETERS.includes(nominal),
      nominal,
      pitch,
      perInch,
      starts: 1,
      leftHand: typed.leftHand,
      angle: TRAPEZOIDAL_ANGLE,
      taper: 0,
      outside: { crest: nominal, pitch: nominal - depth, root: nominal - depth - depth },
      inside: { crest: major - depth - depth, pitch: nominal - depth, root: major },
      side: null,
    };
  },
};
