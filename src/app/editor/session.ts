import { isolateHistory, redo, undo, undoDepth } from "@codemirror/commands";
import { EditorState, type StateCommand, type TransactionSpec } from "@codemirror/state";
import { EditorView, type ViewUpdate } from "@codemirror/view";
import { create } from "zustand";
import { readingOf, type Reading } from "../../nc/reread.ts";
import type { Program } from "../../nc/program.ts";
import { typingGoesOn } from "../engine/quiet.ts";
import { goesOn, note } from "../steps.ts";
import { setProgram, useEditor } from "../store.ts";
import type { ProgramWork } from "../work.ts";
import { changesBetween } from "./block-edits.ts";
import { dialogEdit } from "./dialog-edit.ts";
import { editorExtensions } from "./editor-extensions.ts";
import { fromEditor, lineEndsOf, toEditor, type LineEnds } from "./line-ends.ts";
import { blockRange, cursorBlock, isRead, parameterAt, readFurther, readingField } from "./reading-field.ts";

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
}

const none: Session = { reading: readingOf(""), index: -1, parameter: null, opened: 0, pointed: 0 };
export const useSession = create<Session>(() => none);

/** Rest after typing before panels follow, and before a text of this many blocks is calculated and kept, ms. */
const PANELS_REST = 80;
const REST = 150;
const LONG_REST = 700;
const LONG = 1500;

/** The text of a program with its own history. It outlives its editor, so that undo reaches it again when the program is opened again. */
interface Text {
  readonly work: string;
  readonly ends: LineEnds;
  state: EditorState;
}

/** Texts that are held after their program was left. */
const HELD = 5;
const texts = new Map<string, Text>();

let view: EditorView | null = null;
let open: Text | null = null;
let panels: ReturnType<typeof setTimeout> | undefined;
let calculation: ReturnType<typeof setTimeout> | undefined;
let reading: ReturnType<typeof setTimeout> | undefined;

/** Texts as their files have them: a long one is not put together each time it is asked for. */
const files = new WeakMap<EditorState["doc"], string>();

function fileText({ state: { doc }, ends }: Text): string {
  const known = files.get(doc) ?? fromEditor(doc.toString(), ends);
  files.set(doc, known);
  return known;
}

/** The text of the open program as its file has it; null when none is open. */
export const sessionText = (): string | null => (open ? fileText(open) : null);

/** Hands the text to keeping and calculation now. */
export function handOverText(): void {
  clearTimeout(calculation);
  calculation = undefined;
  const { program, work } = useEditor.getState();
  if (!open || !program || open.work !== work) return;
  const text = fileText(open);
  if (program.text !== text) setProgram({ ...program, text });
}

/** Goes one step through the history of a text, in its editor when it is open. */
function go(text: Text, command: StateCommand): boolean {
  if (texts.get(text.work) !== text || useEditor.getState().work !== text.work) return false;
  if (view && open === text) return command(view);
  const { program } = useEditor.getState();
  const done = command({ state: text.state, dispatch: (tr) => (text.state = tr.state) });
  if (done && program) setProgram({ ...program, text: fileText(text) });
  return done;
}

/** Notes what was typed as a step of the page's history, where the text's own begins a new one. */
function noteTyping(text: Text, before: EditorState): void {
  const more = undoDepth(text.state) > undoDepth(before);
  if (more) note({ of: text, back: () => go(text, undo), forth: () => go(text, redo) });
}

function show(opened: boolean): void {
  clearTimeout(panels);
  panels = undefined;
  if (!view) return;
  const { state } = view;
  const before = useSession.getState();
  const next = { reading: state.field(readingField), index: cursorBlock(state), parameter: parameterAt(state, state.selection.main.head) };
  if (before.reading === next.reading && before.index === next.index && before.parameter === next.parameter) return;
  const moved = opened && (before.index !== next.index || before.parameter !== next.parameter);
  useSession.setState({ ...next, opened: before.opened + (moved ? 1 : 0) });
}

