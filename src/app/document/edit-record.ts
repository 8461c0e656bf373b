import type { KeptRecord } from "../base/record.ts";
import { continuesStep, recordStep, stepBetween } from "./steps.ts";

/** Changes a record as one step of undo; successive changes at the same place are one step. */
export function editRecord<T>(record: KeptRecord<T>, change: (value: T) => T, place: string | null = null): void {
  const before = record.now();
  const next = change(before);
  if (next === before || record.isSame(next, before)) return;
  record.put(next);
  const step = stepBetween(record.document, record.put, before, next);
  recordStep({ ...step, record: record.key }, continuesStep(place));
}
