import { withBlock } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import type { KeptTools } from "./tool-difference.ts";

/** New number of a tool call: the index behind the point stays; null where it is not renumbered. */
function callAfter(called: number, moved: KeptTools["moved"]): number | null {
  const exact = moved.find(({ from }) => from === called);
  if (exact) return exact.to;
  const whole = moved.find(({ from }) => from === Math.floor(called));
  const index = String(called).split(".")[1];
  return whole ? Number(index === undefined ? whole.to : `${whole.to}.${index}`) : null;
}

/** Renumbers the tool calls of a program, and counts the changed blocks. Everything else stays unchanged. */
export function withCalls(
  program: Program,
  moved: KeptTools["moved"],
): { readonly program: Program; readonly changed: number } {
  let [next, changed] = [program, 0];
  program.blocks.forEach(({ statement }, index) => {
    if (statement.kind !== "toolCall" || typeof statement.tool !== "number") return;
    const tool = callAfter(statement.tool, moved);
    if (tool === null) return;
    next = withBlock(next, index, { ...statement, tool });
    changed++;
  });
  return { program: next, changed };
}
