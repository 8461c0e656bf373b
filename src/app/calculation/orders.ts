import type { Outcome, Planned, Stage } from "./outcome.ts";
import type { Request } from "./request.ts";

/** A text of the open work, with the identical file objects that it calls. */
export interface Text extends Request {
  readonly files?: Outcome["files"] & {};
}

/**
 * How much of a text is planned: all of it, a further slice of so many ms, or a share from its beginning, which is not
 * cached.
 */
export type Part = { readonly slice: number } | { readonly share: number } | "whole";

/** An order for a text. A planned text is checked with its run; without one the run is made as well. */
export type Order =
  | { readonly do: "plan"; readonly request: Text; readonly part: Part }
  | { readonly do: "prove"; readonly request: Text; readonly planned: Planned | null; readonly isVeiled: boolean };

/** Progress and result of an order. */
export type OrderEvent =
  | { readonly event: "began"; readonly version: number; readonly stage: Stage; readonly share?: number }
  /** `made`: null where planning failed, "part" where a slice was not the last. `took`: ms. */
  | {
      readonly event: "planned";
      readonly version: number;
      readonly made: Planned | "part" | null;
      readonly took: number;
    }
  | { readonly event: "proved"; readonly version: number; readonly outcome: Outcome }
  | { readonly event: "failed"; readonly version: number };

/** Carries out orders and reports their results: the page at once, the worker later. */
export type Executor<O extends Order = Order> = (order: O, tell: (told: OrderEvent) => void) => void;

/** The fields of a result that identify its source besides the text. */
export const sourceFields = ({ files, skipMarked }: Text): Pick<Outcome, "files" | "skipMarked"> => ({
  ...(files && { files }),
  ...(skipMarked !== undefined && { skipMarked }),
});
