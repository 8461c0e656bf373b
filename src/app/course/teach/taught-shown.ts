import { create } from "zustand";
import type { HandedResult } from "../../../course/made/result.ts";
import type { Task } from "../../../course/task.ts";

/** Something of a course that came from outside, shown before anything becomes of it. */
export type TaughtShown = { readonly kind: "task"; readonly task: Task } | { readonly kind: "result"; readonly result: HandedResult };

export const useTaughtShown = create<{ readonly shown: TaughtShown | null }>(() => ({ shown: null }));

export const showTaught = (shown: TaughtShown): void => useTaughtShown.setState({ shown });
export const leaveTaught = (): void => useTaughtShown.setState({ shown: null });
