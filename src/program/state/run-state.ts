import type { Block } from "../../nc/program.ts";
import type { StatementOf } from "../../nc/statement.ts";
import type { Label } from "../../nc/words.ts";
import { AppendSet, PersistentMap } from "../values/persistent.ts";
import { NOTHING_KNOWN, type ParameterState, type Locals } from "../values/known-values.ts";
import type { FreeRun } from "./free-contour.ts";
import { emptyLog, Log, type LogState } from "./log.ts";
import type { CutIntent } from "./intended-cuts.ts";
import { AT_START, NOT_PLACED, type Modal, type ToolPosition } from "./modal.ts";
import type { Guide } from "./plane-chain.ts";
import type { RunInput } from "./run-input.ts";
import type { TracedBlank } from "./tracing.ts";
import type { Unit } from "./units.ts";

/** Where a call goes on when it comes back. */
export interface Return {
  readonly on: number;
  /** Of a called program: the calling program's state. */
  readonly caller: { readonly unit: Unit; readonly inch: boolean; readonly locals: Locals } | null;
  /** The enclosing call. */
  readonly outer: Return | null;
}

/** How a program ended: the block and its word; no word when the text ran out or a limit was reached. */
export interface Ending {
  readonly index: number;
  readonly word: string | null;
}

/** State that decides which block comes next. */
export interface Flow {
  /** Innermost open call. */
  readonly returns: Return | null;
  /** Remaining repetitions, by the block of their call. */
  readonly repeats: ReadonlyMap<number, number>;
  /** A jump depended on an unknown value: the control may continue elsewhere. */
  readonly hasUnknownJump: boolean;
  /** A reported fault stopped the program, or removed its end. */
  readonly isFaultReported: boolean;
  /** Null while the program runs. */
  readonly ending: Ending | null;
}

/** State of a run between two blocks: modal state, findings, steps. Immutable. */
export interface RunState {
  /** Blocks of the main program, followed by those of called programs. */
  readonly blocks: readonly Block[];
  /** The block that comes next. */
  readonly next: number;
  readonly flow: Flow;
  /** The text that runs. */
  readonly unit: Unit;
  /** Program called by the last block: it runs next. */
  readonly enters: Unit | null;
  readonly now: Modal;
  /** Tool position. */
  readonly place: ToolPosition;
  readonly known: ParameterState;
  readonly log: LogState;
  /** Radii of TOOL DEF lines, mm. */
  readonly radii: PersistentMap<Label, number>;
  /** Blocks of definitions reached, and of those called. */
  readonly definitions: AppendSet<number>;
  readonly called: AppendSet<number>;
  /** Contours under construction, of turning and milling. */
  readonly turnGuide: Readonly<Guide>;
  readonly millGuide: Readonly<Guide>;
  /** The blank that is traced, and the first step that has not cut it yet. */
  readonly traced: { readonly blank: TracedBlank; readonly next: number } | null;
  /** The free contour that is being run. */
  readonly freeRun: FreeRun | null;
  /** FPOL that counts until another does. */
  readonly freePole: StatementOf<"free"> | null;
  /** Comment on the last cut. */
  readonly cutIntent: CutIntent | null;
  /** Blocks executed, those of contours that cycles read included. */
  readonly executed: number;
  /** Blocks up to the farthest one executed. */
  readonly farthest: number;
  /** A limit was reached: the run ends. */
  readonly full: boolean;
}

/** Before the first block. */
export function startOf(input: RunInput): RunState {
  const log = new Log(input, emptyLog());
  log.reportDuplicateLabels(input.unit);
  return {
    blocks: input.program.blocks,
    next: 0,
    flow: { returns: null, repeats: new Map(), hasUnknownJump: false, isFaultReported: false, ending: null },
    unit: input.unit,
    enters: null,
    now: AT_START,
    place: NOT_PLACED,
    known: NOTHING_KNOWN,
    log: log.state,
    radii: new PersistentMap(),
    definitions: new AppendSet(),
    called: new AppendSet(),
    turnGuide: { chain: null, here: null },
    millGuide: { chain: null, here: null },
    traced: null,
    freeRun: null,
    freePole: null,
    cutIntent: null,
    executed: 0,
    farthest: 0,
    full: false,
  };
}
