import { isolateHistory, redo, undo, undoDepth } from "@codemirror/commands";
import { Annotation, EditorState, type StateCommand, type TransactionSpec } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { readingOf, type Reading } from "../../../nc/reread.ts";
import type { Program } from "../../../nc/program.ts";
import { fileKey } from "../../../program/state/program-files.ts";
import { calculation as calculating } from "../../calculation/calculation.ts";
import { takeKeptSteps, textKeepers } from "../../records/keep-steps.ts";
import { noteTyped } from "../../records/journal.ts";
import { noteOpening } from "../../records/opening.ts";
import { documentOfWork } from "../../document/documents.ts";
import { closeStep, continuesStep, recordStep, useSteps, type HistoryStep } from "../../document/steps.ts";
import { setProgram, useEditor } from "../../document/store.ts";
import { fileOf, withText, type ProgramWork, type WorkFile } from "../../document/work.ts";
import { changesBetween, type TextChange } from "./block-edits.ts";
import { editorExtensions } from "./editor-extensions.ts";
import { forgetHalfTyped, watchText } from "./half-typed.ts";
import {
  changeInFile,
  fileText,
  textKey,
  restoredState,
  serializedState,
  type TextWithHistory as Text,
} from "./text-with-history.ts";
import { lineEndsOf, toEditor, type LineEnds } from "./line-ends.ts";
import {
  blockRange,
  cursorBlock,
  isRead,
  parameterAt,
  parameterOffset,
  readFurther,
  readingField,
} from "./reading-field.ts";
import { numberTyped } from "./typed-numbers.ts";
import { createTextView, type TextUpdate, type TextView } from "./text-view.ts";
import { onShown, shownFile, showFile } from "../../document/shown-file.ts";
import { createDeferredStore } from "../../base/typing.ts";
import { restartable } from "../../base/once.ts";
import { TYPING } from "../../base/waits.ts";

/** State for the panels: the blocks, and the open one. */
export interface Session {
  readonly reading: Reading;
  /** Index of the open block; -1 in an empty program. */
  readonly index: number;
  /** The Q parameter on the cursor's line. */
  readonly parameter: string | null;
  /** Incremented when the operator opens a block. */
  readonly opened: number;
  /** Incremented when a block is clicked in the text. */
  readonly pointed: number;
  /** Incremented when another text replaces the one in the editor. */
  readonly put: number;
}

/** Marks a change by a dialog: the panels update at once, and the text does not scroll. */
const dialogEdit = Annotation.define<boolean>();

const none: Session = { reading: readingOf(""), index: -1, parameter: null, opened: 0, pointed: 0, put: 0 };
export const useSession = createDeferredStore<Session>(() => none);

/** False before a text is opened; having no blocks then does not mean an empty program. */
export const ofText = ({ reading }: Session): boolean => reading !== none.reading;

/** Texts that stay cached after they were left, besides those of works with a history. */
const CACHED_TEXTS = 8;
const texts = new Map<string, Text>();

let view: TextView | null = null;
let open: Text | null = null;
const [panels, calculation, reading] = [restartable(), restartable(), restartable()];

/** The text in the editor as its file has it; null when none is open. */
export const sessionText = (): string | null => (open ? fileText(open) : null);

/** Notes a change on the device at once: a long text is handed to its work only when nobody types. */
function noteUnflushed({ transactions }: TextUpdate): void {
  if (!open || open.work !== useEditor.getState().work) return;
  for (const { changes } of transactions) open.unflushed = open.unflushed?.compose(changes) ?? changes;
  if (open.unflushed === null) return;
  noteOpening(open.work);
  noteTyped(open.work, open.file, changeInFile(open, open.unflushed));
}

/** Flushes the text to saving and calculation. */
export function flushText(): void {
  calculation.stop();
  if (open) open.unflushed = null;
  const { program, work } = useEditor.getState();
  if (!open || !program || open.work !== work) return;
  const text = fileText(open);
  const before = fileOf(program, open.file)?.text;
  if (before === text) noteTyped(open.work, open.file, null);
  else if (before !== undefined) setProgram(withText(program, open.file, text));
}

/** One undo or redo step of a text. A text that is not in the editor is shown. */
function stepHistory(text: Text, command: StateCommand): boolean {
  if (texts.get(textKey(text)) !== text || useEditor.getState().work !== text.work) return false;
  if (view && open === text) return command(view.get());
  flushText();
  const { program } = useEditor.getState();
  if (!program || !fileOf(program, text.file)) return false;
  const done = command({ state: text.state, dispatch: (tr) => (text.state = tr.state) });
  if (!done) return false;
  setProgram(withText(program, text.file, fileText(text)));
  showFile(text.file);
  return true;
}

/** Adds typing to the page's history when the history of the text starts a new step. */
function noteTyping(text: Text, before: EditorState): void {
  const more = undoDepth(text.state) > undoDepth(before);
  if (more) recordStep(stepOf(text));
}

