import type { ToolBeside } from "../../program/tools/tool-difference.ts";

/** State of an included tool compared with the table of this device. */
export const inMyTable = ({ mine, differs }: ToolBeside): "free" | "same" | "differs" =>
  mine === null ? "free" : differs.length === 0 ? "same" : "differs";
