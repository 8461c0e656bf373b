import { type KnownParameters, parametersIn } from "../values/expression.ts";
import { anyNumber, readText } from "../values/field.ts";
import type { Job } from "./job.ts";

/** Q parameters in the prompts of the job's cycle, sorted by number. */
export function usedParameters(job: Job): readonly string[] {
  const names = new Set(Object.values(job.drafts[job.cycle] ?? {}).flatMap(parametersIn));
  const order = (name: string) => Number(/(?<!\d)\d+$/.exec(name)?.[0] ?? 0);
  return [...names].sort((a, b) => order(a) - order(b) || (a < b ? -1 : 1));
}

/** Readable values of the job's Q parameters, without missing or invalid ones. */
export function knownParameters(job: Job): KnownParameters {
  const known: Record<string, number> = {};
  for (const [name, typed] of Object.entries(job.parameters)) {
    const { value } = readText(anyNumber, typed);
    if (value !== null) known[name] = value;
  }
  return known;
}