/** The programs before and after the next step of a text: done on a copy of its state. */
function programsAround({ state }: Text, command: StateCommand): readonly [Program, Program] | null {
  let after: EditorState | null = null;
  command({ state, dispatch: (tr) => (after = tr.state) });
  const programOf = (of: EditorState) => of.field(readingField).program;
  return after && [programOf(state), programOf(after)];
}

const stepOf = (text: Text): HistoryStep => ({
  document: documentOfWork(text.work),
  of: text,
  back: () => stepHistory(text, undo),
  forth: () => stepHistory(text, redo),
  file: text.file,
  programs: (way) => {
    const [now, then] = programsAround(text, way === "past" ? undo : redo) ?? [];
    return now && then ? (way === "past" ? [then, now] : [now, then]) : null;
  },
});

function show(opened: boolean): void {
  panels.stop();
  if (!view || !open) return;
  const { state } = open;
  const before = useSession.getState();
  const next = {
    reading: state.field(readingField),
    index: cursorBlock(state),
    parameter: parameterAt(state, state.selection.main.head),
  };
  if (before.reading === next.reading && before.index === next.index && before.parameter === next.parameter) return;
  const moved = opened && (before.index !== next.index || before.parameter !== next.parameter);
  useSession.setState({ ...next, opened: before.opened + (moved ? 1 : 0) });
}

function onChange(update: TextUpdate): void {
  if (open) open.state = update.state;
  watchText(update);
  const typed =
    update.docChanged && update.transactions.some((tr) => tr.isUserEvent("input.type") || tr.isUserEvent("delete"));
  const byDialog = update.transactions.some((tr) => tr.annotation(dialogEdit));
  if (update.docChanged) {
    const long = update.state.field(readingField).program.blocks.length > TYPING.long;
    if (long) calculating.typed(TYPING.longRest);
    else if (typed && !byDialog) calculating.typed(TYPING.rest);
    calculation.start(flushText, long ? TYPING.longRest : TYPING.rest);
    if (open && !update.transactions.some((tr) => tr.isUserEvent("undo") || tr.isUserEvent("redo")))
      noteTyping(open, update.startState);
  }
  // A short program is planned on the page, so its text is flushed at once.
  if (update.docChanged && calculating.plansOnPage(update.state.doc.length)) flushText();
  else if (update.docChanged) noteUnflushed(update);
  if (!byDialog && !view?.get().composing) {
    const changes = numberTyped(update);
    // The number belongs to the typing before it, in one step of undo.
    if (changes.length > 0) return view?.get().dispatch({ changes: [...changes], userEvent: "input.type.compose" });
  }
  const more = update.docChanged || (isRead(update.state) && !isRead(update.startState));
  if (!more && !update.selectionSet) return;
  if (typed && !byDialog) panels.start(() => show(true), TYPING.panels);
  else show(!byDialog);
  if (update.transactions.some((tr) => tr.isUserEvent("select.pointer")))
    useSession.setState((s) => ({ pointed: s.pointed + 1 }));
}

const extensionsOf = (ends: LineEnds) => editorExtensions(ends === "mixed");

/** The text of a file, with its cached history if the text is unchanged. */
function textOf({ name, text }: WorkFile, work: string): Text {
  const file = fileKey(name);
  const held = texts.get(textKey({ work, file }));
  if (held && fileText(held) === text) return held;
  const ends = lineEndsOf(text);
  return {
    work,
    file,
    ends,
    unflushed: null,
    state: EditorState.create({ doc: toEditor(text, ends), extensions: extensionsOf(ends) }),
  };
}

/** Returns the text of the shown file and caches it. */
function cacheShownText(program: ProgramWork, work: string): Text {
  const text = textOf(shownFile(program), work);
  forgetHalfTyped();
  texts.delete(textKey(text));
  texts.set(textKey(text), text);
  const { histories } = useSteps.getState();
  for (const [oldest, { work: of }] of texts)
    if (texts.size > CACHED_TEXTS && of !== work && !histories.has(documentOfWork(of))) texts.delete(oldest);
  return text;
}

/** Reads a long text piece by piece, so that the page stays responsive; its lists are made once all of it is read. */
function readToEnd(): void {
  reading.stop();
  if (!open || isRead(open.state)) return;
  reading.start(() => {
    view?.get().dispatch(readFurther);
    readToEnd();
  });
}

/** Reads the whole text now, to show a place far down. */
export function readWhole(): void {
  while (view && open && !isRead(open.state)) view.get().dispatch(readFurther);
}

textKeepers.add((work) =>
  [...texts.values()].flatMap((text) =>
    text.work === work ? [{ file: text.file, state: serializedState(text.state) }] : [],
  ),
);

