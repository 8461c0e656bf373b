import { isolateHistory, redo, undo, undoDepth } from "@codemirror/commands";
import { Annotation, EditorState, type StateCommand, type TransactionSpec } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { readingOf, type Reading } from "../../../nc/reread.ts";
import type { Program } from "../../../nc/program.ts";
import { fileKey } from "../../../program/state/program-files.ts";
import { calculation as calculating } from "../../calculation/calculation.ts";
import { takeKeptSteps, textKeepers } from "../../records/keep-steps.ts";
import { closeStep, goesOn, note, type HistoryStep } from "../../document/steps.ts";
import { setProgram, useEditor } from "../../document/store.ts";
import { fileOf, withText, type ProgramWork, type WorkFile } from "../../document/work.ts";
import { changesBetween } from "./block-edits.ts";
import { editorExtensions } from "./editor-extensions.ts";
import { forgetHalf, watchText } from "./half-typed.ts";
import { fileText, heldAs, withHistory, writtenState, type HeldText as Text } from "./held-text.ts";
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
import { createTextView, type TextUpdate, type TextView } from "./text-view.ts";
import { onShown, shownFile, showFile } from "../../document/shown-file.ts";
import { heldWhileTyping } from "../../base/typing.ts";
import { restartable } from "../../base/once.ts";
import { TYPING } from "../../base/waits.ts";

/** What the panels beside the text show: the blocks, and which one is open. */
export interface Session {
  readonly reading: Reading;
  /** Index of the open block; -1 in an empty program. */
  readonly index: number;
  /** The Q parameter whose line the cursor stands in. */
  readonly parameter: string | null;
  /** Counts up with each block that was opened by the operator. */
  readonly opened: number;
  /** Counts up with each block that was pointed at in the text. */
  readonly pointed: number;
  /** Counts up with each text that is put into the editor in place of another. */
  readonly put: number;
}

/** Marks a change that a dialog made: the panels follow at once, and the text keeps its place. */
const dialogEdit = Annotation.define<boolean>();

const none: Session = { reading: readingOf(""), index: -1, parameter: null, opened: 0, pointed: 0, put: 0 };
export const useSession = heldWhileTyping<Session>(() => none);

/** Whether the blocks are those of a text: before one is opened there are none, which is no empty program. */
export const ofText = ({ reading }: Session): boolean => reading !== none.reading;

/** Texts that are held after they were left. */
const HELD = 8;
const texts = new Map<string, Text>();

let view: TextView | null = null;
let open: Text | null = null;
const [panels, calculation, reading] = [restartable(), restartable(), restartable()];

/** The text in the editor as its file has it; null when none is open. */
export const sessionText = (): string | null => (open ? fileText(open) : null);

/** Hands the text to keeping and calculation now. */
export function handOverText(): void {
  calculation.stop();
  const { program, work } = useEditor.getState();
  if (!open || !program || open.work !== work) return;
  const text = fileText(open);
  const before = fileOf(program, open.file)?.text;
  if (before === undefined || before === text) return;
  setProgram(withText(program, open.file, text));
}

/** Goes one step through the history of a text, in its editor when it is open; another one is opened to be seen. */
function go(text: Text, command: StateCommand): boolean {
  if (texts.get(heldAs(text)) !== text || useEditor.getState().work !== text.work) return false;
  if (view && open === text) return command(view.get());
  handOverText();
  const { program } = useEditor.getState();
  if (!program || !fileOf(program, text.file)) return false;
  const done = command({ state: text.state, dispatch: (tr) => (text.state = tr.state) });
  if (!done) return false;
  setProgram(withText(program, text.file, fileText(text)));
  showFile(text.file);
  return true;
}

/** Notes what was typed as a step of the page's history, where the text's own begins a new one. */
function noteTyping(text: Text, before: EditorState): void {
  const more = undoDepth(text.state) > undoDepth(before);
  if (more) note(stepOf(text));
}

const stepOf = (text: Text): HistoryStep => ({
  of: text,
  back: () => go(text, undo),
  forth: () => go(text, redo),
  file: text.file,
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
    calculation.start(handOverText, long ? TYPING.longRest : TYPING.rest);
    if (open && !update.transactions.some((tr) => tr.isUserEvent("undo") || tr.isUserEvent("redo")))
      noteTyping(open, update.startState);
  }
  // What the page plans at once is seen at once.
  if (update.docChanged && calculating.plansOnPage(update.state.doc.length)) handOverText();
  const more = update.state.field(readingField) !== update.startState.field(readingField);
  if (!more && !update.selectionSet) return;
  if (typed && !byDialog) panels.start(() => show(true), TYPING.panels);
  else show(!byDialog);
  if (update.transactions.some((tr) => tr.isUserEvent("select.pointer")))
    useSession.setState((s) => ({ pointed: s.pointed + 1 }));
}

