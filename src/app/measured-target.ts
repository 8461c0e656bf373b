import type { MeasuredTarget } from "./lathe/measured-into.ts";
import { usePlace } from "./place.ts";
import type { JobReading } from "./reading.ts";
import { closeStep } from "./steps.ts";

/** The open prompt of a cycle as a place for a measured value, which is a step of undo of its own. */
export function useMeasuredTarget(read: JobReading | null, set: (q: string, text: string) => void): MeasuredTarget | null {
  const q = usePlace((p) => p.prompt);
  const param = q === null ? undefined : read?.cycle.params[q];
  if (q === null || !param || param.choices) return null;
  const take = (value: number) => {
    closeStep();
    set(q, String(value));
    closeStep();
  };
  return { q, kind: param.kind, take };
}
