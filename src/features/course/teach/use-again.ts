import { useEffect, useState } from "react";
import { runAgain } from "./hand-in.ts";
import type { Again, ResultRow } from "../../../app/records/course/result-rows.ts";

/** Cached reruns, so that later results do not run the earlier ones again. */
const found = new WeakMap<ResultRow["result"], Again>();

/** Reruns each program, one after the other; by the keys of the rows. */
export function useAgain(rows: readonly ResultRow[]): ReadonlyMap<string, Again> {
  const [again, say] = useState<ReadonlyMap<string, Again>>(new Map());
  useEffect(() => {
    let gone = false;
    void (async () => {
      const all = new Map<string, Again>();
      for (const { key, result } of rows) {
        const is = found.get(result) ?? (await runAgain(result));
        // A failed run is retried another time.
        if (is !== "stopped" && is !== "unknown") found.set(result, is);
        all.set(key, is);
        if (gone) return;
        say(new Map(all));
      }
    })();
    return () => {
      gone = true;
    };
  }, [rows]);
  return again;
}
