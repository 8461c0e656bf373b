import type { Given } from "../../cycles/define.ts";
import type { JobReading } from "../reading.ts";
import { useOutcome } from "./outcome.ts";

const nothing: Given = { contour: null };

/** The contour that a free-contour cycle is given, as the last calculated program had it. */
export function useGiven(read: JobReading): Given {
  const free = read.cycle.contour === "free";
  const given = useOutcome((s) => s.newest?.given);
  return free && given ? given : nothing;
}
