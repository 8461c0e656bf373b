/*
 * Delays and time limits of the page in one table: each number was measured (docs/performance.md) and has its reason.
 * All are ms unless another unit is named.
 */

/** Limits of planning on the page. */
export const PLANNING = {
  /** Most plans take a tenth of this; the way through the worker takes several times as long. */
  onPage: 60,
  /** A digit waits no longer for its path: beyond this it is drawn first. */
  withDigit: 60,
  /** Texts up to this length are tried on the page before their pace is known, characters. */
  short: 20_000,
  /** A program whose first run took longer is not planned ahead: the page would hang while idle. */
  warmUp: 600,
  /** The same for a long text, which is planned in slices. */
  longWarmUp: 4000,
  /** Longer texts are left to the worker: their first plan would still be in slices when the operator is done, characters. */
  longest: 400_000,
  /** A slice while idle fits into a frame with everything else. */
  slice: 6,
  /** While somebody waits for its path a slice may take more than a frame. */
  sliceWaitedFor: 20,
  /** A text whose first run took longer is planned by the worker: nobody waits so long for slices. */
  waitedFor: 1500,
} as const;

/** Delays of the calculation. */
export const CALCULATING = {
  /** Idle time before something is planned ahead: shorter periods are gaps between two frames. */
  rest: 25,
  /**
   * The calculation of a closed work is stopped after this, since the next one is pending: a new worker takes longer.
   */
  leftWork: 400,
  /** Timeout of the worker, from its last sign of progress: no stage takes a tenth of this on a desktop. */
  answer: 120_000,
  /** Interval of checks whether a new worker holds its lock: it takes that long to start. */
  lock: 200,
  /** Debounce before all tools are tried, which costs a plan each. */
  otherTools: 120,
} as const;

/** Debounce after a key in a text or a field. */
export const TYPING = {
  /** Before the panels of a text follow: cursor and prompts would jump with each key. */
  panels: 80,
  /** Before a text that the page cannot plan at once is calculated: a pause within a word is shorter. */
  rest: 150,
  /** The same for a long text, whose calculation costs more than the pause. */
  longRest: 700,
  /** A text is long from this length, blocks. */
  long: 1500,
  /** Before a work is written to the device, so that writing never delays the picture. */
  keep: 80,
} as const;

/** When a work has been opened or changed without harm to the page. */
export const OPENING = {
  /** After the frame of its result: the body and the lists are drawn in the frames that follow. */
  drawn: 300,
  /** Without a result, as of a program that is not complete: longer than a slow device fetches the planner. */
  withoutResult: 10_000,
} as const;

/** Delay before a calculation is announced. */
export const ANNOUNCE_AFTER = {
  /** The mark of a shorter check would only flicker. */
  checking: 300,
  /** A shorter calculation is not worth a message. */
  working: 700,
  /** Over a path whose check already has its mark. */
  workingOverPath: 4000,
} as const;

/** When the browser is taken to be idle. */
export const IDLE = {
  /** Without idle callbacks: delay after the page was shown, by then it has been drawn. */
  unknown: 1200,
  /** During animations no browser reports a long idle period: this many calm frames in a row count as one, frames. */
  calmPictures: 8,
  /** A frame is calm if it leaves this much of its time. */
  calm: 6,
} as const;

/** How long notices stay that leave by themselves. */
export const NOTICES = {
  /** A change elsewhere is read and undone within this; its document keeps the undo. */
  change: 10_000,
} as const;
