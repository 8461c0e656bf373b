import { lazyPart } from "../../app/base/parts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { bundleOf, useEditor } from "../../app/document/store.ts";
import { taskOfWork } from "../../app/document/work-task.ts";
import { useIncoming } from "../../app/records/incoming.ts";

/** Loaded when a work was received or has its own tools. */
const IncomingDialog = lazyPart(async () => ({ default: (await import("./IncomingDialog.tsx")).IncomingDialog }));
const WorkBar = lazyPart(async () => ({ default: (await import("./WorkBar.tsx")).WorkBar }));

/** The dialog of a received link or file, until it is answered. */
export function IncomingWork() {
  const waits = useIncoming((s) => s.incoming !== null);
  return waits && <IncomingDialog />;
}

/**
 * The line above a work that runs with other settings than this device. A task names its tools in its goals instead.
 */
export function SharedSetupLine() {
  const isTask = useEditor((s) => taskOfWork(s) !== undefined);
  const tools = useEditor((s) => bundleOf(s).tools !== undefined);
  const control = useEditor((s) => bundleOf(s).control);
  const machine = useEditor((s) => bundleOf(s).machine);
  const device = useSettings((s) => s.control);
  const mine = useSettings((s) => s.machine);
  const isOther = (control !== undefined && control !== device) || (machine !== undefined && machine !== mine);
  return !isTask && (tools || isOther) && <WorkBar />;
}
