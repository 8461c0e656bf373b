import { isolateHistory, redo, redoDepth, undo, undoDepth } from "@codemirror/commands";
import { EditorState, type TransactionSpec } from "@codemirror/state";
import { EditorView, type ViewUpdate } from "@codemirror/view";
import { create } from "zustand";
import { readingOf, type Reading } from "../../nc/reread.ts";
import type { Program } from "../../nc/program.ts";
import { typingGoesOn } from "../engine/quiet.ts";
import { noHistory, useProgramHistory } from "../program-history.ts";
import { closeStep, goesOn, setProgram, useEditor } from "../store.ts";
import type { ProgramWork } from "../work.ts";
import { changesBetween } from "./block-edits.ts";
import { dialogEdit } from "./dialog-edit.ts";
import { editorExtensions } from "./editor-extensions.ts";
import { fromEditor, lineEndsOf, toEditor, type LineEnds } from "./line-ends.ts";
import { blockRange, cursorBlock, parameterAt, readingField } from "./reading-field.ts";

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

let view: EditorView | null = null;
let open: { readonly program: ProgramWork; readonly ends: LineEnds } | null = null;
let panels: ReturnType<typeof setTimeout> | undefined;
let calculation: ReturnType<typeof setTimeout> | undefined;

/** The text of the open program as its file has it; null when none is open. */
export const sessionText = (): string | null => (view && open ? fromEditor(view.state.doc.toString(), open.ends) : null);

/** Hands the text to keeping and calculation now. */
export function handOverText(): void {
  clearTimeout(calculation);
  calculation = undefined;
  const text = sessionText();
  const { program } = useEditor.getState();
  if (text !== null && program && program.text !== text) setProgram({ ...program, text });
}

function showHistory(state: EditorState): void {
  const [past, future] = [undoDepth(state) > 0, redoDepth(state) > 0];
  const shown = useProgramHistory.getState();
  if (shown.past !== past || shown.future !== future) useProgramHistory.setState({ past, future });
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
  if (update.docChanged) {
    const long = update.state.field(readingField).program.blocks.length > LONG;
    const rest = long ? LONG_REST : REST;
    if (long) typingGoesOn();
    clearTimeout(calculation);
    calculation = setTimeout(handOverText, rest);
    showHistory(update.state);
  }
  if (!update.docChanged && !update.selectionSet) return;
  const typed = update.docChanged && update.transactions.some((tr) => tr.isUserEvent("input.type") || tr.isUserEvent("delete"));
  const byDialog = update.transactions.some((tr) => tr.annotation(dialogEdit));
  if (typed && !byDialog) {
    clearTimeout(panels);
    panels = setTimeout(() => show(true), PANELS_REST);
  } else show(!byDialog);
  if (update.transactions.some((tr) => tr.isUserEvent("select.pointer"))) useSession.setState((s) => ({ pointed: s.pointed + 1 }));
}

/** Opens a program in a new editor; what was open before is let go. */
export function openSession(program: ProgramWork): EditorView {
  closeSession();
  const ends = lineEndsOf(program.text);
  open = { program, ends };
  view = new EditorView({
    state: EditorState.create({
      doc: toEditor(program.text, ends),
      extensions: [editorExtensions(ends === "mixed"), EditorView.updateListener.of(onUpdate)],
    }),
  });
  const run = (command: typeof undo) => () => {
    closeStep();
    if (view) command(view);
  };
  useProgramHistory.setState({ past: false, future: false, undo: run(undo), redo: run(redo) });
  show(true);
  return view;
}

export function closeSession(): void {
  if (!view) return;
  handOverText();
  clearTimeout(panels);
  view.destroy();
  view = null;
  open = null;
  useProgramHistory.setState(noHistory);
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
