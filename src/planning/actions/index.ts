import type { ActionSource } from "../types.ts";
import { drill } from "./drill.ts";
import { face } from "./face.ts";
import { finishInside } from "./finish-inside.ts";
import { roughInside } from "./rough-inside.ts";

/** Every kind of action, one file and one line each, in the usual order of a working plan. */
export const actionSources: readonly ActionSource[] = [face, drill, roughInside, finishInside];
