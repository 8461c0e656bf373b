import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { taskSchema } from "../../src/course/task.ts";
import type { Tool } from "../../src/kernel/plan/tool.ts";
import { over, readTools } from "../../src/program/tools/read-tools.ts";
import { shippedTools } from "../../src/program/tools/shipped-tools.ts";

/** A program as setters write it, with the tools it was written for. */
export interface PeerProgram {
  readonly name: string;
  readonly text: string;
  readonly tools: readonly Tool[];
  /** The material that its task states; null without one. */
  readonly material: string | null;
}

const filesIn = (folder: string, end: string) =>
  readdirSync(folder)
    .filter((name) => name.endsWith(end))
    .toSorted()
    .map((name) => [name.slice(0, -end.length), readFileSync(join(folder, name), "utf8")] as const);

const programsIn = (folder: string, tools: readonly Tool[]): readonly PeerProgram[] =>
  filesIn(folder, ".h").map(([name, text]) => ({ name, text, tools, material: null }));

function shopTools(): readonly Tool[] {
  const read = readTools(readFileSync(join("tests", "shop", "tools.json"), "utf8"));
  if ("problem" in read) throw new Error(read.problem);
  return over({ tools: shippedTools }, read).tools;
}

/** The solutions of the course, the examples, ordinary programs of a shop, and the printed examples of the manual. */
export function peerPrograms(): readonly PeerProgram[] {
  const solutions = filesIn(join("src", "course", "tasks"), ".json").flatMap(([name, json]): readonly PeerProgram[] => {
    const { solution, material } = taskSchema.parse(JSON.parse(json));
    return solution
      ? [{ name, text: `${solution.join("\n")}\n`, tools: shippedTools, material: material ?? null }]
      : [];
  });
  return [
    ...solutions,
    ...programsIn(join("src", "examples"), shippedTools),
    ...programsIn(join("tests", "shop"), shopTools()),
    ...programsIn(join("tests", "programs"), shippedTools),
  ];
}
