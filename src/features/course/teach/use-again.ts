import { useEffect, useState } from "react";
import { runAgain } from "./hand-in.ts";
import type { Again, ResultRow } from "../../../app/records/course/result-rows.ts";

/** What was found of results that were run here: those that come later do not run the others again. */
const found = new WeakMap<ResultRow["result"], Again>();

/** Runs each program once more, one after the other; by the keys of the rows. */
export function useAgain(rows: readonly ResultRow[]): ReadonlyMap<string, Again> {
  const [again, say] = useState<ReadonlyMap<string, Again>>(new Map());
  useEffect(() => {
    let gone = false;
    void (async () => {
      const all = new Map<string, Again>();
      for (const { key, result } of rows) {
        const is = found.get(result) ?? (await runAgain(result));
        // What could not be run may be so another time.
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
