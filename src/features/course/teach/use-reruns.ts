import { useEffect, useState } from "react";
import { rerunResult } from "./hand-in.ts";
import type { Rerun, ResultRow } from "../../../app/records/course/result-rows.ts";
import { untilGone } from "../../../app/base/until-gone.ts";

/** Cached reruns, so that later results do not run the earlier ones again. */
const cachedReruns = new WeakMap<ResultRow["result"], Rerun>();

/** Reruns each program, one after the other; by the keys of the rows. */
export function useReruns(rows: readonly ResultRow[]): ReadonlyMap<string, Rerun> {
  const [again, say] = useState<ReadonlyMap<string, Rerun>>(new Map());
  useEffect(
    () =>
      untilGone(async (isGone) => {
        const all = new Map<string, Rerun>();
        for (const { key, result } of rows) {
          const is = cachedReruns.get(result) ?? (await rerunResult(result));
          // A failed run is retried another time.
          if (is.is !== "stopped" && is.is !== "unknown") cachedReruns.set(result, is);
          all.set(key, is);
          if (isGone()) return;
          say(new Map(all));
        }
      }),
    [rows],
  );
  return again;
}
