import { difference, intersection } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { boxBeyond, inBox } from "../kernel/area/box.ts";
import { merged, ringsMeeting, type Present } from "./cutting.ts";
import type { Sweep } from "./sweep.ts";

/** The last contact: a rapid needs it for the check and for the removed area. */
let lastContact: { readonly sweep: Sweep; readonly now: Present; readonly rings: Ring[] } | null = null;

/** The overlap of sweeps with the present stock, and with an area where one is given. */
export function inStock(sweeps: readonly Sweep[], now: Present, within: readonly Ring[] | null = null): Ring[] {
  const [alone] = sweeps.length === 1 && !within ? sweeps : [];
  if (alone && lastContact?.sweep === alone && lastContact.now === now) return lastContact.rings;
  const rings = standing(sweeps, now, within);
  if (alone) lastContact = { sweep: alone, now, rings };
  return rings;
}

function standing(sweeps: readonly Sweep[], now: Present, within: readonly Ring[] | null): Ring[] {
  const rings = sweeps.flatMap((sweep) => ringsMeeting(sweep, now.meets));
  if (rings.length === 0) return [];
  const box = boxBeyond(rings);
  const whole = merged(rings);
  const area = within ? intersection(inBox(within, box), whole) : whole;
  if (area.length === 0) return [];
  const there = intersection(inBox(now.base, box), area);
  const gone = there.length === 0 ? [] : inBox(now.gone, boxBeyond(there));
  return gone.length === 0 ? there : difference(there, gone);
}
