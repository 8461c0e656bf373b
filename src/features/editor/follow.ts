import type { StateEffect } from "@codemirror/state";
import { EditorView } from "@codemirror/view";
import { shownBlock } from "../../app/pictures/plane/shown-view.ts";
import { useOutcome } from "../../app/calculation/outcome.ts";
import { showSection, usePlace } from "../../app/place/place.ts";
import type { Playback } from "../../view/playback.ts";
import { playback } from "../../app/calculation/playback.ts";
import { lengthsOf } from "../../app/calculation/lengths.ts";
import { texts } from "../../app/base/settings/loaded-texts.ts";
import { useSettings } from "../../app/base/settings/settings.ts";
import { setRunning } from "../../app/fields/blocks/block-marks.ts";
import { chooseOpenBlock, followOpenBlock } from "../../app/fields/blocks/choose-block.ts";
import { diagnosticsOf } from "./diagnostics.ts";
import { inWords } from "../../app/fields/blocks/editor-extensions.ts";
import { openPrompts } from "../../app/fields/blocks/open-block.ts";
import { isInTextArea } from "../../app/fields/find/text-bar.ts";
import { blockRange } from "../../app/fields/blocks/reading-field.ts";
import { thirdColumn } from "../../app/base/use-media.ts";
import { isUpToDate } from "../../app/fields/blocks/up-to-date.ts";
import { dispatchEdit, followShown, openBlock, sessionView, useSession } from "../../app/fields/blocks/session.ts";
import { findingsShown } from "../../app/document/shown-findings.ts";
import { shownOtherFile } from "../../app/document/shown-file.ts";

/** Guards against circular updates: which side leads the current change. */
interface Leading {
  /** The cursor opened the prompt: the cursor stays where it is. */
  cursor: boolean;
  /** The tool follows the text. */
  text: boolean;
}

/** Opens the prompt at the cursor, or the first one, if the open block has prompts. */
function showAskedPrompt(leads: Leading): void {
  const prompts = openPrompts();
  if (!prompts) return;
  const { ids, draft } = prompts;
  const { parameter } = useSession.getState();
  const q = parameter !== null && ids.includes(parameter) ? parameter : ids[0];
  if (q === undefined) return;
  leads.cursor = (sessionView()?.hasFocus ?? false) || isInTextArea();
  usePlace.setState({ prompt: q, before: draft[q] ?? "", field: null });
  leads.cursor = false;
}

function followSession(leads: Leading): () => void {
  return useSession.subscribe((now, before) => {
    if (now.pointed !== before.pointed && thirdColumn()) showSection("block");
    if (now.opened !== before.opened) showAskedPrompt(leads);
    // Pointing at a block again selects it again. The tool goes to the block, and the text does not scroll while it is
    // edited.
    leads.text = true;
    if (now.opened !== before.opened || now.pointed !== before.pointed) chooseOpenBlock();
    leads.text = false;
  });
}

/** The text follows the prompts. */
function followPrompt(leads: Leading): () => void {
  return usePlace.subscribe((now, before) => {
    if (leads.cursor) return;
    const { index, parameter } = useSession.getState();
    if (now.prompt !== before.prompt && now.prompt !== null && now.prompt !== parameter && openPrompts())
      openBlock(index, now.prompt, true);
  });
}

function showDiagnostics(): void {
  const view = sessionView();
  const { newest } = useOutcome.getState();
  if (!view || !isUpToDate(newest)) return;
  const { language } = useSettings.getState();
  view.dispatch(
    diagnosticsOf(
      view,
      findingsShown(newest.run.issues, shownOtherFile()?.name ?? null),
      texts(language),
      lengthsOf(language, newest.run.program.unit),
      (spec) => dispatchEdit(spec, null),
    ),
  );
}

function followOutcome(): () => void {
  return useOutcome.subscribe((now, before) => {
    if (now.newest === before.newest) return;
    showDiagnostics();
    followOpenBlock();
  });
}

function followLanguage(): () => void {
  const put = () => {
    const { language } = useSettings.getState();
    sessionView()?.dispatch({ effects: inWords(texts(language), language) });
    showDiagnostics();
  };
  put();
  const stops = [
    useSettings.subscribe((now, before) => {
      if (now.language !== before.language) put();
    }),
    useSession.subscribe((now, before) => {
      if (now.put !== before.put) put();
    }),
  ];
  return () => {
    for (const stop of stops) stop();
  };
}

/**
 * Index of the block of the current move, at the start of the first move; null if the text has changed since, and in
 * the text of a called program, since a move knows only the calling block.
 */
function blockNow(): number | null {
  const { pictured: shown } = useOutcome.getState();
  return shownOtherFile() || !isUpToDate(shown) ? null : shownBlock(shown.run, playback.get().position.step);
}

const isAtStart = ({ position }: Playback): boolean => position.step === 0 && position.fraction === 0;

/** Space above a block that was scrolled to, pixels. */
const SCROLL_MARGIN = 60;

/** Scrolls to a block out of sight, by a page at a time: scrolling with each block would cost a layout each time. */
function scrollEffects(view: EditorView, from: number): readonly StateEffect<unknown>[] {
  const { top, bottom } = view.lineBlockAt(from),
    { scrollTop, clientHeight } = view.scrollDOM;
  return top >= scrollTop && bottom <= scrollTop + clientHeight
    ? []
    : [EditorView.scrollIntoView(from, { y: "start", yMargin: SCROLL_MARGIN })];
}

/** Whether the user moved the playback: a new run moves it too, and must not scroll the text. */
const isMoved = (now: Playback, before: Playback): boolean =>
  now.track === before.track && (now.playing !== before.playing || (!now.playing && now.position !== before.position));

/**
 * Marks the running block and scrolls to it: during playback as blocks begin, and at once on seek, step or Play. Cursor
 * and focus stay.
 */
function followPlayback(leads: Leading): () => void {
  let marked: number | null = null,
    last = playback.get();
  return playback.subscribeReader(() => {
    const view = sessionView(),
      before = last,
      now = playback.get();
    last = now;
    const block = blockNow(),
      next = isAtStart(now) ? null : block,
      moved = isMoved(now, before) && !leads.text;
    // An edit removes the mark; the next run restores it.
    const isMarked = next === marked && (next === null || now.track === before.track);
    if (!view || (isMarked && !moved)) return;
    marked = next;
    const range = block !== null && (moved || now.playing) ? blockRange(view.state, block) : null;
    view.dispatch({ effects: [setRunning.of(next), ...(range ? scrollEffects(view, range.from) : [])] });
  });
}

/** Keeps text, dialog, marks and playback of the open program in step, until the returned function is called. */
export function followProgram(): () => void {
  const leads: Leading = { cursor: false, text: false };
  const stops = [
    followShown(),
    followSession(leads),
    followPrompt(leads),
    followOutcome(),
    followLanguage(),
    followPlayback(leads),
  ];
  showAskedPrompt(leads);
  return () => {
    for (const stop of stops) stop();
  };
}
