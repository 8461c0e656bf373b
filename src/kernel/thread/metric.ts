import { METRIC_ANGLE, METRIC_SIZES } from "../contour/metric-thread.ts";
import { SAME_STEP } from "../tolerance.ts";
import { rounded } from "../units.ts";
import { metricClass } from "./metric-tolerance.ts";
import type { NamedThread, ThreadSide } from "./named-thread.ts";
import { isPlausible, startsOf, type ThreadStandard } from "./standard.ts";
import type { TypedName } from "./typed-name.ts";

/** Height of the fundamental triangle in pitches. */
export const TRIANGLE = Math.sqrt(3) / 2;
/**
 * Basic profile of ISO 68-1 in heights of the triangle, on the diameter: pitch diameter d − 3/4 H, minor diameter of the
 * internal thread D − 5/4 H, of the external one with a round root d − 17/12 H.
 */
const PITCH = (3 / 4) * TRIANGLE;
const MINOR = (5 / 4) * TRIANGLE;
const ROUND_ROOT = (17 / 12) * TRIANGLE;

/** M 20 x 1.5; M 16 x Ph3 P1.5; 20 x 1.5. */
const NAME = /^(m[fk]?)? ?(\d+(?:\.\d+)?)(?:(?:x|-)(?:ph)?(\d+(?:\.\d+)?)(?: ?\(?p(\d+(?:\.\d+)?)\)?)?)?$/;

/** Classes where none is named, up to M1.4 and above (ISO 965-1, 12). */
const SMALL = 1.4;
const usual = (nominal: number) =>
  nominal <= SMALL ? { outside: "6h", inside: "5H" } : { outside: "6g", inside: "6H" };

/** A metric thread of any diameter and pitch, with its tolerance classes. */
export function metricThread(
  size: { readonly nominal: number; readonly pitch: number; readonly starts: number },
  typed: Omit<TypedName, "size">,
): NamedThread | null {
  const { nominal, pitch, starts } = size;
  const row = METRIC_SIZES.find(([d]) => Math.abs(d - nominal) < SAME_STEP);
  const coarse = row?.[1] ?? null;
  const classes = usual(nominal);
  const side = (name: string, crest: number, root: number): ThreadSide | null => {
    const basic = { crest: rounded(crest), pitch: rounded(nominal - PITCH * pitch), root: rounded(root) };
    const tolerance = metricClass(name, size, basic);
    return tolerance && { ...basic, tolerance };
  };
  const outside = side(typed.outside ?? classes.outside, nominal, nominal - ROUND_ROOT * pitch);
  const inside = side(typed.inside ?? classes.inside, nominal - MINOR * pitch, nominal);
  if (!outside || !inside) return null;
  const lead = rounded(starts * pitch);
  return {
    standard: "metric",
    name: starts > 1 ? `M${nominal}×Ph${lead} P${pitch}` : coarse === pitch ? `M${nominal}` : `M${nominal}×${pitch}`,
    listed: row !== undefined && row.slice(1).includes(pitch),
    nominal,
    pitch,
    starts,
    leftHand: typed.leftHand,
    angle: METRIC_ANGLE,
    taper: 0,
    outside,
    inside,
    side: typed.outside && !typed.inside ? "outside" : typed.inside && !typed.outside ? "inside" : null,
  };
}

/** ISO metric threads, coarse and fine, and any other diameter and pitch with their profile. */
export const metric: ThreadStandard = {
  id: "metric",
  documents: "ISO 68-1, ISO 261, ISO 965-1 (DIN 13)",
  evidence: "L",
  names: METRIC_SIZES.flatMap(([d, coarse, ...fine]) => [
    ...(coarse === null ? [] : [`M${d}`]),
    ...fine.map((pitch) => `M${d}×${pitch}`),
  ]),
  read(typed) {
    const m = NAME.exec(typed.size);
    // Without its symbol, a size needs a pitch.
    if (!m || (m[1] === undefined && m[3] === undefined)) return null;
    if (m[1] === undefined && typed.size.includes("-")) return null;
    const nominal = Number(m[2]);
    const coarse = METRIC_SIZES.find(([d]) => d === nominal)?.[1] ?? null;
    const lead = m[3] === undefined ? coarse : Number(m[3]);
    const made = lead === null ? null : startsOf(lead, m[4] === undefined ? undefined : Number(m[4]));
    return made && isPlausible(nominal, made.pitch) ? metricThread({ nominal, ...made }, typed) : null;
  },
};
