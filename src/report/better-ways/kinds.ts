import type { Change, ChangeKind } from "./change.ts";
import type { Fits } from "./fits.ts";
import { cuttingSpeed, feed } from "./kinds/cutting-values.ts";
import { fewerChanges } from "./kinds/fewer-changes.ts";
import { fewerTools } from "./kinds/fewer-tools.ts";
import { infeed } from "./kinds/infeed.ts";
import { noCut } from "./kinds/no-cut.ts";
import { oneCall } from "./kinds/one-call.ts";
import { otherChoice } from "./kinds/other-choice.ts";
import { otherCycle } from "./kinds/other-cycle.ts";
import { otherTool } from "./kinds/other-tool.ts";
import { restOperation } from "./kinds/rest-operation.ts";
import { start } from "./kinds/start.ts";
import { stiffness } from "./kinds/stiffness.ts";
import type { ProgramSituation } from "./situation.ts";

/** What finds the changes of each kind. */
export const KINDS: Readonly<
  Record<Exclude<ChangeKind, "both">, (situation: ProgramSituation, fits: Fits) => readonly Change[]>
> = {
  noCut,
  fewerTools,
  fewerChanges,
  restOperation,
  otherTool,
  otherCycle,
  otherChoice,
  infeed,
  stiffness,
  start,
  oneCall,
  cuttingSpeed,
  feed,
};
