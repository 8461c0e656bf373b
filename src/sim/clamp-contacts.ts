import { areaOf } from "../kernel/area/area.ts";
import { boxAround } from "../kernel/area/box.ts";
import type { ClampBody, Clamped } from "../kernel/area/clamping.ts";
import { intersection } from "../kernel/area/clip.ts";
import type { Ring } from "../kernel/geometry/point.ts";
import { withoutSlivers } from "../kernel/area/real-area.ts";
import type { Step } from "../kernel/time/step.ts";
import { MOST_CONTACTS } from "./check.ts";
import { merged } from "./cutting.ts";
import { sidesOf } from "./edges.ts";
import type { Outlines } from "./outlines.ts";
import { largest, placeIn } from "./region.ts";
import { areBoxesApart, sweptBox } from "./resume.ts";
import type { AnyFinding } from "./simulation.ts";
import { sweptBy, type Sweep } from "./sweep.ts";

/** Chord error of arcs in the holder check, mm. */
const HOLDER_CHORD = 0.01;

/** The overlap of sweeps with a clamping body, without mere touching. */
const met = ({ rings }: ClampBody, sweeps: readonly Sweep[]): Ring[] =>
  withoutSlivers(intersection(rings, merged(sweeps.flatMap((sweep) => sweep.rings))));

/**
 * Contacts of tools and holders with the clamping, in any move. The bodies do not change while cutting, so no stock is
 * needed. The check stops after as many contacts as that of the stock.
 */
export function clampContacts(
  steps: readonly Step[],
  clamped: Clamped | null | undefined,
  outlines: (tool: Step["tool"]) => Outlines,
): AnyFinding[] {
  const bodies = clamped?.bodies.filter(({ rings }) => rings.length > 0) ?? [];
  const found: AnyFinding[] = [];
  if (bodies.length === 0) return found;
  const asked = bodies.map((body) => ({ body, box: boxAround(body.rings), edges: sidesOf(body.rings) }));
  for (const [index, step] of steps.entries()) {
    if (found.length >= MOST_CONTACTS) break;
    const { checked, holder } = outlines(step.tool);
    for (const [by, parts] of [
      ["tool", [checked]],
      ["holder", holder],
    ] as const) {
      const boxes = parts.map((part) => sweptBox(part, step));
      const near = asked.filter(({ box }) => boxes.some((swept) => swept && !areBoxesApart(swept, box)));
      if (near.length === 0) continue;
      const sweeps = parts.map((part) => sweptBy(part, step, 1, by === "holder" ? HOLDER_CHORD : undefined));
      for (const { body, edges } of near) {
        if (!sweeps.some(({ pieces }) => pieces.some((piece) => edges.meets(piece)))) continue;
        const rings = met(body, sweeps);
        if (rings.length === 0) continue;
        const at = { step: index, block: step.block, operation: step.operation, place: placeIn(largest(rings)) };
        found.push({
          kind: "clampContact",
          clamp: { part: body.part, by },
          ...at,
          area: areaOf(rings),
          rings,
          moves: 1,
        });
      }
    }
  }
  return found;
}
