import { stopwatch } from "../base/clock.ts";
import { untilHere } from "../base/parts.ts";
import { atRest } from "../base/rest.ts";
import type { Planned } from "./outcome.ts";
import type { planner } from "./plan.ts";
import type { Request } from "./request.ts";

/*
 * The page plans what is quickly planned: path, contour and passes are drawn in the frame of the keystroke, and the
 * worker proves them. What takes longer is planned by the worker as well.
 */

/**
 * What reading and running may take on the page, ms: most take a tenth of that; the way through the worker takes
 * several times as long.
 */
const MAY_TAKE = 60;
/** Texts up to this length are tried when nothing is known of the work yet, characters. */
const SHORT = 20_000;

/** What plans: fetched when nothing else is to be done, because until it is here the worker does it as well. */
let plan: ReturnType<typeof planner> | null = null;
/** The same without a memory: what it takes is what a program takes of which nothing is known. */
let planAnew: ((request: Request) => Planned) | null = null;
/**
 * What the last runs of the open work took, on the page or in the worker, ms. The quickest counts: others had to wait
 * for something.
 */
let paces: readonly number[] = [];
const LAST = 3,
  LAST_SLOW = 4;
/** What a key may wait for beside its digit, ms. */
const WITH_DIGIT = 60;
const note = (took: number): void => {
  paces = [...paces.slice(1 - LAST_SLOW), took];
};

/** From now on the page plans, as soon as it can. Gives the way to call it off. */
export const fetchPlan = (): (() => void) =>
  atRest(
    () =>
      void untilHere(() => import("./plan.ts")).then((part) => {
        plan = part.planner();
        planAnew = part.planned;
        if (opened) rehearse(opened);
      }),
  );

/**
 * The parts of an opened work that are planned at rest, shares of its text, and what each, or the first run of all, may
 * take, ms.
 */
const REHEARSED = [0.25, 0.5, 0.75, 1, 1] as const,
  MAY_BE_TRIED = 600;
/**
 * Of a longer text so much is planned at a time, ms; but nothing of one whose first run took so long, ms, or with so
 * many characters.
 */
const BIT = 6,
  LONG_MAY_TAKE = 4000,
  MOST = 400_000;
/** While somebody waits for its path more is planned at a time, ms, but not of one whose first run took so long, ms. */
const BIT_WAITED_FOR = 20,
  MAY_BE_WAITED_FOR = 1500;
/** A rest so long is no pause between two pictures, ms. */
const LONG_REST = 25;
let callOff: (() => void) | null = null;
/** The work that is to be planned at rest. */
let opened: Request | null = null;
/** What its first run took in the worker, ms. */
let firstTook = Infinity;

/**
 * True when a long text has been planned here at rest, or its first run was quick: one of which nothing is known could
 * halt the page.
 */
let isKnown = false;
/** Hears of the run of a long work that was planned at rest: what is made of it can be made before it is wanted. */
let hear: (run: Planned["run"]) => void = () => undefined;
export const whenRehearsed = (listener: typeof hear): void => void (hear = listener);

/** Another work has a pace of its own. */
export const forgetPace = (): void => {
  paces = [];
  isKnown = false;
  firstTook = Infinity;
  callOff?.();
  callOff = opened = null;
};

/**
 * Plans an opened work by and by while the browser rests, once for a work: browsers run slowly what they run for the
 * first time, and the path of the first key is to come as soon as that of any other. The last time it is remembered.
 */
function rehearse(request: Request): void {
  opened = request;
  if (callOff || !plan) return;
  const isLong = !isKnown && lengthOf(request) > SHORT;
  callOff = isLong
    ? planBits(
        request,
        BIT,
        (go) => atRest(go, LONG_REST),
        () => undefined,
      )
    : atRest(() => planShare(request, 0), LONG_REST);
}

function planShare(request: Request, which: number): void {
  const share = REHEARSED[which];
  if (share === undefined) return;
  const begun = stopwatch(),
    { text } = request,
    isLast = which === REHEARSED.length - 1;
  try {
    const end = text.indexOf("\n", share * (text.length - 1));
    if (isLast) plan?.(request);
    else planAnew?.(end < 0 ? request : { ...request, text: text.slice(0, end + 1) });
  } catch {
    return;
  }
  if (isLast) paces = [];
  if (stopwatch() - begun < MAY_BE_TRIED) callOff = atRest(() => planShare(request, which + 1), LONG_REST);
}

/**
 * Plans a long text in bits of so many ms, each when `next` comes to it. `done` takes what comes of it, null where that
 * is for the worker to say. Gives the way to call it off.
 */
function planBits(
  request: Request,
  bit: number,
  next: (go: () => void) => () => void,
  done: (made: Planned | null) => void,
): () => void {
  let stop = () => undefined as void;
  const go = () => {
    const begun = stopwatch();
    let made: Planned | null | undefined;
    try {
      made = plan?.part(request, () => stopwatch() - begun < bit);
    } catch {
      return done(null);
    }
    if (!made) {
      stop = next(go);
      return;
    }
    const { run } = made;
    [isKnown, paces] = [true, []];
    callOff = atRest(() => hear(run), LONG_REST);
    done(made);
  };
  stop = next(go);
  return () => stop();
}

const soon = (go: () => void): (() => void) => {
  const timer = setTimeout(go);
  return () => clearTimeout(timer);
};

/**
 * Plans a long text of which nothing is known here in bits between which the page answers: to plan it at once would
 * halt the page, and an answer of the worker as large as its path does so with each key. Gives the way to call it off;
 * null where it is not planned so.
 */
export function planSoon(request: Request, done: (made: Planned | null) => void): (() => void) | null {
  if (!plan || !opened || isKnown || firstTook > MAY_BE_WAITED_FOR || lengthOf(request) <= SHORT) return null;
  callOff?.();
  const stop = planBits(request, BIT_WAITED_FOR, soon, done);
  callOff = stop;
  return () => {
    stop();
    // It goes on at the next rest.
    if (callOff === stop) callOff = null;
  };
}

/** What reading and running took in the worker, ms; absent where it was not told. */
export function notePace(request: Request, took: number | undefined): void {
  if (took === undefined) return;
  if (paces.length === 0) [isKnown, firstTook] = [isKnown || took <= MAY_TAKE, took];
  note(took);
  const characters = lengthOf(request);
  if (characters <= SHORT ? took <= MAY_BE_TRIED : characters <= MOST && took <= LONG_MAY_TAKE) rehearse(request);
}

const lengthOf = ({ text, files = [] }: Request): number =>
  files.reduce((sum, file) => sum + file.text.length, text.length);

/** Of a long text that is not known here all of the last runs have to be quick, of any other text one of them. */
function isQuick(characters: number): boolean {
  const isFamiliar = characters <= SHORT || isKnown;
  if (!isFamiliar && opened) return false;
  const quick = paces.slice(-LAST).filter((took) => took <= MAY_TAKE).length;
  return paces.length === 0 ? isFamiliar : quick >= (isFamiliar ? 1 : LAST);
}

/** Whether a text of a length, with what it can call, is planned on the page. */
export const plansOnPage = (characters: number): boolean => plan !== null && isQuick(characters);

/** Whether planning a request takes so long that its path is to be seen before it is proved. */
export const plansLong = (request: Request): boolean => !isQuick(lengthOf(request));

/**
 * True where a digit is to be drawn before its path is planned, because two of the last runs took longer than anybody
 * waits for a digit: one may have had to wait for something, and what was taken back is known and quick.
 */
export const plansBehindDigit = (): boolean => (paces.toSorted((a, b) => b - a)[1] ?? 0) > WITH_DIGIT;

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
