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
import { blockRange } from "../../app/fields/blocks/reading-field.ts";
import { thirdColumn } from "../../app/base/use-media.ts";
import { isPresent } from "../../app/fields/blocks/present.ts";
import { dispatchEdit, followShown, openBlock, sessionView, useSession } from "../../app/fields/blocks/session.ts";
import { findingsShown } from "../../app/document/shown-findings.ts";
import { shownBeside } from "../../app/document/shown-file.ts";

/** Who leads while one follows the other. */
interface Leading {
  /** A prompt is opened because the cursor stands at its block: the cursor stays where it is typed on. */
  cursor: boolean;
  /** The tool goes where the text says. */
  text: boolean;
}

/** Opens the prompt that the cursor stands at, or the first one, where the open block has prompts. */
function showAskedPrompt(leads: Leading): void {
  const prompts = openPrompts();
  if (!prompts) return;
  const { ids, draft } = prompts;
  const { parameter } = useSession.getState();
  const q = parameter !== null && ids.includes(parameter) ? parameter : ids[0];
  if (q === undefined) return;
  leads.cursor = sessionView()?.hasFocus ?? false;
  usePlace.setState({ prompt: q, before: draft[q] ?? "", field: null });
  leads.cursor = false;
}

function followSession(leads: Leading): () => void {
  return useSession.subscribe((now, before) => {
    if (now.pointed !== before.pointed && thirdColumn()) showSection("block");
    if (now.opened !== before.opened) showAskedPrompt(leads);
    // What is pointed at once more is chosen once more. The tool goes to the block, and the text stays where it is
    // worked on.
    leads.text = true;
    if (now.opened !== before.opened || now.pointed !== before.pointed) chooseOpenBlock();
    leads.text = false;
  });
}

/** The text goes along with the prompts. */
function followPrompt(leads: Leading): () => void {
  return usePlace.subscribe((now, before) => {
    if (leads.cursor) return;
    const { index, parameter } = useSession.getState();
    if (now.prompt !== before.prompt && now.prompt !== null && now.prompt !== parameter && openPrompts())
      openBlock(index, now.prompt, true);
  });
}

function mark(): void {
  const view = sessionView();
  const { newest } = useOutcome.getState();
  if (!view || !isPresent(newest)) return;
  const { language } = useSettings.getState();
  view.dispatch(
    diagnosticsOf(
      view,
      findingsShown(newest.run.issues, shownBeside()?.name ?? null),
      texts(language),
      lengthsOf(language, newest.run.program.unit),
      (spec) => dispatchEdit(spec, null),
    ),
  );
}

function followOutcome(): () => void {
  return useOutcome.subscribe((now, before) => {
    if (now.newest === before.newest) return;
    mark();
    followOpenBlock();
  });
}

function followLanguage(): () => void {
  const put = () => {
    const { language } = useSettings.getState();
    sessionView()?.dispatch({ effects: inWords(texts(language), language) });
    mark();
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
 * Index of the block whose move stands at the playback's position, at the start that of the first move; null where the
 * text has changed since, and in the text of a called program: a move knows the block of the program that called.
 */
function blockNow(): number | null {
  const { pictured: shown } = useOutcome.getState();
  return shownBeside() || !isPresent(shown) ? null : shownBlock(shown.run, playback.get().position.step);
}

const isAtStart = ({ position }: Playback): boolean => position.step === 0 && position.fraction === 0;

/** Pixels over a block that the text was turned to. */
const OVER = 60;

/**
 * Turns the text to a block that is out of sight, as one turns a page: scrolling with each block would lay it out with
 * each.
 */
function turnedTo(view: EditorView, from: number): readonly StateEffect<unknown>[] {
  const { top, bottom } = view.lineBlockAt(from),
    { scrollTop, clientHeight } = view.scrollDOM;
  return top >= scrollTop && bottom <= scrollTop + clientHeight
    ? []
    : [EditorView.scrollIntoView(from, { y: "start", yMargin: OVER })];
}

/**
 * What of a playback says whether somebody moved it: another run in its place moves it too, and nobody asked for that.
 */
const isMoved = (now: Playback, before: Playback): boolean =>
  now.track === before.track && (now.playing !== before.playing || (!now.playing && now.position !== before.position));

/**
 * Marks the running block, and turns the text to it: while it plays as blocks begin, and at once where somebody seeks,
 * steps, or presses Play. Neither the cursor nor the keyboard goes along.
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
    // A text that was typed in has lost its mark: it gets it back with the next run.
    const isMarked = next === marked && (next === null || now.track === before.track);
    if (!view || (isMarked && !moved)) return;
    marked = next;
    const range = block !== null && (moved || now.playing) ? blockRange(view.state, block) : null;
    view.dispatch({ effects: [setRunning.of(next), ...(range ? turnedTo(view, range.from) : [])] });
  });
}

/** From now on text, dialog, marks and animation of the open program go together. */
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
