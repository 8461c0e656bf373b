import { INCH, rounded } from "../units.ts";
import type { ThreadSide } from "./named-thread.ts";
import { WHITWORTH } from "./profiles.ts";
import { isPlausible, type ThreadStandard } from "./standard.ts";
import { inchesIn, inchText } from "./typed-name.ts";

/** Size in inches, threads per inch of BSW and of BSF (BS 84); 0 where the series has none. */
const SIZES: readonly (readonly [inches: string, coarse: number, fine: number])[] = [
  ["1/16", 60, 0],
  ["3/32", 48, 0],
  ["1/8", 40, 0],
  ["5/32", 32, 0],
  ["3/16", 24, 32],
  ["7/32", 24, 28],
  ["1/4", 20, 26],
  ["5/16", 18, 22],
  ["3/8", 16, 20],
  ["7/16", 14, 18],
  ["1/2", 12, 16],
  ["9/16", 12, 16],
  ["5/8", 11, 14],
  ["11/16", 11, 14],
  ["3/4", 10, 12],
  ["7/8", 9, 11],
  ["1", 8, 10],
  ["1 1/8", 7, 9],
  ["1 1/4", 7, 9],
  ["1 3/8", 6, 8],
  ["1 1/2", 6, 8],
  ["1 5/8", 5, 0],
  ["1 3/4", 5, 7],
  ["1 7/8", 4.5, 0],
  ["2", 4.5, 7],
  ["2 1/4", 4, 6],
  ["2 1/2", 4, 6],
  ["2 3/4", 3.5, 6],
  ["3", 3.5, 5],
];
/** Finest thread, per inch. */
const FINEST = 80;

const NAME =
  /^(?:(w|bsw|bsf|whit(?:worth)?)\.? ?(\d+ \d+\/\d+|\d+-\d+\/\d+|[\d./]+)(?:(?:-|x| )(\d+(?:\.\d+)?)(?:tpi)?)?|(\d+ \d+\/\d+|\d+-\d+\/\d+|[\d./]+)(?:-(\d+(?:\.\d+)?))? ?(bsw|bsf|whit(?:worth)?)\.?)$/;

/** Whitworth threads, coarse (BSW) and fine (BSF), and any other diameter and pitch with their profile. */
export const whitworth: ThreadStandard = {
  id: "whitworth",
  documents: "BS 84",
  evidence: "L",
  names: [
    ...SIZES.map(([inches]) => `W${inches}`),
    ...SIZES.flatMap(([inches, , fine]) => (fine > 0 ? [`BSF ${inches}`] : [])),
  ],
  read(typed) {
    const m = NAME.exec(typed.size);
    if (!m || typed.outside || typed.inside) return null;
    const inches = inchesIn(m[2] ?? m[4] ?? "");
    const label = inchText(inches);
    const isFine = (m[1] ?? m[6]) === "bsf";
    const said = m[3] ?? m[5];
    const row = SIZES.find(([size]) => size === label);
    const perInch = said === undefined ? row?.[isFine ? 2 : 1] : Number(said);
    if (!perInch || perInch > FINEST || !isPlausible(inches * INCH, INCH / perInch)) return null;
    const [isCoarse, isListedFine] = [row?.[1] === perInch, row?.[2] === perInch];
    const nominal = rounded(inches * INCH);
    const pitch = INCH / perInch;
    const depth = WHITWORTH.depth * pitch;
    const [flank, minor] = [nominal - depth, nominal - depth - depth];
    const outside: ThreadSide = { crest: nominal, pitch: flank, root: minor };
    return {
      standard: "whitworth",
      name: isCoarse ? `W${label}` : isListedFine ? `BSF ${label}` : `W${label}-${perInch}`,
      listed: isCoarse || isListedFine,
      nominal,
      pitch,
      perInch,
      starts: 1,
      leftHand: typed.leftHand,
      angle: WHITWORTH.angle,
      taper: 0,
      outside,
      inside: { crest: minor, pitch: flank, root: nominal },
      side: null,
    };
  },
};
