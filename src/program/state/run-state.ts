import type { Block } from "../../nc/program.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { Label } from "../../nc/words.ts";
import { GrownSet, Table } from "../values/grown.ts";
import { NOTHING_KNOWN, type Known, type Locals } from "../values/known-values.ts";
import type { FreeRun } from "./free-contour.ts";
import { emptyLog, Log, type LogState } from "./log.ts";
import type { Said } from "./meant-cuts.ts";
import { AT_START, NOT_PLACED, type Modal, type Whereabouts } from "./modal.ts";
import type { Guide } from "./plane-chain.ts";
import type { RunInput } from "./run-input.ts";
import type { TracedBlank } from "./tracing.ts";
import type { Unit } from "./units.ts";

/** Where a call goes on when it comes back. */
export interface Return {
  readonly on: number;
  /** Of a program that was called: what it goes back to. */
  readonly caller: { readonly unit: Unit; readonly inch: boolean; readonly locals: Locals } | null;
  /** The call that it stands in. */
  readonly outer: Return | null;
}

/**
 * How a program came to its end: the block that ended it and its word, or none when the text ran out or a bound was
 * met.
 */
export interface Ending {
  readonly index: number;
  readonly word: string | null;
}

/** What decides which block comes next. */
export interface Flow {
  /** The innermost call that has not come back. */
  readonly returns: Return | null;
  /** Repetitions that are left, by the block of their call. */
  readonly repeats: ReadonlyMap<number, number>;
  /** A jump hung on a value that nobody knows: the control may have gone another way. */
  readonly guessed: boolean;
  /** A fault that has been told stopped the program, or took its end away. */
  readonly told: boolean;
  /** Null while the program runs. */
  readonly ending: Ending | null;
}

/** A run between two blocks: what is in force, what was said and done. Never changed in place. */
export interface RunState {
  /** The blocks of the program, and behind them those of the programs that it has called. */
  readonly blocks: readonly Block[];
  /** The block that comes next. */
  readonly next: number;
  readonly flow: Flow;
  /** The text that runs. */
  readonly unit: Unit;
  /** The program that the last block has called: it runs next. */
  readonly enters: Unit | null;
  readonly now: Modal;
  /** Where the tool stands. */
  readonly place: Whereabouts;
  readonly known: Known;
  readonly log: LogState;
  /** Radii of TOOL DEF lines, mm. */
  readonly radii: Table<Label, number>;
  /** Blocks of definitions that were taken up, and of those that were called. */
  readonly definitions: GrownSet<number>;
  readonly called: GrownSet<number>;
  /** The contours that turning and milling are gathering. */
  readonly turnGuide: Readonly<Guide>;
  readonly millGuide: Readonly<Guide>;
  /** The blank that is traced, and the first step that has not cut it yet. */
  readonly traced: { readonly blank: TracedBlank; readonly next: number } | null;
  /** The free contour that is being run. */
  readonly freeRun: FreeRun | null;
  /** FPOL that counts until another does. */
  readonly freePole: StatementOf<"free"> | null;
  /** What was said of the cut that was run last. */
  readonly said: Said | null;
  /** Blocks executed, those of contours that cycles read included. */
  readonly executed: number;
  /** A bound was met: nothing is run any more. */
  readonly full: boolean;
}

/** Before the first block. */
export function startOf(input: RunInput): RunState {
  const log = new Log(input, emptyLog());
  log.saySetTwice(input.unit);
  return {
    blocks: input.program.blocks,
    next: 0,
    flow: { returns: null, repeats: new Map(), guessed: false, told: false, ending: null },
    unit: input.unit,
    enters: null,
    now: AT_START,
    place: NOT_PLACED,
    known: NOTHING_KNOWN,
    log: log.state,
    radii: new Table(),
    definitions: new GrownSet(),
    called: new GrownSet(),
    turnGuide: { chain: null, here: null },
    millGuide: { chain: null, here: null },
    traced: null,
    freeRun: null,
    freePole: null,
    said: null,
    executed: 0,
    full: false,
  };
}
