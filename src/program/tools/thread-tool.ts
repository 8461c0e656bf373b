import type { ThreadFill } from "../../cycles/thread-values.ts";
import { noseOfRoot, type NamedThread } from "../../kernel/thread/named-thread.ts";
import { pointAngle } from "../../kernel/cutter/insert.ts";
import type { Tool } from "../../kernel/plan/tool.ts";
import { rounded, roundedUpTo } from "../../kernel/units.ts";
import type { ToolEntry } from "./tool-entry.ts";
import { freeNumber, type ToolList } from "./tool-list.ts";

/** Angles of inserts this near are the same, degrees. */
const SAME_ANGLE = 0.5;

/** Whether an insert has the angle of a thread. */
export const hasAngleOf = ({ angle }: Pick<NamedThread, "angle">, tool: Tool): boolean =>
  tool.TYPE === "THREAD" && Math.abs(pointAngle(tool) - angle) < SAME_ANGLE;

/** Height of a tooth in thread depths, in steps of half a millimetre. */
const [HIGHER, STEP] = [1.1, 0.5];
/** Tip orientation towards the axis, and away from it. */
const TO = { outside: "2", inside: "6" } as const;

/** Row of a thread tool with the profile of a thread, with a free number. */
export function threadTool(list: ToolList, thread: NamedThread, { inside, cut }: ThreadFill): ToolEntry["cells"] {
  const side = inside ? "inside" : "outside";
  const basic = thread[side];
  return {
    T: String(freeNumber(list)),
    NAME: `THREAD-${rounded(thread.angle)}-${inside ? "ID" : "OD"}-P${rounded(thread.pitch)}`,
    TYPE: "THREAD",
    TO: TO[side],
    RS: String(basic ? rounded(noseOfRoot(thread, basic)) : 0),
    "P-ANGLE": String(thread.angle),
    CUTLENGTH: String(roundedUpTo(STEP, cut.depth * HIGHER)),
  };
}
