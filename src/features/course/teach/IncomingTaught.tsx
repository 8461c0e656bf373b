import { Suspense } from "react";
import { lazyPart } from "../../../app/base/parts.ts";
import { useTaughtShown } from "../../../app/records/course/taught-shown.ts";

const TaughtDialog = lazyPart(async () => ({ default: (await import("./TaughtDialog.tsx")).TaughtDialog }));

/** A task or results that came from outside, until somebody closes them. */
export function IncomingTaught() {
  const waits = useTaughtShown((s) => s.shown !== null);
  return (
    waits && (
      <Suspense>
        <TaughtDialog />
      </Suspense>
    )
  );
}
