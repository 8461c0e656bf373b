import type { ToolPair } from "../../program/tools/tool-difference.ts";

/** State of an included tool compared with the table of this device. */
export const toolTableState = ({ mine, differs }: ToolPair): "free" | "same" | "differs" =>
  mine === null ? "free" : differs.length === 0 ? "same" : "differs";
