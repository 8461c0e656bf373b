import { proxy, type Remote } from "comlink";
import { fileKey } from "../../program/state/program-files.ts";
import type { ShopTools } from "../../program/tools/read-tools.ts";
import type { Control } from "../../program/tools/plane-types.ts";
import { afterPicture } from "../base/after-picture.ts";
import { machineAtHand, useMachineReader } from "./machine-reader.ts";
import { printedText } from "../document/printed.ts";
import { readJob } from "../document/reading.ts";
import { untilHere } from "../base/parts.ts";
import { notice } from "../base/notices.ts";
import { useSettings } from "../base/settings/settings.ts";
import { useEditor, type Editor } from "../document/store.ts";
import { useTools } from "../document/tool-store.ts";
import { byAndBy, whileTyping } from "../base/typing.ts";
import { controlInUse, machineInUse, toolTable } from "../document/work-tools.ts";
import { filesOf, type ProgramWork, type WorkFile } from "../document/work.ts";
import { fetchPlan, forgetPace, notePace, planNow, planSoon, plansBehindDigit, plansLong } from "./page-plan.ts";
import { pauseInTyping } from "./quiet.ts";
import { simulationOf } from "./proved.ts";
import { rapidOf, USUAL_RAPID, type Request } from "./request.ts";
import { askAgain, stopWorker } from "./worker-life.ts";
import type { Engine } from "./worker.ts";
import {
  atStage,
  calculationStopped,
  forgetOutcome,
  pause,
  showBeginning,
  takeOutcome,
  takePlanned,
  useOutcome,
  type Outcome,
  type Planned,
  type Stage,
} from "./outcome.ts";

let version = 0;
/**
 * Answers up to this version belong to a work that was left: one that comes late must not stand under the name of the
 * next.
 */
let left = 0;
/**
 * A request with the very files that it was made of, and its run, where the page has made it: neither comes back from
 * the worker.
 */
interface Wanted {
  readonly request: Request & { readonly files?: readonly WorkFile[] };
  readonly planned: Planned | null;
}
let waiting: Wanted | null = null;
let busy = false;

const CANCELLED = new Error("the operator stopped the calculation");
const LEFT = new Error("the work was left");
/**
 * What is left is given up after this time, so that the next work does not wait for it; most are done sooner than a
 * worker starts, ms.
 */
const GIVEN_UP_AFTER = 400;
let running: Wanted | null = null;
let cancel: (why: Error) => void = () => undefined;

/** The last answer of the worker: the marks of its simulation are not sent again. */
let answered: Pick<Outcome, "version" | "simulation"> | null = null;

/** What the worker says, unless nobody waits for it any more. */
const answerOf = <T>(question: (engine: Remote<Engine>) => Promise<T>): Promise<T> =>
  Promise.race([
    untilHere(() => askAgain(question)),
    new Promise<never>((_, reject) => {
      cancel = reject;
    }),
  ]);

/** Tells what the worker begins, of the open work while it is that. */
const telling = ({ version }: Request, tells: (stage: Stage) => boolean = () => true) =>
  proxy((stage: Stage) => {
    if (busy && version > left && tells(stage)) atStage(stage);
  });

/** The answer to a request. A run that is here already is not sent again. */
async function outcomeOf({ request, planned }: Wanted): Promise<Outcome> {
  const made = await answerOf(async (engine): Promise<Outcome> => {
    if (!planned) return await engine.update(request, telling(request));
    const proved = await engine.proved(
      request,
      answered?.version ?? null,
      telling(request, (stage) => stage === "proving"),
    );
    return { ...planned, simulation: simulationOf(proved, planned.run, answered) };
  });
  answered = made;
  return { ...made, ...ofWork(request) };
}

/** Has the worker plan what it takes long to prove: the path is seen before that. */
async function plannedFirst(wanted: Wanted): Promise<Wanted> {
  const { request } = wanted;
  if (wanted.planned || !plansLong(request) || isVeiled()) return wanted;
  const planned = { ...(await answerOf((engine) => engine.planned(request, telling(request)))), ...ofWork(request) };
  if (request.version > left) byAndBy(() => takePlanned(planned));
  return { request, planned };
}

const ofWork = ({ files, skipMarked }: Wanted["request"]) => ({
  ...(files && { files }),
  ...(skipMarked !== undefined && { skipMarked }),
});

/** Of a text longer than this its beginning is shown first, which is this long, characters. */
const [LONG_TEXT, BEGINNING] = [1_000_000, 300_000];
const beginningOf = (text: string): string => text.slice(0, text.lastIndexOf("\n", BEGINNING) + 1);

/** The picture of the first blocks is there soon, while that of the whole is made. */
async function showFirst({ request }: Wanted): Promise<void> {
  if (request.text.length < LONG_TEXT || useOutcome.getState().shown) return;
  const first = await outcomeOf({ request: { ...request, text: beginningOf(request.text) }, planned: null });
  if (request.version > left) showBeginning(first);
}

/** Whether the run of the open work waits for what its task asks first. */
const isVeiled = (): boolean => {
  const { job, program } = useEditor.getState();
  return (job ?? program)?.task?.veiled ?? false;
};

