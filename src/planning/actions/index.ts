import type { ActionSource } from "../types.ts";
import { face } from "./face.ts";

/** Every kind of action, one file and one line each, in the usual order of a working plan. */
export const actionSources: readonly ActionSource[] = [face];
