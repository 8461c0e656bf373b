import { withBlock } from "../../nc/edit.ts";
import type { Program } from "../../nc/program.ts";
import type { KeptTools } from "./tool-difference.ts";

/** What a call of a number calls afterwards: an index behind the point stays; null where it is none of them. */
function callAfter(called: number, moved: KeptTools["moved"]): number | null {
  const exact = moved.find(({ from }) => from === called);
  if (exact) return exact.to;
  const whole = moved.find(({ from }) => from === Math.floor(called));
  const index = String(called).split(".")[1];
  return whole ? Number(index === undefined ? whole.to : `${whole.to}.${index}`) : null;
}

/** The program with other numbers in its tool calls, and how many blocks changed. All else stays to the letter. */
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
