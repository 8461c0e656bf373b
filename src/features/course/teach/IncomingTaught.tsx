import { Suspense } from "react";
import { lazyPart } from "../../../app/base/parts.ts";
import { useTaughtShown } from "../../../app/records/course/taught-shown.ts";

const TaughtDialog = lazyPart(async () => ({ default: (await import("./TaughtDialog.tsx")).TaughtDialog }));

/** A received task or results, until the dialog is closed. */
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