const extensionsOf = (ends: LineEnds) => editorExtensions(ends === "mixed");

/** The text of a file, with the history it has when it was open before and is still the same. */
function textOf({ name, text }: WorkFile, work: string): Text {
  const file = fileKey(name);
  const held = texts.get(heldAs({ work, file }));
  if (held && fileText(held) === text) return held;
  const ends = lineEndsOf(text);
  return { work, file, ends, state: EditorState.create({ doc: toEditor(text, ends), extensions: extensionsOf(ends) }) };
}

/** Takes up the text that is to be shown, and holds it for later. */
function takeUp(program: ProgramWork, work: string): Text {
  const text = textOf(shownFile(program), work);
  forgetHalf();
  texts.delete(heldAs(text));
  texts.set(heldAs(text), text);
  for (const [oldest] of texts) if (texts.size > HELD) texts.delete(oldest);
  return text;
}

/** Reads a long text to its end, piece by piece, so that the page answers in between. */
function readToEnd(): void {
  reading.stop();
  if (!open || isRead(open.state)) return;
  reading.start(() => {
    view?.get().dispatch(readFurther);
    readToEnd();
  });
}

/** Reads the shown text to its end now: a place far down in it is to be shown. */
export function readWhole(): void {
  while (view && open && !isRead(open.state)) view.get().dispatch(readFurther);
}

textKeepers.add((work) =>
  [...texts.values()].flatMap((text) =>
    text.work === work ? [{ file: text.file, state: writtenState(text.state) }] : [],
  ),
);

/** Puts the texts of a work back with the histories and cursors that they had before the page was loaded again. */
function resumeTexts(program: ProgramWork, work: string): void {
  takeKeptSteps((kept) => {
    for (const { file, state } of kept) {
      const found = fileOf(program, file);
      const text = found && textOf(found, work);
      if (!text) continue;
      text.state = withHistory(state, text.state, extensionsOf(text.ends));
      texts.set(heldAs(text), text);
    }
    return (file) => {
      const text = texts.get(heldAs({ work, file }));
      return text ? stepOf(text) : null;
    };
  });
}

/** Opens a program in an editor; what was open before is left. */
export function openSession(program: ProgramWork, work: string): EditorView {
  closeSession();
  resumeTexts(program, work);
  open = takeUp(program, work);
  view = createTextView(open.state, onChange);
  show(true);
  readToEnd();
  return view.get();
}

/** Puts the text that is to be shown into the editor, where that is another file, or one that was changed elsewhere. */
function putShown(): void {
  const { program, work } = useEditor.getState();
  if (!view || !open || !program || open.work !== work) return;
  const shown = shownFile(program);
  if (fileKey(shown.name) === open.file && shown.text === fileText(open)) return;
  closeStep();
  open = takeUp(program, open.work);
  view.put(open.state);
  view.get().dispatch({ effects: EditorView.scrollIntoView(open.state.selection.main.head, { y: "center" }) });
  show(true);
  readToEnd();
  useSession.setState((s) => ({ put: s.put + 1 }));
}

/**
 * From now on the editor goes along when another file is to be shown, or the shown one changes elsewhere: it is
 * replaced, or undone.
 */
export function followShown(): () => void {
  const stops = [
    onShown(() => {
      handOverText();
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
  handOverText();
  panels.stop();
  reading.stop();
  view.destroy();
  view = null;
  open = null;
  useSession.setState(none);
}

export const sessionView = (): EditorView | null => view?.get() ?? null;
/** What its editor is on the page, whether or not it shows the newest text yet. */
export const sessionDom = (): HTMLElement | null => view?.dom ?? null;

/** Makes a change of the text by a dialog. Changes at the same place, one after the other, are one step of undo. */
export function dispatchEdit(spec: TransactionSpec, place: string | null): void {
  if (!view || !open) return;
  const on = goesOn(place);
  view.edit(
    open.state.update({
      ...spec,
      annotations: [dialogEdit.of(true), ...(on ? [] : [isolateHistory.of("before")])],
      // The history joins what goes on with a composition to its step, however long it takes.
      userEvent: on ? "input.type.compose" : "input.dialog",
    }),
  );
}

/** Puts a changed program in place of the open one, as one step of undo; only what differs changes in the text. */
export function editProgram(next: Program, place: string | null, openIndex: number | null = null): void {
  if (!open) return;
  const changes = changesBetween(open.state.field(readingField).program, next);
  if (changes.length > 0) dispatchEdit({ changes: [...changes] }, place);
  if (openIndex !== null) openBlock(openIndex);
}

/** Changes the text that would be shown, while another page stands in place of its editor: one step of undo. */
export function editUnshown(change: (program: Program) => Program): void {
  const { program, work } = useEditor.getState();
  if (view || !program || work === null) return;
  const text = takeUp(program, work);
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

/** Opens a block: the cursor goes there, and the text shows it. */
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
