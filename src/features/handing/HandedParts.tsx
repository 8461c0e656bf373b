import { Suspense } from "react";
import { lazyPart } from "../../app/base/parts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { handedOn, useEditor } from "../../app/document/store.ts";
import { useIncoming } from "../../app/records/incoming.ts";

/** Fetched when something was handed on. */
const IncomingDialog = lazyPart(async () => ({ default: (await import("./IncomingDialog.tsx")).IncomingDialog }));
const WorkBar = lazyPart(async () => ({ default: (await import("./WorkBar.tsx")).WorkBar }));

/** What a link or a file holds, as long as nobody has said what becomes of it. */
export function IncomingWork() {
  const waits = useIncoming((s) => s.incoming !== null);
  return (
    waits && (
      <Suspense>
        <IncomingDialog />
      </Suspense>
    )
  );
}

/** One line over a work that does not run with what this device has. A task says with its goals what it allows. */
export function HandedLine() {
  const isTask = useEditor(({ job, program }) => (job ?? program)?.task !== undefined);
  const tools = useEditor((s) => handedOn(s).tools !== undefined);
  const control = useEditor((s) => handedOn(s).control);
  const machine = useEditor((s) => handedOn(s).machine);
  const device = useSettings((s) => s.control);
  const mine = useSettings((s) => s.machine);
  const isOther = (control !== undefined && control !== device) || (machine !== undefined && machine !== mine);
  return (
    !isTask &&
    (tools || isOther) && (
      <Suspense>
        <WorkBar />
      </Suspense>
    )
  );
}
