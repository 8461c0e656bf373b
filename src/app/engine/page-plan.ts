import { stopwatch } from "../clock.ts";
import { untilHere } from "../parts.ts";
import { atRest } from "../rest.ts";
import type { Planned } from "./outcome.ts";
import type { Request } from "./request.ts";

/*
 * The page plans what is quickly planned: path, contour and passes are drawn in the frame of the keystroke, and the worker proves them.
 * What takes longer is left to the worker altogether.
 */

/** What reading and running may take on the page, ms: most take a tenth of that, and on a weak tablet there is still time to draw. */
const MAY_TAKE = 20;
/** Texts up to this length are tried when nothing is known of the work yet, characters. */
const SHORT = 20_000;

/** What plans: fetched when nothing else is to be done, because until it is here the worker does it as well. */
let plan: ((request: Request) => Planned) | null = null;
/** What the last runs of the open work took, on the page or in the worker, ms. The quickest counts: others had to wait for something. */
let paces: readonly number[] = [];
const LAST = 3;
const note = (took: number): void => {
  paces = [...paces.slice(1 - LAST), took];
};

/** From now on the page plans, as soon as it can. Gives the way to call it off. */
export const fetchPlan = (): () => void => atRest(() => void untilHere(() => import("./plan.ts")).then((part) => (plan = part.planner())));

/** Another work has a pace of its own. */
export const forgetPace = (): void => {
  paces = [];
};

/** What reading and running took in the worker, ms. */
export const notePace = (took: number | undefined): void => {
  if (took !== undefined) note(took);
};

const lengthOf = ({ text, files = [] }: Request): number => files.reduce((sum, file) => sum + file.text.length, text.length);

/** Whether a text of a length, with what it can call, is planned on the page. */
export const plansOnPage = (characters: number): boolean =>
  plan !== null && (paces.length === 0 ? characters <= SHORT : Math.min(...paces) <= MAY_TAKE);

/** The run of a request, made now; null where the worker has to make it. */
export function planNow(request: Request): Planned | null {
  if (!plan || !plansOnPage(lengthOf(request))) return null;
  const begun = stopwatch();
  try {
    return plan(request);
  } catch {
    // The worker comes to the same, and says so.
    return null;
  } finally {
    note(stopwatch() - begun);
  }
}
