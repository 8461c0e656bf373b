import { useMemo } from "react";
import type { Run } from "../../../program/state/run-types.ts";
import type { RapidThrough } from "../../../sim/plane/milled.ts";
import { useTexts } from "../../base/settings/use-texts.ts";

/** Notes on the drawn milled stock: it is not verified, and the rapids that it shows nevertheless. */
export function MilledNotes({ run, rapids }: { readonly run: Run; readonly rapids: readonly RapidThrough[] }) {
  const t = useTexts().approach.milled;
  const blocks = useMemo(
    () => [...new Set(rapids.map(({ step }) => run.plane[step]?.block))].join(", "),
    [run, rapids],
  );
  const noRadius = useMemo(() => run.plane.some(({ radius, feed }) => feed !== undefined && !(radius > 0)), [run]);
  return (
    <>
      {rapids.length > 0 && <p className="small milled-rapid">{t.rapid(blocks)}</p>}
      {noRadius && <p className="small soft">{t.noRadius}</p>}
      <p className="small soft">{t.drawn}</p>
    </>
  );
}
