import { lazyPart } from "../../../app/base/parts.ts";
import { useOpenedCourseFile } from "../../../app/records/course/opened-course-file.ts";

const TaughtDialog = lazyPart(async () => ({ default: (await import("./TaughtDialog.tsx")).TaughtDialog }));

/** A received task or results, until the dialog is closed. */
export function IncomingTaught() {
  const waits = useOpenedCourseFile((s) => s.shown !== null);
  return waits && <TaughtDialog />;
}
