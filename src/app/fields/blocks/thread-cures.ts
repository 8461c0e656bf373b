import type { Cycle } from "../../../cycles/define.ts";
import type { Param } from "../../../cycles/params.ts";
import type { Issue } from "../../../kernel/plan/issue.ts";

export type Overrun = Extract<Issue, { code: "threadOverruns" }>;

/** How much earlier a thread is ended, in overruns. */
const EARLIER = [0.5, 1, 1.5, 2];
/** Decimals of a new end, mm. */
const TENTH = 10;

/** Values of the thread cycle that may keep its overrun out of the part, to be tried. */
export interface ThreadCure {
  readonly kind: "runOut" | "endThread";
  /** Run-out, or the place of the new end. */
  readonly text: string;
  /** By Q, as typed. */
  readonly prompts: Readonly<Record<string, string>>;
}

/** The parameter of a cycle with a meaning. */
export const promptOf = (cycle: Cycle, text: Param["text"]): string | undefined =>
  Object.keys(cycle.params).find((q) => cycle.params[q]?.text === text);

/** The parameter with the end of a thread along an axis. */
export const threadEndOf = (cycle: Cycle, axis: "X" | "Z"): string | undefined =>
  promptOf(cycle, axis === "Z" ? "endZ" : "threadEndDiameter");

/**
 * A run-out, and earlier ends with and without it. `hasRunOut`: the thread has one. `asTyped`: a length in mm at a
 * parameter.
 */
export function threadCures(
  cycle: Cycle,
  { data }: Overrun,
  hasRunOut: boolean,
  asTyped: (q: string, mm: number) => string,
): readonly ThreadCure[] {
  const [end, runOut] = [threadEndOf(cycle, data.axis), promptOf(cycle, "threadRunOut")];
  const [way, overrun] = [Math.sign(data.to - data.end), Math.abs(data.to - data.end)];
  const runsOut = runOut === undefined ? {} : { [runOut]: asTyped(runOut, overrun) };
  const runOuts = Object.entries(hasRunOut ? {} : runsOut).map(([q, value]): ThreadCure => ({
    kind: "runOut",
    text: `${q} ${value}`,
    prompts: runsOut,
  }));
  const ends = [{}, runsOut].flatMap((beside) =>
    end === undefined
      ? []
      : EARLIER.map((share): ThreadCure => {
          const value = asTyped(end, Math.round((data.end - way * share * overrun) * TENTH) / TENTH);
          return { kind: "endThread", text: `${data.axis}${value}`, prompts: { [end]: value, ...beside } };
        }),
  );
  return [...runOuts, ...ends];
}
