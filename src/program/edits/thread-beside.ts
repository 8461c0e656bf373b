import { pointAngle } from "../../kernel/cutter/insert.ts";
import { toRadius } from "../../kernel/units.ts";
import type { UndercutPlace } from "../job/undercut-name.ts";
import type { Operation } from "../state/run-types.ts";

/** Share by which a cylinder may differ from the crest or the root of its thread. */
const NEAR = 0.05;
/** How far before or behind a shoulder its thread may end, in pitches: the widest undercut of DIN 76 has 5. */
const REACH = 6;
/** Flank angle of the metric threads for which DIN 76 is made, degrees. */
const METRIC = 60;

/** The place of an undercut with the pitch of the metric thread that ends at its shoulder, if the program cuts one. */
export function withThreadBeside(place: UndercutPlace, operations: readonly Operation[]): UndercutPlace {
  const { z } = place;
  const own = toRadius(place.diameter);
  const beside = operations.find(({ tool, plan: { thread, openSide } }) => {
    const end = thread?.crest.at(-1);
    const [depth, pitch] = [thread?.depths.at(-1) ?? 0, thread?.pitch ?? 0];
    return (
      end !== undefined &&
      z !== undefined &&
      openSide.r < 0 === place.isInside &&
      Math.abs(pointAngle(tool) - METRIC) < 1 &&
      Math.abs(end.r - own) <= depth + NEAR * own &&
      Math.abs(end.z - z) <= REACH * pitch
    );
  });
  const pitch = beside?.plan.thread?.pitch;
  return pitch === undefined ? place : { ...place, pitch };
}
