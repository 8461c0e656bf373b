import { lazy, Suspense, useState } from "react";
import type { WhichRegion } from "./asking.ts";

/** Fetched with its texts when somebody asks. */
const WhichCycle = lazy(async () => ({ default: (await import("./WhichCycle.tsx")).WhichCycle }));

/** Asks which cycle makes a shape; about a place of an opened work, when there is one. */
export function WhichButton({ name, className, regionOf }: { readonly name: string; readonly className: string;
  readonly regionOf?: () => WhichRegion | null })
{
  const [open, show] = useState(false);
  return (
    <>
      <button type="button" className={className} onClick={() => show(true)}>{name}</button>
      {open && (
        <Suspense>
          <WhichCycle done={() => show(false)} region={regionOf?.() ?? null} />
        </Suspense>
      )}
    </>
  );
}