function onUpdate(update: ViewUpdate): void {
  if (open) open.state = update.state;
  if (update.docChanged) {
    const long = update.state.field(readingField).program.blocks.length > LONG;
    const rest = long ? LONG_REST : REST;
    if (long) typingGoesOn();
    clearTimeout(calculation);
    calculation = setTimeout(handOverText, rest);
    if (open && !update.transactions.some((tr) => tr.isUserEvent("undo") || tr.isUserEvent("redo"))) noteTyping(open, update.startState);
  }
  const more = update.state.field(readingField) !== update.startState.field(readingField);
  if (!more && !update.selectionSet) return;
  const typed = update.docChanged && update.transactions.some((tr) => tr.isUserEvent("input.type") || tr.isUserEvent("delete"));
  const byDialog = update.transactions.some((tr) => tr.annotation(dialogEdit));
  if (typed && !byDialog) {
    clearTimeout(panels);
    panels = setTimeout(() => show(true), PANELS_REST);
  } else show(!byDialog);
  if (update.transactions.some((tr) => tr.isUserEvent("select.pointer"))) useSession.setState((s) => ({ pointed: s.pointed + 1 }));
}

/** The text of a program, with the history it has when it was open before and is still the same. */
function textOf({ text }: ProgramWork, work: string): Text {
  const held = texts.get(work);
  if (held && fileText(held) === text) return held;
  const ends = lineEndsOf(text);
  const extensions = [editorExtensions(ends === "mixed"), EditorView.updateListener.of(onUpdate)];
  return { work, ends, state: EditorState.create({ doc: toEditor(text, ends), extensions }) };
}

/** Reads a long text to its end, piece by piece, so that the page answers in between. */
function readToEnd(): void {
  clearTimeout(reading);
  if (!view || isRead(view.state)) return;
  reading = setTimeout(() => {
    view?.dispatch(readFurther);
    readToEnd();
  });
}

/** Opens a program in an editor; what was open before is left. */
export function openSession(program: ProgramWork, work: string): EditorView {
  closeSession();
  open = textOf(program, work);
  texts.delete(work);
  texts.set(work, open);
  for (const [oldest] of texts) if (texts.size > HELD) texts.delete(oldest);
  view = new EditorView({ state: open.state });
  show(true);
  readToEnd();
  return view;
}

export function closeSession(): void {
  if (!view) return;
  handOverText();
  clearTimeout(panels);
  clearTimeout(reading);
  view.destroy();
  view = null;
  open = null;
  useSession.setState(none);
}

export const sessionView = (): EditorView | null => view;

/** Makes a change of the text by a dialog. Changes at the same place, one after the other, are one step of undo. */
export function dispatchEdit(spec: TransactionSpec, place: string | null): void {
  if (!view) return;
  const on = goesOn(place);
  view.dispatch({
    ...spec,
    annotations: [dialogEdit.of(true), ...(on ? [] : [isolateHistory.of("before")])],
    // The history joins what goes on with a composition to its step, however long it takes.
    userEvent: on ? "input.type.compose" : "input.dialog",
  });
}

/** Puts a changed program in place of the open one, as one step of undo; only what differs changes in the text. */
export function editProgram(next: Program, place: string | null, openIndex: number | null = null): void {
  if (!view) return;
  const changes = changesBetween(view.state.field(readingField).program, next);
  if (changes.length > 0) dispatchEdit({ changes: [...changes] }, place);
  if (openIndex !== null) openBlock(openIndex);
}

/** Opens a block: the cursor goes there, and the text shows it. */
export function openBlock(index: number, parameter: string | null = null, byDialog = false): void {
  if (!view) return;
  const range = blockRange(view.state, index);
  if (!range) return;
  let at = range.from;
  if (parameter !== null) {
    const line = new RegExp(String.raw`(?:^|[\r\n])[^\S\r\n]*(${parameter})\s*[=+\-\d]`, "i").exec(
      view.state.sliceDoc(range.from, range.to),
    );
    if (line) at = range.from + line.index + line[0].search(/Q/i);
  }
  view.dispatch({
    selection: { anchor: at },
    effects: EditorView.scrollIntoView(at, { y: "nearest", yMargin: 60 }),
    ...(byDialog && { annotations: dialogEdit.of(true) }),
  });
}
