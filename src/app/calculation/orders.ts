import type { Outcome, Planned, Stage } from "./outcome.ts";
import type { Request } from "./request.ts";

/** A text of the open work, with the very files that it calls. */
export interface Text extends Request {
  readonly files?: Outcome["files"] & {};
}

/** How much of a text is planned: all of it; a slice of so many ms more; or its beginning, a share of it, unremembered. */
export type Part = { readonly slice: number } | { readonly share: number } | "whole";

/** Something to be done of a text. A planned text is proved with its run; without one the run is made as well. */
export type Order =
  | { readonly do: "plan"; readonly request: Text; readonly part: Part }
  | { readonly do: "prove"; readonly request: Text; readonly planned: Planned | null; readonly isVeiled: boolean };

/** What is told of an order. */
export type Told =
  | { readonly event: "began"; readonly version: number; readonly stage: Stage }
  /** `made`: null where planning failed, "part" where a slice was not the last. `took`: ms. */
  | {
      readonly event: "planned";
      readonly version: number;
      readonly made: Planned | "part" | null;
      readonly took: number;
    }
  | { readonly event: "proved"; readonly version: number; readonly outcome: Outcome }
  | { readonly event: "failed"; readonly version: number };

/** Carries out orders, and tells what comes of each: the page at once, the worker later. */
export type Executor<O extends Order = Order> = (order: O, tell: (told: Told) => void) => void;

/** What a result says of its text besides. */
export const ofText = ({ files, skipMarked }: Text): Pick<Outcome, "files" | "skipMarked"> => ({
  ...(files && { files }),
  ...(skipMarked !== undefined && { skipMarked }),
});