/** Restores the texts of a work with their histories and cursors after a reload. */
function restoreTexts(program: ProgramWork, work: string): void {
  takeKeptSteps((kept) => {
    for (const { file, state } of kept) {
      const found = fileOf(program, file);
      const text = found && textOf(found, work);
      if (!text) continue;
      text.state = restoredState(state, text.state, extensionsOf(text.ends));
      texts.set(textKey(text), text);
    }
    return (file) => {
      const text = texts.get(textKey({ work, file }));
      return text ? stepOf(text) : null;
    };
  });
}

/** Opens a program in an editor and closes the previous one. */
export function openSession(program: ProgramWork, work: string): EditorView {
  closeSession();
  restoreTexts(program, work);
  open = cacheShownText(program, work);
  view = createTextView(open.state, onChange);
  show(true);
  readToEnd();
  return view.get();
}

/** Loads the shown file into the editor if it is another file or was changed elsewhere. */
function putShown(): void {
  const { program, work } = useEditor.getState();
  if (!view || !open || !program || open.work !== work) return;
  const shown = shownFile(program);
  if (fileKey(shown.name) === open.file && shown.text === fileText(open)) return;
  closeStep();
  open = cacheShownText(program, open.work);
  view.put(open.state);
  view.get().dispatch({ effects: EditorView.scrollIntoView(open.state.selection.main.head, { y: "center" }) });
  show(true);
  readToEnd();
  useSession.setState((s) => ({ put: s.put + 1 }));
}

/** Keeps the editor in step with the shown file when another one is chosen or it changes elsewhere. */
export function followShown(): () => void {
  const stops = [
    onShown(() => {
      flushText();
      putShown();
    }),
    useEditor.subscribe((now, before) => {
      if (now.program !== before.program) putShown();
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

export function closeSession(): void {
  if (!view) return;
  flushText();
  panels.stop();
  reading.stop();
  view.destroy();
  view = null;
  open = null;
  useSession.setState(none);
}

export const sessionView = (): EditorView | null => view?.get() ?? null;
/** DOM element of the editor, even if it does not show the newest text yet. */
export const sessionDom = (): HTMLElement | null => view?.dom ?? null;

/** Changes the text from a dialog. Successive changes at the same place are one step of undo. */
export function dispatchEdit(spec: TransactionSpec, place: string | null): void {
  if (!view || !open) return;
  const on = continuesStep(place);
  view.edit(
    open.state.update({
      ...spec,
      annotations: [dialogEdit.of(true), ...(on ? [] : [isolateHistory.of("before")])],
      // The history merges a composition into one step, however long it takes.
      userEvent: on ? "input.type.compose" : "input.dialog",
    }),
  );
}

/** Replaces parts of the text as typing does, in one step of undo. */
export function replaceText(changes: readonly TextChange[]): void {
  sessionView()?.dispatch({
    changes: [...changes],
    annotations: isolateHistory.of("full"),
    userEvent: "input.replace",
  });
}

/** Replaces the open program as one step of undo; only the differences change in the text. */
export function editProgram(next: Program, place: string | null, openIndex: number | null = null): void {
  if (!open) return;
  const changes = changesBetween(open.state.field(readingField).program, next);
  if (changes.length > 0) dispatchEdit({ changes: [...changes] }, place);
  if (openIndex !== null) openBlock(openIndex);
}

/** Changes the shown text while another page replaces its editor, as one step of undo. */
export function editClosedText(change: (program: Program) => Program): void {
  const { program, work } = useEditor.getState();
  if (view || !program || work === null) return;
  const text = cacheShownText(program, work);
  while (!isRead(text.state)) text.state = text.state.update(readFurther).state;
  const before = text.state,
    now = before.field(readingField).program;
  const changes = changesBetween(now, change(now));
  if (changes.length === 0) return;
  text.state = before.update({
    changes: [...changes],
    annotations: isolateHistory.of("full"),
    userEvent: "input.dialog",
  }).state;
  closeStep();
  noteTyping(text, before);
  setProgram(withText(program, text.file, fileText(text)));
}

/** Opens a block: moves the cursor there and scrolls it into view. */
export function openBlock(index: number, parameter: string | null = null, byDialog = false): void {
  if (!view || !open) return;
  const range = blockRange(open.state, index);
  if (!range) return;
  const at = parameter === null ? range.from : parameterOffset(open.state, range, parameter);
  view.get().dispatch({
    selection: { anchor: at },
    effects: EditorView.scrollIntoView(at, { y: "nearest", yMargin: 60 }),
    ...(byDialog && { annotations: dialogEdit.of(true) }),
  });
}

/** Opens a block of a program that is about to be shown. */
export function openBlockWhenRead(index: number, opened: () => void): void {
  const stop = useSession.subscribe((now) => {
    if (!ofText(now) || !view) return;
    stop();
    openBlock(index);
    opened();
  });
}
