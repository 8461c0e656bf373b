import { WORKPIECE_ZERO } from "../../view/datum.ts";
import type { BlockUnits } from "../../view/measure/distance.ts";
import type { MeasuredTarget } from "./measured-target-context.ts";
import { usePlace } from "../place/place.ts";
import type { JobReading } from "./reading.ts";
import { closeStep } from "./steps.ts";

/** A job counts in mm from the workpiece zero. */
const PLAIN: BlockUnits = { unit: 1, zero: WORKPIECE_ZERO };

/** The open prompt of a cycle as the target of a measured value; each value is a step of undo of its own. */
export function useMeasuredTarget(
  read: JobReading | null,
  set: (q: string, text: string) => void,
  counts: BlockUnits = PLAIN,
): MeasuredTarget | null {
  const q = usePlace((p) => p.prompt);
  const param = q === null ? undefined : read?.cycle.params[q];
  if (q === null || !param || param.choices) return null;
  const take = (value: number) => {
    closeStep();
    set(q, String(value));
    closeStep();
  };
  return { q, kind: param.kind, counts, take };
}
