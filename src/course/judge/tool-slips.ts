import { parse } from "../../nc/parse.ts";
import { blockNumbers } from "../../nc/program.ts";
import type { Task } from "../task.ts";
import type { Slip } from "./judgement.ts";

/** A program with one slip undone. */
export interface SlipTrial {
  readonly slip: Slip;
  readonly text: string;
}

interface Call {
  readonly index: number;
  readonly block: number;
  readonly tool: number;
}

const CALL = /(\bTOOL[ \t]+CALL[ \t]+)\d+/i;

/** The tool calls of a program that name a number. */
function callsOf(text: string) {
  const { blocks } = parse(text),
    numbers = blockNumbers({ blocks });
  const calls = blocks.flatMap(({ statement: s }, index): Call[] =>
    s.kind === "toolCall" && typeof s.tool === "number" ? [{ index, block: numbers[index] ?? 0, tool: s.tool }] : [],
  );
  const withTools = (...changes: readonly (readonly [Call, number])[]) =>
    blocks
      .map(({ raw }, i) => {
        const to = changes.find(([{ index }]) => index === i)?.[1];
        return to === undefined ? raw : raw.replace(CALL, `$1${to}`);
      })
      .join("");
  return { calls, withTools };
}

/** The tools with which the part of a task is made, as far as the task says so. */
export const toolsFor = ({ solution = [], rules }: Task): ReadonlySet<number> =>
  new Set([...callsOf(solution.join("\n")).calls.map(({ tool }) => tool), ...(rules.tools ?? [])]);

/** Every program that differs by two exchanged tools, or by one tool in place of another. */
export function toolSlips(task: Task, text: string): readonly SlipTrial[] {
  const { calls, withTools } = callsOf(text);
  const slip = (kind: Slip["kind"], ...changes: readonly (readonly [Call, number])[]): SlipTrial => ({
    slip: { kind, values: changes.map(([{ block, tool }, better]) => ({ block, q: "T", value: tool, better })) },
    text: withTools(...changes),
  });
  const exchanged = calls.flatMap((one, i) =>
    calls
      .slice(i + 1)
      .flatMap((other) => (one.tool === other.tool ? [] : [slip("tools", [one, other.tool], [other, one.tool])])),
  );
  const others = calls.flatMap((call) =>
    [...toolsFor(task)].flatMap((tool) => (tool === call.tool ? [] : [slip("tool", [call, tool])])),
  );
  return [...exchanged, ...others];
}
