import { shippedTools } from "../../../program/tools/shipped-tools.ts";
import type { ComparisonWords } from "./plan-row-words.ts";

/** A tool with its number and name: an exercise is made with the default tools. */
export const toolName = ({ t }: ComparisonWords, tool: number): string =>
  t.steps.tool(String(tool), shippedTools.find(({ T }) => T === tool)?.NAME ?? "");