/** Calculates what waits; while one calculation runs only the newest request waits. */
async function work(): Promise<void> {
  if (busy) return;
  busy = true;
  while (waiting) {
    const wanted = waiting;
    const { version } = wanted.request;
    waiting = null;
    running = wanted;
    atStage("reading");
    try {
      await showFirst(wanted);
      const ready = await plannedFirst(wanted);
      // What is typed meanwhile is planned before anything is proved.
      if (waiting && ready !== wanted) continue;
      const made = await outcomeOf(ready);
      const outcome = isVeiled() ? (await untilHere(() => import("./veil.ts"))).veil(made) : made;
      await pauseInTyping();
      if (version > left) {
        notePace(wanted.request, outcome.pace);
        byAndBy(() => takeOutcome(outcome));
      }
    } catch (error) {
      stopWorker();
      if (error !== LEFT) calculationStopped();
      if (error !== LEFT && error !== CANCELLED) notice("engineFailed");
    }
  }
  busy = false;
  running = null;
  atStage(null);
}

/** Takes back what is to be planned behind the picture of a digit, or bit by bit; null while nothing is. */
let callOffPlan: (() => void) | null = null;

function forgetPlan(): void {
  callOffPlan?.();
  callOffPlan = null;
}

/**
 * A changed work is calculated: the page plans it at once where that is quickly done, and the worker proves it. What
 * takes the page longer is planned behind the picture of the digit, and what waits behind that; of several digits in a
 * row only the last is. What would halt the page is planned bit by bit.
 */
function want(request: Wanted["request"]): void {
  forgetPlan();
  callOffPlan = isVeiled()
    ? null
    : planSoon(request, (made) => {
        callOffPlan = null;
        whileTyping(() => take(request, made));
      });
  if (!callOffPlan && !plansBehindDigit()) return plan(request);
  if (!busy) atStage("reading");
  if (callOffPlan) return;
  callOffPlan = afterPicture(() => {
    const timer = setTimeout(() => {
      callOffPlan = null;
      whileTyping(() => plan(request));
    });
    callOffPlan = () => clearTimeout(timer);
  });
}

const plan = (request: Wanted["request"]): void => take(request, isVeiled() ? null : planNow(request));

function take(request: Wanted["request"], made: Planned | null): void {
  const planned = made && { ...made, ...ofWork(request) };
  if (planned) takePlanned(planned);
  waiting = { request, planned };
  // What the page has planned is drawn before it is handed to the worker, which takes a copy.
  if (!planned) return void work();
  if (!busy) atStage("reading");
  afterPicture(() => void work());
}

/** Ends a calculation that takes too long; text and last picture stay. */
export function cancelCalculation(): void {
  waiting = null;
  forgetPlan();
  cancel(CANCELLED);
}

/** Calculates what is open once more. */
export function calculateAgain(): void {
  last = null;
  follow(useEditor.getState());
}

let last: {
  readonly text: string;
  readonly table: ShopTools;
  readonly rapid: number;
  readonly control: Control;
  readonly machine: string;
  readonly cycle: number | null;
  readonly work: string | null;
  readonly program?: ProgramWork;
} | null = null;

/** Another work, or none: nothing is known of it, and what is still being calculated is not of it. */
function leave(): void {
  last = null;
  waiting = null;
  forgetPlan();
  left = version;
  const request = running;
  if (request)
    setTimeout(() => {
      if (request === running) cancel(LEFT);
    }, GIVEN_UP_AFTER);
  forgetPace();
  forgetOutcome();
}

const isSameProgram = (a: ProgramWork, b: ProgramWork | undefined): boolean =>
  a.text === b?.text &&
  a.name === b.name &&
  filesOf(a) === filesOf(b) &&
  (a.skipMarked ?? false) === (b.skipMarked ?? false);

/** A whole program is calculated as it stands, right or wrong. */
function followProgram(program: ProgramWork, name: string | null): void {
  const isOther = last?.program && fileKey(last.program.name) !== fileKey(program.name);
  if (last && (last.cycle !== null || last.work !== name || isOther)) leave();
  const table = toolTable();
  const [control, machine] = [controlInUse(), machineInUse()];
  if (
    last &&
    isSameProgram(program, last.program) &&
    last.table === table &&
    last.control === control &&
    last.machine === machine
  )
    return;
  const data = machineAtHand(machine);
  if (data === undefined) return;
  pause(false);
  const { text, skipMarked = false } = program;
  last = { text, table, rapid: USUAL_RAPID, control, machine, cycle: null, work: name, program };
  version += 1;
  want({
    version,
    text,
    name: program.name,
    files: filesOf(program),
    skipMarked,
    table,
    rapid: USUAL_RAPID,
    control,
    machine: data,
  });
}

function follow({ job, program, work: name }: Editor): void {
  if (program) return followProgram(program, name);
  const read = job && readJob(job);
  if (!job || !read) return leave();
  if (last && (last.cycle !== job.cycle || last.work !== name)) leave();
  if (!read.reading.values) {
    // What waits is not calculated: should the same values come again, it is.
    if (waiting || callOffPlan) last = null;
    waiting = null;
    forgetPlan();
    pause(true);
    return;
  }
  pause(false);
  const text = printedText(job);
  const rapid = rapidOf(job);
  const table = toolTable();
  const [control, machine] = [controlInUse(), machineInUse()];
  const isSame = last?.text === text && last.table === table && last.rapid === rapid && last.control === control;
  const data = machineAtHand(machine);
  if ((isSame && last?.machine === machine) || data === undefined) return;
  last = { text, table, rapid, control, machine, cycle: job.cycle, work: name };
  version += 1;
  want({ version, text, table, rapid, control, machine: data });
}

/** From now on each change of the work, of the tool table or of the control is calculated. */
export function startEngine(): () => void {
  const now = () => follow(useEditor.getState());
  now();
  const stops = [
    fetchPlan(),
    useEditor.subscribe(now),
    useTools.subscribe(now),
    useSettings.subscribe(now),
    useMachineReader.subscribe(now),
  ];
  return () => stops.forEach((stop) => stop());
}
