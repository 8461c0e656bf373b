import { useMemo } from "react";
import type { Measurement } from "../../../kernel/plan/measured.ts";
import { chainOfRing } from "../../../view/measure/edges.ts";
import { readMeasurement, type CurrentMeasurement } from "../../../view/measure/reading.ts";
import { measuredIn } from "../../document/edits.ts";
import { useEditor } from "../../document/store.ts";
import type { MeasurableRun } from "./source.ts";

/** The measurements of a plane with their present values. */
export function readIn(
  list: readonly Measurement[],
  { plane, contours, blank, path, fingerprintOf }: MeasurableRun,
): readonly CurrentMeasurement[] {
  const own = list.filter((each) => each.plane === plane);
  if (own.length === 0) return [];
  const onPath = own.some(({ places }) => places.some(({ spot }) => spot === "path"));
  const work = {
    isTurned: plane === "ZX",
    contours,
    blank: blank.map(chainOfRing),
    stock: [],
    path: onPath ? path() : [],
    fingerprintOf,
  };
  return own.flatMap((each) => readMeasurement(each, work) ?? []);
}

/** The measurements of the open work in a picture. */
export function useReadings(source: MeasurableRun): readonly CurrentMeasurement[] {
  const list = useEditor(measuredIn);
  return useMemo(() => readIn(list, source), [list, source]);
}
