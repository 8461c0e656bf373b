import type { ActionSource } from "../types.ts";
import { centre } from "./centre.ts";
import { drill } from "./drill.ts";
import { face } from "./face.ts";
import { finishInside } from "./finish-inside.ts";
import { finishOutside } from "./finish-outside.ts";
import { partOff } from "./part-off.ts";
import { ream } from "./ream.ts";
import { recess } from "./recess.ts";
import { recessInside } from "./recess-inside.ts";
import { restRough } from "./rest-rough.ts";
import { roughInside, turnInside } from "./rough-inside.ts";
import { roughOutside, turnOutside } from "./rough-outside.ts";
import { thread } from "./thread.ts";
import { threadInside } from "./thread-inside.ts";
import { undercut } from "./undercut.ts";

/** Every kind of action, one file and one line each, in the usual order of a working plan. */
export const actionSources: readonly ActionSource[] = [
  face,
  centre,
  drill,
  roughOutside,
  turnOutside,
  roughInside,
  turnInside,
  restRough,
  recess,
  recessInside,
  finishOutside,
  finishInside,
  ream,
  undercut,
  thread,
  threadInside,
  partOff,
];
