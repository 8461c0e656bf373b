/*
 * How long the page waits, and how long something may take, in one table: each number was measured (docs/performance.md)
 * and stands with its reason. All are ms unless another unit is named.
 */

/** What planning on the page may cost. */
export const PLANNING = {
  /** Most plans take a tenth of this; the way through the worker takes several times as long. */
  onPage: 60,
  /** A digit does not wait longer for its path: it is drawn first then. */
  withDigit: 60,
  /** Texts up to this length are tried on the page before their pace is known, characters. */
  short: 20_000,
  /** A program whose first run took longer than this is not planned ahead: the page would halt at rest. */
  warmUp: 600,
  /** The same of a long text, which is planned in slices. */
  longWarmUp: 4000,
  /** Longer texts are left to the worker: their first plan would still be in slices when the operator is done, characters. */
  longest: 400_000,
  /** A slice at rest fits into a frame beside everything else. */
  slice: 6,
  /** While somebody waits for its path a slice may take more than a frame. */
  sliceWaitedFor: 20,
  /** A text whose first run took longer is planned by the worker: nobody waits so long for slices. */
  waitedFor: 1500,
} as const;

/** What the calculation waits for. */
export const CALCULATING = {
  /** Rest of the browser before something is planned ahead: shorter ones are pauses between two pictures. */
  rest: 25,
  /** The calculation of a work that was left is stopped after this, since the next one waits: a new worker takes longer. */
  leftWork: 400,
  /** A worker that does not answer has lost its way: the longest programs take a tenth of this on a desk. */
  answer: 120_000,
  /** Between two looks whether a new worker holds its lock: it takes that long to start. */
  lock: 200,
  /** Rest after a change before all tools are tried, which costs a plan for each. */
  otherTools: 120,
} as const;

/** Rest after a key in a text or a field. */
export const TYPING = {
  /** Before the panels of a text follow: cursor and prompts would jump with each key. */
  panels: 80,
  /** Before a text that the page does not plan at once is calculated: a pause within a word is shorter. */
  rest: 150,
  /** The same of a long text, whose calculation costs more than the pause. */
  longRest: 700,
  /** A text is long from so many blocks on, blocks. */
  long: 1500,
  /** Before a work is written to the device, so that writing never delays the picture. */
  keep: 80,
} as const;

/** From when on a calculation is announced. */
export const ANNOUNCED = {
  /** A mark for what is done sooner would only flicker. */
  checking: 300,
  /** What is done sooner is not worth a word. */
  working: 700,
  /** Over a path whose proof has a mark of its own already. */
  workingOverPath: 4000,
} as const;

/** When the browser is taken to be idle. */
export const IDLE = {
  /** Where a browser cannot tell, this is waited after the page was shown: by then it has been drawn. */
  unknown: 1200,
  /** Beside something that moves no browser reports a long rest: so many calm pictures in a row are one as well, pictures. */
  calmPictures: 8,
  /** A picture is calm when it leaves so much of its time. */
  calm: 6,
} as const;
